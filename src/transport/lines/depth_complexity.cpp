#include "transport/lines/depth_complexity.h"

#include "geometry/intersector/intersector.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace multipath {

double crossings_per_line(const Scene& scene, const GlobalLines& lines)
{
    const double area = scene.total_area() / (scene.two_sided() ? 2.0 : 1.0); // of surfaces, not of their sides
    return lines.expected_crossings(area, 1);                                 // (G1)
}

double pairs_along_line(const Scene& scene, const GlobalLines& lines)
{
    constexpr std::size_t trials = 256;
    std::vector<Item> items(trials);
    make_sequence("random", 1)->generate(0, items);
    double pairs = 0.0;
    std::vector<Hit> hits;
    for (const Item& item : items) {
        scene.intersector().all_hits(lines.line(item), hits);
        const auto count = static_cast<double>(hits.size());
        pairs += 0.5 * count * (count - 1.0);
    }
    return std::max(0.0, pairs) / trials;
}

std::uint64_t affordable_lines(const Scene& scene, std::uint64_t wanted)
{
    const double pairs = pairs_along_line(scene, GlobalLines(scene.bounds()));
    const double share = std::min(1.0, many_pairs_along_line / pairs);
    return static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(wanted)));
}

} // namespace multipath

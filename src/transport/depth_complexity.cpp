#include "transport/depth_complexity.h"

#include "sampling/radical_inverse.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace multipath {

double crossings_per_line(const Scene& scene, const GlobalLines& lines)
{
    const double area = scene.total_area() / (scene.two_sided() ? 2.0 : 1.0); // a crossing is one, whatever the sides
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

namespace {

constexpr double ordinary_surfaces = 16.0; ///< along a line, or on each other

/// Mean number of other surfaces that share a point of a source and its plane, weighted by power; at a few points.
double faces_on_sources(const Scene& scene)
{
    std::vector<std::uint32_t> sources;
    std::vector<double> power_up_to; // [W] cumulative
    double power = 0.0;
    for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s) {
        const double own = scene.surfaces()[s].area() * mean(scene.surface_material(s).emittance);
        if (own > 0.0) {
            sources.push_back(s);
            power_up_to.push_back(power += own);
        }
    }
    if (sources.empty())
        return 0.0;
    constexpr std::uint64_t trials = 64;
    std::size_t faces = 0;
    for (std::uint64_t k = 0; k < trials; ++k) {
        const double at = (static_cast<double>(k) + 0.5) / trials * power;
        const auto found = std::upper_bound(power_up_to.begin(), power_up_to.end() - 1, at) - power_up_to.begin();
        const std::uint32_t source = sources[static_cast<std::size_t>(found)];
        const Surface& shape = scene.surfaces()[source];
        double u = radical_inverse(2, k + 1);
        double v = radical_inverse(3, k + 1);
        if (shape.shape == Shape::triangle && u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        faces += scene.intersector().coincident_surfaces(source, shape.at(u, v)).size();
    }
    return static_cast<double>(faces) / trials;
}

} // namespace

double affordable_lines(const Scene& scene)
{
    const double along = crossings_per_line(scene, GlobalLines(scene.bounds()));
    return ordinary_surfaces / std::max(along, ordinary_surfaces);
}

double affordable_source_rays(const Scene& scene)
{
    return ordinary_surfaces / std::max(faces_on_sources(scene), ordinary_surfaces);
}

} // namespace multipath

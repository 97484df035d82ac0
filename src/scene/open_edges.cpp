#include "scene/open_edges.h"

#include "scene/vertex_weld.h"

#include <algorithm>
#include <array>
#include <utility>

namespace multipath {

namespace {

/// Corners in the direction of the border; a triangle's first corner closes it twice.
std::array<Vec3, 4> corners(const Surface& s)
{
    const Vec3 third = s.shape == Shape::triangle ? s.at(0.0, 1.0) : s.at(1.0, 1.0);
    return {s.origin, s.at(1.0, 0.0), third, s.shape == Shape::triangle ? s.origin : s.at(0.0, 1.0)};
}

} // namespace

std::vector<std::uint32_t> surfaces_with_open_edges(const std::vector<Surface>& surfaces)
{
    std::vector<Vec3> points;
    for (const Surface& surface : surfaces)
        for (const Vec3 corner : corners(surface))
            points.push_back(corner);
    const std::vector<std::uint32_t> welded = weld(points);

    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    const auto edge = [&](std::size_t surface, std::size_t i) {
        return Edge{welded[4 * surface + i], welded[4 * surface + (i + 1) % 4]};
    };
    std::vector<Edge> edges;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        for (std::size_t i = 0; i < 4; ++i)
            edges.push_back(edge(s, i));
    std::sort(edges.begin(), edges.end());

    std::vector<std::uint32_t> open;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        for (std::size_t i = 0; i < 4; ++i) {
            const auto [from, to] = edge(s, i);
            if (from != to && !std::binary_search(edges.begin(), edges.end(), Edge{to, from})) {
                open.push_back(static_cast<std::uint32_t>(s));
                break;
            }
        }
    return open;
}

} // namespace multipath

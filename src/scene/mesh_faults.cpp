// Coincident faces are searched for at sample points of each surface: a point that lies on another surface, too, shows
// an overlap. To find open edges, all directed edges, given by welded corners, are sorted, and the reverse of each edge
// is searched for.

#include "scene/mesh_faults.h"

#include "geometry/intersector/intersector.h"
#include "geometry/intersector/surface_sizes.h"
#include "scene/vertex_weld.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace multipath {

namespace {

/// Sample points inside a surface: 16 find an overlap of a tenth of its area unless it is narrow. A single one in a
/// scene of more than 100,000 surfaces.
std::vector<Vec3> sample_points(const Surface& surface, std::size_t surface_count)
{
    const int n = surface_count > 100000 ? 1 : 4;
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double u = (i + 0.5) / n;
            const double v = (j + 0.5) / n;
            const bool folded = surface.shape == Shape::triangle && u + v >= 1.0;
            points.push_back(folded ? surface.at(0.9 * (1.0 - u) + 0.03, 0.9 * (1.0 - v) + 0.03) : surface.at(u, v));
        }
    return points;
}

/// Returns k if every k-th surface is to be searched. k is 1 unless the sample points lie in the boxes of so many other
/// surfaces, such as slivers with a common corner, that a complete search would take minutes.
std::size_t surfaces_per_search(const Scene& scene)
{
    constexpr std::size_t trials = 64;
    constexpr double bearable = 1u << 28; // surfaces tested; about a second
    const SurfaceList& surfaces = scene.surfaces();
    double looked_at = 0.0;
    for (std::size_t k = 0; k < trials; ++k) {
        const auto s = static_cast<std::uint32_t>(k * surfaces.size() / trials);
        for (const Vec3 point : sample_points(surfaces[s], surfaces.size()))
            looked_at += static_cast<double>(scene.intersector().surfaces_around(s, point));
    }
    return static_cast<std::size_t>(1.0 + looked_at / trials * static_cast<double>(surfaces.size()) / bearable);
}

} // namespace

CoincidentPairs find_coincident_faces(const Scene& scene, std::size_t most)
{
    CoincidentPairs result;
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    const SurfaceList& surfaces = scene.surfaces();
    const std::size_t step = surfaces_per_search(scene);
    result.complete = step == 1;
    for (std::size_t k = 0; k < surfaces.size(); k += step) {
        const auto s = static_cast<std::uint32_t>(k);
        for (const Vec3 point : sample_points(surfaces[s], surfaces.size()))
            for (const std::uint32_t other : scene.intersector().coincident_surfaces(s, point)) {
                if (pairs.size() < most)
                    pairs.insert(std::minmax(s, other));
                else
                    result.complete = result.complete && pairs.count(std::minmax(s, other)) > 0;
            }
        if (!result.complete && pairs.size() >= most)
            break;
    }
    for (const auto& [first, second] : pairs)
        result.pairs.push_back({first, second, dot(surfaces[first].normal(), surfaces[second].normal()) > 0.0});
    return result;
}

namespace {

/// Corners in counter-clockwise order; the fourth corner of a triangle is the first again.
std::array<Vec3, 4> corners(const Surface& s)
{
    const Vec3 third = s.shape == Shape::triangle ? s.at(0.0, 1.0) : s.at(1.0, 1.0);
    return {s.origin, s.at(1.0, 0.0), third, s.shape == Shape::triangle ? s.origin : s.at(0.0, 1.0)};
}

} // namespace

std::vector<std::uint32_t> surfaces_with_open_edges(const SurfaceList& surfaces)
{
    const Bounds bounds = bounds_of(surfaces);
    LargeVector<Vec3> points;
    for (const Surface& surface : surfaces)
        for (const Vec3 corner : corners(surface))
            points.push_back(snapped(corner, bounds));
    const LargeVector<std::uint32_t> welded = weld(points);

    using Edge = std::pair<std::uint32_t, std::uint32_t>;
    const auto edge = [&](std::size_t surface, std::size_t i) {
        return Edge{welded[4 * surface + i], welded[4 * surface + (i + 1) % 4]};
    };
    LargeVector<Edge> edges;
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

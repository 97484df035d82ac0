#include "scene/coincident_faces.h"

#include <algorithm>
#include <set>
#include <utility>

namespace multipath {

namespace {

/// Points inside of a surface: enough of them to find what covers a tenth of it, unless that is narrow; one in a large
/// scene.
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

} // namespace

std::vector<CoincidentFaces> find_coincident_faces(const Scene& scene, std::size_t most)
{
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    const std::vector<Surface>& surfaces = scene.surfaces();
    for (std::uint32_t s = 0; s < surfaces.size() && pairs.size() < most; ++s)
        for (const Vec3 point : sample_points(surfaces[s], surfaces.size()))
            for (const std::uint32_t other : scene.intersector().coincident_surfaces(s, point))
                if (pairs.size() < most)
                    pairs.insert(std::minmax(s, other));

    std::vector<CoincidentFaces> result;
    for (const auto& [first, second] : pairs)
        result.push_back({first, second, dot(surfaces[first].normal(), surfaces[second].normal()) > 0.0});
    return result;
}

} // namespace multipath

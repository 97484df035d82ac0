#pragma once

#include "test_scenes.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <sstream>
#include <string>
#include <vector>

namespace multipath {

/// A wall beside two walls, all cut into pieces of up to 1: 4 patches on the one side of the corner, 2 + 3 on the
/// other; and a triangle on top that is cut by its longest edge. A lamp far away.
inline SceneBuilder walls_that_do_not_match()
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, paint);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1.5, 0, 0}, paint);
    builder.rectangle({1.5, 0, 0}, {0, 0, 1}, {2.5, 0, 0}, builder.material({0.8, 0.1, 0.2}, {}));
    builder.triangle({0, 3, 0}, {4, 3, 0}, {2, 3, 5}, paint);
    builder.triangle({4, 3, 0}, {6, 3, 1}, {3.1, 3, 2.25}, paint);
    return builder.rectangle({0, 50, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 1.0));
}

/// A scene that is made larger and then moved.
struct Placement
{
    double scale = 1.0;
    Vec3 shift;

    SceneFile moved(SceneFile file) const
    {
        for (Surface& surface : file.surfaces)
            surface = {surface.shape, scale * surface.origin + shift, scale * surface.edge_u, scale * surface.edge_v};
        return file;
    }
    Vec3 back(Vec3 p) const { return (1.0 / scale) * (p - shift); }
};

/// In the coordinates of maps, in all directions, and very small and large ones.
inline std::vector<Placement> far_and_other_sizes()
{
    return {{1.0, {500000, 120, 4649776}},
            {1.0, {-9e6, 8.0123e6, -1e7}},
            {1.0, {0, 0, 1e9}},
            {1.0, {160, -170, 40}},
            {1e-4, {}},
            {1e-4, {-3.3, 2, 1e3}},
            {1e7, {3e7, 0, -1e7}},
            {1e5, {1e8, -1e8, 3e7}}};
}

/// How far points are from those of the unmoved scene [share of its size], which are given in the same order.
inline double largest_miss(const std::vector<Vec3>& moved, const Placement& placement,
                           const std::vector<Vec3>& expected, const Scene& unmoved)
{
    REQUIRE(moved.size() == expected.size());
    double largest = 0.0;
    for (std::size_t n = 0; n < moved.size(); ++n)
        largest = std::max(largest, length(placement.back(moved[n]) - expected[n]));
    return largest / unmoved.own_bounds().diagonal();
}

/// The positions in an OBJ.
inline std::vector<Vec3> obj_positions(const std::string& text)
{
    std::vector<Vec3> points;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (std::istringstream words(line.compare(0, 2, "v ") == 0 ? line.substr(2) : ""); !words.str().empty()) {
            Vec3 p;
            words >> p.x >> p.y >> p.z;
            points.push_back(p);
        }
    return points;
}

/// Different values on all patches.
inline std::vector<Rgb> some_values(const Scene& scene)
{
    std::vector<Rgb> values;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        values.push_back({0.25 + 0.01 * (i * i % 37), 0.5 + 0.02 * (i * 7 % 11), 0.125 * (1 + i % 5)});
    return values;
}

} // namespace multipath

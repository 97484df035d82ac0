#include "bench_scenes.h"

#include "sampling/random.h"
#include "scene/tessellation.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr Shape parallelogram = Shape::parallelogram;

/// The six sides of a box that stands on `corner`, spanned by two horizontal edges and a height, seen from outside.
void add_box(Vec3 corner, Vec3 a, Vec3 b, double height, SurfaceList& surfaces)
{
    const Vec3 up = {0.0, height, 0.0};
    for (const Surface& side : {Surface{parallelogram, corner, a, b}, Surface{parallelogram, corner + up, b, a},
                                Surface{parallelogram, corner, up, a}, Surface{parallelogram, corner, b, up},
                                Surface{parallelogram, corner + a, up, b}, Surface{parallelogram, corner + b, a, up}})
        surfaces.push_back(side);
}

void add_room(Vec3 size, SurfaceList& surfaces)
{
    const Vec3 x = {size.x, 0, 0};
    const Vec3 y = {0, size.y, 0};
    const Vec3 z = {0, 0, size.z};
    for (const Surface& wall :
         {Surface{parallelogram, {}, z, x}, Surface{parallelogram, y, x, z}, Surface{parallelogram, {}, y, z},
          Surface{parallelogram, x, z, y}, Surface{parallelogram, {}, x, y}, Surface{parallelogram, z, y, x}})
        surfaces.push_back(wall);
}

} // namespace

SurfaceList room_with_boxes(int boxes)
{
    SurfaceList surfaces = {{parallelogram, {1.2, 2.9, 1.2}, {0.6, 0, 0}, {0, 0, 0.6}}}; // looks down
    add_room({3, 3, 3}, surfaces);
    const int along = static_cast<int>(std::ceil(std::cbrt(static_cast<double>(boxes))));
    const double cell = 2.6 / along;
    const double edge = 0.55 * cell; // less than cell / sqrt(2): boxes do not touch, however they are turned
    for (int k = 0; k < boxes; ++k) {
        const double angle = 0.3 + 0.7 * k;
        const Vec3 a = {edge * std::cos(angle), 0, -edge * std::sin(angle)};
        const Vec3 b = {edge * std::sin(angle), 0, edge * std::cos(angle)};
        const Vec3 centre = {0.2 + (k % along + 0.5) * cell, 0.1 + k / (along * along) * cell,
                             0.2 + (k / along % along + 0.5) * cell};
        add_box(centre - 0.5 * (a + b), a, b, edge, surfaces);
    }
    return surfaces;
}

SurfaceList triangle_soup(std::size_t count, double size)
{
    SurfaceList surfaces;
    std::uint64_t counter = 0;
    const auto number = [&](double low, double high) {
        return low + (high - low) * bits_to_unit(random_bits(5, counter++));
    };
    const auto vector = [&](double low, double high) {
        const double x = number(low, high);
        const double y = number(low, high);
        return Vec3{x, y, number(low, high)};
    };
    while (surfaces.size() < count) {
        const Vec3 origin = vector(0.0, 1.0);
        const Vec3 edge_u = vector(-size, size);
        const Surface triangle = {Shape::triangle, origin, edge_u, vector(-size, size)};
        if (triangle.area() > 0.01 * size * size)
            surfaces.push_back(triangle);
    }
    return surfaces;
}

SurfaceList as_triangles(const SurfaceList& surfaces, int n)
{
    SurfaceList triangles;
    for (const Surface& s : surfaces)
        if (s.shape == Shape::triangle && n == 1)
            triangles.push_back(s);
        else
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const Vec3 u = (1.0 / n) * s.edge_u;
                    const Vec3 v = (1.0 / n) * s.edge_v;
                    const Vec3 corner = s.origin + static_cast<double>(i) * u + static_cast<double>(j) * v;
                    triangles.push_back({Shape::triangle, corner, u, v});
                    triangles.push_back({Shape::triangle, corner + u + v, -u, -v});
                }
    return triangles;
}

Scene scene_of(const SurfaceList& surfaces, std::uint64_t patches)
{
    SceneFile file;
    file.path = "bench";
    file.surfaces = surfaces;
    file.materials = {{"lamp", {0.2, 0.2, 0.2}, {10, 10, 10}, "bench:1"}, {"grey", {0.6, 0.6, 0.6}, {}, "bench:2"}};
    file.material.assign(surfaces.size(), 1);
    file.material.front() = 0;
    file.group.assign(surfaces.size(), 0);
    file.line.assign(surfaces.size(), 1);
    return Scene(file, patch_size_for_count(surfaces, patches));
}

} // namespace multipath

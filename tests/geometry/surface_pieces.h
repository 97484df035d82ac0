#pragma once

#include "geometry/form_factor/exchange_area.h"

#include <vector>

namespace multipath {

inline Surface rectangle(Vec3 corner, Vec3 u, Vec3 v)
{
    return {Shape::parallelogram, corner, u, v};
}

/// n x n parallelograms, or n^2 triangles.
inline SurfaceList pieces(const Surface& s, int n)
{
    SurfaceList result;
    const double h = 1.0 / n;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            if (s.shape == Shape::parallelogram || i + j < n)
                result.push_back({s.shape, s.at(i * h, j * h), h * s.edge_u, h * s.edge_v});
            if (s.shape == Shape::triangle && i + j < n - 1)
                result.push_back({s.shape, s.at((i + 1) * h, (j + 1) * h), -h * s.edge_u, -h * s.edge_v});
        }
    return result;
}

inline double sum_of_exchanges(const SurfaceList& a, const SurfaceList& b, double touching)
{
    double sum = 0.0;
    for (const Surface& s : a)
        for (const Surface& t : b)
            sum += exchange_area(s, t, touching);
    return sum;
}

/// The same turned and shifted.
inline Surface moved(const Surface& s)
{
    const Vec3 x = normalized({1, 2, -0.5});
    const Vec3 y = normalized(cross(x, {0.3, -1, 2}));
    const Vec3 z = cross(x, y);
    const auto turned = [&](Vec3 p) { return p.x * x + p.y * y + p.z * z; };
    return {s.shape, turned(s.origin) + Vec3{3, -7, 2}, turned(s.edge_u), turned(s.edge_v)};
}

} // namespace multipath

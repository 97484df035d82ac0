#pragma once

#include "geometry/conditions.h"
#include "geometry/hit.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/line.h"
#include "geometry/surface.h"
#include "parallel/memory.h"

#include <array>
#include <cstdint>
#include <vector>

namespace multipath {

/// A surface in the form in which lines are decided against it: a plane for t and two affine functions for (u, v), in
/// columns, so that the three are evaluated side by side; two cache lines in all.
struct alignas(64) SurfaceRow
{
    using Column = std::array<double, 4>; ///< of the normal, of u, of v; the fourth only fills

    Column x, y, z; ///< normal, to_u, to_v; x[3]: number of the plane, which serves no evaluation
    Column offset;  ///< dot(normal, p) = offset[0] in the plane; u = dot(to_u, p) + offset[1]; v likewise
                    ///< offset[3]: 1 for a triangle (u + v <= 1), 0 for a parallelogram (u <= 1, v <= 1)

    double plane() const { return x[3]; } ///< surfaces of one plane have the same number
    Vec3 vector(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Decides in double precision which surfaces a line meets.
class SurfaceTable
{
public:
    SurfaceTable(const SurfaceList& surfaces, const SharedPlanes& planes, int threads = 1);

    std::uint32_t size() const { return static_cast<std::uint32_t>(rows_.size()); }
    const SurfaceRow& row(std::uint32_t surface) const { return rows_[surface]; }
    bool is_triangle(std::uint32_t surface) const { return rows_[surface].offset[3] > 0.0; }

    /// Whether the line meets one surface, borders included, and the hit if it does; else `hit` holds anything, since
    /// there is no branch. The definition that all faster code must reproduce.
    bool decide(const Line& line, std::uint32_t surface, Hit& hit) const;

    /// Whether a point of the plane of the surface lies on it, borders included.
    bool holds(Vec3 point, std::uint32_t surface) const;

private:
    UnsetVector<SurfaceRow> rows_;
};

inline bool SurfaceTable::holds(Vec3 p, std::uint32_t surface) const
{
    const SurfaceRow& row = rows_[surface];
    const double u = row.x[1] * p.x + row.y[1] * p.y + row.z[1] * p.z + row.offset[1];
    const double v = row.x[2] * p.x + row.y[2] * p.y + row.z[2] * p.z + row.offset[2];
    const double k = row.offset[3];
    return every(u >= 0.0, v >= 0.0, (1.0 - u) - k * v >= 0.0, (1.0 - v) - k * u >= 0.0);
}

inline bool SurfaceTable::decide(const Line& line, std::uint32_t surface, Hit& hit) const
{
    const SurfaceRow& row = rows_[surface];
    const Vec3 o = line.origin;
    const Vec3 d = line.direction;
    SurfaceRow::Column at_origin;
    SurfaceRow::Column along;
    for (std::size_t i = 0; i < 4; ++i)
        at_origin[i] = row.x[i] * o.x + row.y[i] * o.y + row.z[i] * o.z;
    for (std::size_t i = 0; i < 4; ++i)
        along[i] = row.x[i] * d.x + row.y[i] * d.y + row.z[i] * d.z;
    const double approach = along[0];
    const double t = (row.offset[0] - at_origin[0]) / approach;
    const double u = (at_origin[1] + row.offset[1]) + t * along[1];
    const double v = (at_origin[2] + row.offset[2]) + t * along[2];
    const double k = row.offset[3];
    hit = {t, surface, u, v, approach < 0.0};
    return every(approach != 0.0, t >= 0.0, t <= line.t_max, u >= 0.0, v >= 0.0, (1.0 - u) - k * v >= 0.0,
                 (1.0 - v) - k * u >= 0.0);
}

} // namespace multipath

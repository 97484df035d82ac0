#pragma once

#include "base/memory.h"
#include "geometry/conditions.h"
#include "geometry/hit.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/line.h"
#include "geometry/surface.h"

#include <array>
#include <cstdint>

namespace multipath {

/// Double-precision form of a surface for intersection tests: its plane, which gives t, and two affine functions of the
/// point, which give u and v. The three functions are stored in columns, so that they are evaluated side by side. A row
/// takes two cache lines.
struct alignas(64) SurfaceRow
{
    using Column = std::array<double, 4>; ///< entries for the plane, u and v; the fourth is padding or extra data

    Column x, y, z; ///< components of the vectors normal, to_u and to_v; x[3] stores the plane number
    Column offset;  ///< dot(normal, p) = offset[0] in the plane; u = dot(to_u, p) + offset[1]; v = dot(to_v, p) +
                    ///< offset[2]; offset[3]: 1 for a triangle (u + v <= 1), 0 for a parallelogram (u <= 1, v <= 1)

    double plane() const { return x[3]; } ///< SharedPlanes::plane_number
    /// The vector normal (i = 0), to_u (1) or to_v (2).
    Vec3 vector(std::size_t i) const { return {x[i], y[i], z[i]}; }
};

/// Double-precision intersection tests. They define which surfaces a line meets.
class SurfaceTable
{
public:
    SurfaceTable() = default;
    /// `planes`: the result of share_planes for these surfaces.
    SurfaceTable(const SurfaceList& surfaces, const SharedPlanes& planes, int threads = 1);

    std::uint32_t size() const { return static_cast<std::uint32_t>(rows_.size()); }
    const SurfaceRow& row(std::uint32_t surface) const { return rows_[surface]; }
    bool is_triangle(std::uint32_t surface) const { return rows_[surface].offset[3] > 0.0; }

    /// True if the line meets the surface at 0 <= t <= t_max, borders included. Writes `hit` in every case, without a
    /// branch; `hit` is meaningless if the result is false. All faster code must reproduce this definition bit for bit.
    bool decide(const Line& line, std::uint32_t surface, Hit& hit) const;

    /// True if a point in the plane of the surface lies on the surface, borders included.
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

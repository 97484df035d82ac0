#include "geometry/surface_table.h"

namespace multipath {

SurfaceTable::SurfaceTable(const std::vector<Surface>& surfaces, const SharedPlanes& planes)
    : size_(static_cast<std::uint32_t>(surfaces.size())), blocks_((surfaces.size() + width - 1) / width)
{
    for (std::uint32_t s = 0; s < size_; ++s) {
        const Surface& surface = surfaces[s];
        const Plane& plane = planes.plane_of_surface[s];
        // Dual basis: dot(to_u, edge_u) = 1, dot(to_u, edge_v) = 0, and the same with u and v exchanged.
        const Vec3 normal = cross(surface.edge_u, surface.edge_v);
        const double scale = 1.0 / dot(normal, normal);
        const Vec3 to_u = scale * cross(surface.edge_v, normal);
        const Vec3 to_v = scale * cross(normal, surface.edge_u);
        Block& block = blocks_[s / width];
        const std::uint32_t i = s % width;
        block.normal_x[i] = plane.normal.x;
        block.normal_y[i] = plane.normal.y;
        block.normal_z[i] = plane.normal.z;
        block.offset[i] = plane.offset;
        block.u_x[i] = to_u.x;
        block.u_y[i] = to_u.y;
        block.u_z[i] = to_u.z;
        block.u_0[i] = -dot(to_u, surface.origin);
        block.v_x[i] = to_v.x;
        block.v_y[i] = to_v.y;
        block.v_z[i] = to_v.z;
        block.v_0[i] = -dot(to_v, surface.origin);
        block.triangle[i] = surface.shape == Shape::triangle ? 1.0 : 0.0;
    }
}

std::optional<Hit> SurfaceTable::hit(const Line& line, std::uint32_t s) const
{
    const Block& b = blocks_[s / width];
    const std::uint32_t i = s % width;
    const Vec3 o = line.origin;
    const Vec3 d = line.direction;
    const double approach = b.normal_x[i] * d.x + b.normal_y[i] * d.y + b.normal_z[i] * d.z;
    if (approach == 0.0)
        return std::nullopt;
    const double t = (b.offset[i] - (b.normal_x[i] * o.x + b.normal_y[i] * o.y + b.normal_z[i] * o.z)) / approach;
    const double u = (b.u_x[i] * o.x + b.u_y[i] * o.y + b.u_z[i] * o.z + b.u_0[i]) +
                     t * (b.u_x[i] * d.x + b.u_y[i] * d.y + b.u_z[i] * d.z);
    const double v = (b.v_x[i] * o.x + b.v_y[i] * o.y + b.v_z[i] * o.z + b.v_0[i]) +
                     t * (b.v_x[i] * d.x + b.v_y[i] * d.y + b.v_z[i] * d.z);
    const double k = b.triangle[i];
    const bool inside =
        t >= 0.0 && t <= line.t_max && u >= 0.0 && v >= 0.0 && (1.0 - u) - k * v >= 0.0 && (1.0 - v) - k * u >= 0.0;
    if (!inside)
        return std::nullopt;
    return Hit{t, s, u, v, approach < 0.0};
}

// The plain test above without its branches, so that the compiler can vectorise the loop: the smallest of the six
// margins is negative for a miss. A NaN (a line parallel to the plane) may pass here; hit() has the last word.
SurfaceTable::Lanes SurfaceTable::margins(const Line& line, const Block& b)
{
    const auto smaller = [](double x, double y) { return y < x ? y : x; };
    const Vec3 o = line.origin;
    const Vec3 d = line.direction;
    const double t_max = line.t_max;
    Lanes result;
    for (std::uint32_t i = 0; i < width; ++i) {
        const double approach = b.normal_x[i] * d.x + b.normal_y[i] * d.y + b.normal_z[i] * d.z;
        const double t = (b.offset[i] - (b.normal_x[i] * o.x + b.normal_y[i] * o.y + b.normal_z[i] * o.z)) / approach;
        const double u = (b.u_x[i] * o.x + b.u_y[i] * o.y + b.u_z[i] * o.z + b.u_0[i]) +
                         t * (b.u_x[i] * d.x + b.u_y[i] * d.y + b.u_z[i] * d.z);
        const double v = (b.v_x[i] * o.x + b.v_y[i] * o.y + b.v_z[i] * o.z + b.v_0[i]) +
                         t * (b.v_x[i] * d.x + b.v_y[i] * d.y + b.v_z[i] * d.z);
        const double k = b.triangle[i];
        const double along = smaller(t_max - t, t);
        const double across = smaller(smaller(u, v), smaller((1.0 - u) - k * v, (1.0 - v) - k * u));
        result[i] = smaller(along, across);
    }
    return result;
}

std::optional<Hit> SurfaceTable::hit_at_point(Vec3 p, Vec3 direction, std::uint32_t s) const
{
    const Block& b = blocks_[s / width];
    const std::uint32_t i = s % width;
    const double u = b.u_x[i] * p.x + b.u_y[i] * p.y + b.u_z[i] * p.z + b.u_0[i];
    const double v = b.v_x[i] * p.x + b.v_y[i] * p.y + b.v_z[i] * p.z + b.v_0[i];
    const double k = b.triangle[i];
    if (!(u >= 0.0 && v >= 0.0 && (1.0 - u) - k * v >= 0.0 && (1.0 - v) - k * u >= 0.0))
        return std::nullopt;
    const Vec3 normal = {b.normal_x[i], b.normal_y[i], b.normal_z[i]};
    return Hit{0.0, s, u, v, dot(normal, direction) < 0.0};
}

} // namespace multipath

// Makes the rows of the table. The tests themselves are in the header, so that kernels can inline them.

#include "geometry/intersector/surface_table.h"

#include "parallel/blocks.h"

namespace multipath {

namespace {

/// The row of a surface: t from the shared plane, u and v from the dual basis of the edges.
SurfaceRow row_of(const Surface& surface, const Plane& plane, std::uint32_t plane_number)
{
    // Dual basis: dot(to_u, edge_u) = 1 and dot(to_u, edge_v) = 0; likewise with u and v exchanged.
    const Vec3 normal = cross(surface.edge_u, surface.edge_v);
    const double scale = 1.0 / dot(normal, normal);
    const Vec3 to_u = scale * cross(surface.edge_v, normal);
    const Vec3 to_v = scale * cross(normal, surface.edge_u);
    return {{plane.normal.x, to_u.x, to_v.x, static_cast<double>(plane_number)},
            {plane.normal.y, to_u.y, to_v.y, 0.0},
            {plane.normal.z, to_u.z, to_v.z, 0.0},
            {plane.offset, -dot(to_u, surface.origin), -dot(to_v, surface.origin),
             surface.shape == Shape::triangle ? 1.0 : 0.0}};
}

} // namespace

SurfaceTable::SurfaceTable(const SurfaceList& surfaces, const SharedPlanes& planes, int threads)
    : rows_(surfaces.size())
{
    constexpr std::uint32_t at_a_time = 4096;
    parallel_ranges(size(), at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t s = first; s < end; ++s)
            rows_[s] = row_of(surfaces[s], planes.plane_of_surface[s], planes.plane_number[s]);
    });
}

} // namespace multipath

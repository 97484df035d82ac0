#include "geometry/surface_table.h"

namespace multipath {

SurfaceTable::SurfaceTable(const std::vector<Surface>& surfaces, const SharedPlanes& planes) : rows_(surfaces.size())
{
    for (std::uint32_t s = 0; s < size(); ++s) {
        const Surface& surface = surfaces[s];
        const Plane& plane = planes.plane_of_surface[s];
        // Dual basis: dot(to_u, edge_u) = 1, dot(to_u, edge_v) = 0, and the same with u and v exchanged.
        const Vec3 normal = cross(surface.edge_u, surface.edge_v);
        const double scale = 1.0 / dot(normal, normal);
        const Vec3 to_u = scale * cross(surface.edge_v, normal);
        const Vec3 to_v = scale * cross(normal, surface.edge_u);
        rows_[s] = {{plane.normal.x, to_u.x, to_v.x, 0.0},
                    {plane.normal.y, to_u.y, to_v.y, 0.0},
                    {plane.normal.z, to_u.z, to_v.z, 0.0},
                    {plane.offset, -dot(to_u, surface.origin), -dot(to_v, surface.origin),
                     surface.shape == Shape::triangle ? 1.0 : 0.0}};
    }
}

} // namespace multipath

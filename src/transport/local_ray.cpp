#include "transport/local_ray.h"

#include "sampling/warp.h"
#include "transport/intersection_list.h"

#include <algorithm>

namespace multipath {

Line local_line(const Patch& patch, const Item& item)
{
    // A ray must not start on the border itself, where rounding could put it outside a closed room.
    const auto inside = [](double x) { return std::clamp(x, 0x1p-30, 1.0 - 0x1p-30); };
    const Surface& shape = patch.shape;
    Barycentric place{inside(item[0]), inside(item[1])};
    if (shape.shape == Shape::triangle)
        place = square_to_uniform_triangle(place.u, place.v);

    const Vec3 normal = shape.normal();
    // Oblique to the edges (3-4-5 triangle), so that regular numbers do not aim exactly at the edges of rooms.
    const Vec3 along_edge = normalized(shape.edge_u);
    const Vec3 tangent = 0.6 * along_edge + 0.8 * cross(normal, along_edge);
    const Vec3 bitangent = cross(normal, tangent);
    const Vec3 local = square_to_cosine_hemisphere(item[2], item[3]);
    return {shape.at(place.u, place.v), local.x * tangent + local.y * bitangent + local.z * normal};
}

std::uint32_t receiver(const Scene& scene, std::uint32_t surface, const Line& ray)
{
    const std::optional<Hit> hit = scene.intersector().closest_hit_from(surface, ray);
    if (!hit)
        return Segment::outside;
    const std::uint32_t patch = scene.patch_at(hit->surface, hit->u, hit->v, hit->front);
    return patch == Scene::no_patch ? Segment::behind : patch;
}

} // namespace multipath

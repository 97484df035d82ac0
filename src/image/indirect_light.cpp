#include "image/indirect_light.h"

#include "sampling/warp.h"

#include <algorithm>

namespace multipath {

namespace {

/// Without what the sources emit themselves.
std::vector<Rgb> reflected_part(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    std::vector<Rgb> reflected;
    reflected.reserve(radiosity.size());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Rgb part = radiosity[i] - scene.emittance(i);
        reflected.push_back({std::max(0.0, part.r), std::max(0.0, part.g), std::max(0.0, part.b)});
    }
    return reflected;
}

} // namespace

IndirectLight::IndirectLight(const Scene& scene, const std::vector<Rgb>& radiosity, int rays, int threads)
    : scene_(scene),
      rays_(static_cast<std::size_t>(rays)),
      sequence_(make_sequence("sobol-owen", 1)),
      reflected_(reflected_part(scene, radiosity)),
      reflected_light_(scene, reflected_, threads)
{
}

IndirectSample IndirectLight::at(const Place& place, std::uint64_t number, RayFan& fan) const
{
    if (rays_ == 0)
        return {place, {}, 0.0};
    fan.items.resize(rays_);
    sequence_->generate(number * rays_, fan.items);
    // Oblique to the edges, so that regular numbers do not aim exactly at the edges of rooms.
    const Vec3 along_edge = normalized(scene_.surfaces()[place.surface].edge_u);
    const Vec3 tangent = 0.6 * along_edge + 0.8 * cross(place.normal, along_edge);
    const Vec3 bitangent = cross(place.normal, tangent);
    fan.rays.clear();
    for (const Item& item : fan.items) {
        const Vec3 local = square_to_cosine_hemisphere(item[0], item[1]);
        fan.rays.push_back({place.point, local.x * tangent + local.y * bitangent + local.z * place.normal});
    }
    const FirstHits& hits = fan.trace(scene_, place.surface);
    Rgb sum;
    double nearness = 1.0 / scene_.bounds().diagonal();
    for (std::size_t k = 0; k < hits.size(); ++k) {
        if (!hits.is_hit(k))
            continue;
        nearness += 1.0 / hits[k].t;
        if (hits[k].front || scene_.two_sided())
            sum += reflected_light_.at(hits[k]);
    }
    const auto count = static_cast<double>(fan.items.size());
    return {place, 1.0 / count * sum, count / nearness};
}

} // namespace multipath

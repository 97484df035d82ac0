#include "image/final_gather.h"

#include "image/place.h"
#include "sampling/random.h"
#include "sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace multipath {

namespace {

/// Without what the sources emit themselves: SourceLight brings that.
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

FinalGather::FinalGather(const Scene& scene, const std::vector<Rgb>& radiosity, int rays)
    : scene_(scene),
      rays_(static_cast<std::size_t>(rays)),
      sequence_(make_sequence("sobol-owen", 1)),
      source_light_(scene),
      reflected_(reflected_part(scene, radiosity)),
      reflected_light_(scene, reflected_)
{
}

Rgb FinalGather::at(const Hit& hit, std::uint64_t number, std::vector<Item>& items) const
{
    const Place place = place_of(scene_, hit);
    const Material& material = scene_.materials()[scene_.file().material[hit.surface]];
    items.resize(rays_);
    sequence_->generate(number * rays_, items);
    const double offset = bits_to_unit(0x9e3779b97f4a7c15u * number); // multiples of the golden section
    const Rgb irradiance = source_light_.irradiance(place, items, offset) + indirect_irradiance(place, items);
    return (hit.front ? material.emittance : Rgb{}) + material.reflectance * irradiance;
}

Rgb FinalGather::indirect_irradiance(const Place& place, const std::vector<Item>& items) const
{
    // Oblique to the edges, so that regular numbers do not aim exactly at the edges of rooms.
    const Vec3 along_edge = normalized(scene_.surfaces()[place.surface].edge_u);
    const Vec3 tangent = 0.6 * along_edge + 0.8 * cross(place.normal, along_edge);
    const Vec3 bitangent = cross(place.normal, tangent);
    Rgb sum;
    for (const Item& item : items) {
        const Vec3 local = square_to_cosine_hemisphere(item[0], item[1]);
        const Vec3 direction = local.x * tangent + local.y * bitangent + local.z * place.normal;
        const std::optional<Hit> hit = scene_.intersector().closest_hit_from(place.surface, {place.point, direction});
        if (hit && (hit->front || scene_.two_sided()))
            sum += reflected_light_.at(*hit);
    }
    return 1.0 / static_cast<double>(items.size()) * sum;
}

} // namespace multipath

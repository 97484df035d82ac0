#include "image/final_gather.h"

#include "image/place.h"
#include "image/visible_hits.h"
#include "parallel/ordered_blocks.h"
#include "sampling/random.h"

#include <optional>

namespace multipath {

namespace {

/// The number of a pixel in an order in which every square of 2^n x 2^n pixels, aligned to its size, comes in one
/// piece: the bits of x and y by turns (Morton). Consecutive items of a well-spread sequence then complement each other
/// within such squares, and what noise is left is fine-grained.
std::uint64_t number_in_squares(int x, int y)
{
    std::uint64_t number = 0;
    for (int bit = 0; bit < 16; ++bit)
        number |= static_cast<std::uint64_t>((x >> bit & 1) | (y >> bit & 1) << 1) << 2 * bit;
    return number;
}

} // namespace

FinalGather::FinalGather(const Scene& scene, const std::vector<Rgb>& radiosity, const PixelRays& pixels, int width,
                         int height, GatherRays rays, int threads)
    : scene_(scene),
      rays_to_sources_(static_cast<std::size_t>(rays.to_sources)),
      sequence_(make_sequence("sobol-owen", 2)),
      source_light_(scene),
      indirect_light_(scene, radiosity, rays.around, threads),
      grid_(width, height)
{
    if (rays.around == 0)
        return;
    parallel_blocks(static_cast<std::uint64_t>(height), threads, [&](std::uint64_t row) {
        const int y = static_cast<int>(row);
        VisibleHits visible(scene);
        RayFan fan;
        for (int x = 0; x < width; ++x)
            if (const std::optional<Hit> hit = visible.first(pixels.through(x + 0.5, y + 0.5)))
                grid_.set(x, y, indirect_light_.at(place_of(scene, *hit), number_in_squares(x, y), fan));
    });
}

Rgb FinalGather::at(const Hit& hit, int x, int y, int sample, int samples, RayFan& fan) const
{
    const Place place = place_of(scene_, hit);
    const std::uint64_t pixel = number_in_squares(x, y);
    const std::uint64_t number = pixel * static_cast<std::uint64_t>(samples) + static_cast<std::uint64_t>(sample);
    std::optional<Rgb> irradiance = grid_.irradiance(place, x, y);
    if (!irradiance) // something that no middle of a pixel around shows
        irradiance = indirect_light_.at(place, pixel, fan).irradiance;
    fan.items.resize(rays_to_sources_);
    sequence_->generate(number * rays_to_sources_, fan.items);
    const double offset = bits_to_unit(0x9e3779b97f4a7c15u * number); // multiples of the golden section
    *irradiance += source_light_.irradiance(place, fan, offset);
    const Material& material = scene_.materials()[scene_.file().material[hit.surface]];
    return (hit.front ? material.emittance : Rgb{}) + material.reflectance * *irradiance;
}

} // namespace multipath

// Direct light has sharp shadows, so every camera ray samples the sources. Indirect light varies slowly, so it is
// gathered at few points and interpolated (IndirectGrid). The cache is filled in two passes over the pixel centres. The
// first pass samples every second pixel in x and y. The second samples each other pixel for which the samples of the
// first pass do not suffice. A third pass stores the interpolated indirect light of each pixel in which it is almost
// constant.

#include "image/gather/final_gather.h"

#include "image/camera.h"
#include "image/gather/gather_point.h"
#include "parallel/blocks.h"
#include "sampling/random.h"

#include <optional>

namespace multipath {

namespace {

/// Index of a pixel in Morton order, in which the pixels of every aligned square of 2^n x 2^n pixels are consecutive.
/// Consecutive items of a low-discrepancy sequence then complement each other within such squares, which makes the
/// remaining noise fine-grained.
std::uint64_t morton_number(int x, int y)
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
      width_(width),
      height_(height),
      rays_to_sources_(static_cast<std::size_t>(rays.to_sources)),
      sequence_around_(make_sequence("sobol-owen", 1)),
      sequence_to_sources_(make_sequence("sobol-owen", 2)),
      source_light_(scene),
      indirect_light_(scene, radiosity, rays.around, threads),
      grid_(width, height),
      centres_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
{
    if (rays.around == 0)
        return;
    trace_pixel_centres(pixels, threads);
    gather_indirect_light(threads);
}

void FinalGather::trace_pixel_centres(const PixelRays& pixels, int threads)
{
    parallel_blocks(static_cast<std::uint64_t>(height_), threads, [&](std::uint64_t row) {
        const int y = static_cast<int>(row);
        VisibleHits visible(scene_);
        for_each_visible(pixels, width_, y, visible,
                         [&](int x, const std::optional<Hit>& hit) { centre(x, y).hit = hit; });
    });
}

/// Where indirect light varies slowly, one pixel in four is sampled; close to other surfaces every pixel is.
void FinalGather::gather_indirect_light(int threads)
{
    const auto for_each_centre = [&](int spacing, const auto& act) {
        const int rows = (height_ + spacing - 1) / spacing;
        parallel_blocks(static_cast<std::uint64_t>(rows), threads, [&](std::uint64_t row) {
            const int y = spacing * static_cast<int>(row);
            RayFan fan;
            for (int x = 0; x < width_; x += spacing)
                if (const std::optional<Hit>& hit = centre(x, y).hit)
                    act(gather_point(scene_, *hit), x, y, fan);
        });
    };
    for_each_centre(2, [&](const GatherPoint& receiver, int x, int y, RayFan& fan) {
        grid_.set(x, y, indirect_light_.at(receiver, *sequence_around_, morton_number(x / 2, y / 2), fan));
    });
    const std::uint64_t used = std::uint64_t{1} << 30; // beyond the numbers of the first pass, of up to 2^15 x 2^15
    for_each_centre(1, [&](const GatherPoint& receiver, int x, int y, RayFan& fan) {
        if ((x % 2 != 0 || y % 2 != 0) && !grid_.is_supported(receiver, x, y))
            grid_.set(x, y, indirect_light_.at(receiver, *sequence_around_, used + morton_number(x, y), fan));
    });
    for_each_centre(1, [&](const GatherPoint& receiver, int x, int y, RayFan&) {
        if (grid_.is_supported(receiver, x, y))
            centre(x, y).indirect = grid_.irradiance(receiver, x, y);
    });
}

Rgb FinalGather::indirect_irradiance(const GatherPoint& receiver, int x, int y, RayFan& fan) const
{
    if (const std::optional<Rgb> shared = grid_.irradiance(receiver, x, y))
        return *shared;
    // A surface that no pixel centre nearby shows.
    return indirect_light_.at(receiver, *sequence_around_, morton_number(x, y), fan).irradiance;
}

Rgb FinalGather::at(const Hit& hit, int x, int y, int sample, int samples, RayFan& fan) const
{
    const GatherPoint receiver = gather_point(scene_, hit);
    const std::uint64_t pixel = morton_number(x, y);
    const std::uint64_t number = pixel * static_cast<std::uint64_t>(samples) + static_cast<std::uint64_t>(sample);
    const PixelCentre& centre = centres_[pixel_index(width_, x, y)];
    const bool same_side = centre.indirect && centre.hit->surface == hit.surface && centre.hit->front == hit.front;
    Rgb irradiance = same_side ? *centre.indirect : indirect_irradiance(receiver, x, y, fan);
    const SourceLight::Items items{*sequence_to_sources_, number * rays_to_sources_, rays_to_sources_};
    const double offset = bits_to_unit(0x9e3779b97f4a7c15u * number); // multiples of the golden ratio, modulo 1
    irradiance += source_light_.irradiance(receiver, items, offset, fan);
    return (hit.front ? scene_.surface_material(hit.surface).emittance : Rgb{}) +
           scene_.reflectance_at(hit.surface, hit.u, hit.v) * irradiance;
}

} // namespace multipath

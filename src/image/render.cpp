#include "image/render.h"

#include "base/elementary.h"
#include "geometry/hit.h"
#include "image/exposure.h"
#include "image/gather/gather_point.h"
#include "image/gather/indirect_light.h"
#include "image/gather/source_light.h"
#include "image/shading/smooth_shading.h"
#include "parallel/blocks.h"
#include "sampling/random.h"
#include "sampling/sequence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace multipath {

// Final gathering. Direct light has sharp shadows, so every camera ray samples the sources. Indirect light varies
// slowly, so it is gathered at few points and interpolated (IndirectGrid). The cache is filled in two passes over the
// pixel centres. The first pass samples every second pixel in x and y. The second samples each other pixel for which
// the samples of the first pass do not suffice.

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

/// Final gathering for one picture: the radiosity of each visible point is computed from the light that arrives there,
/// so that no patch borders show. Direct light is sampled for every point. Indirect light comes from an irradiance
/// cache (IndirectGrid), or is gathered where the cache has no valid sample. Immutable after construction and safe to
/// share between threads.
class FinalGather
{
public:
    /// Fills the irradiance cache. `radiosity`: the solution [W/m^2] per patch. `samples`: camera rays per pixel. The
    /// scene must outlive this object.
    FinalGather(const Scene& scene, const std::vector<Rgb>& radiosity, const PixelRays& pixels,
                const RenderOptions& options, int samples)
        : scene_(scene),
          options_(options),
          samples_(static_cast<std::uint64_t>(samples)),
          // Twice as many rays to the sources: neighbours do not share them, and only pixels in penumbrae, where noise
          // is visible, need any.
          rays_to_sources_(static_cast<std::size_t>((2 * options.gather_rays + samples - 1) / samples)),
          sequence_around_(make_sequence("sobol-owen", 1)),
          sequence_to_sources_(make_sequence("sobol-owen", 2)),
          source_light_(scene),
          indirect_light_(scene, radiosity, options.indirect ? options.gather_rays : 0, options_.threads),
          grid_(options_.width, options_.height)
    {
        if (options.indirect && options.gather_rays > 0)
            gather_indirect_light(visible_hits(scene, pixels, options_.threads));
    }

    /// [W/m^2] Radiosity at a visible hit of a camera ray through pixel (x, y), emitted light included. `sample`: index
    /// of the ray among the rays of its pixel. `fan`: reusable buffers of one thread.
    Rgb at(const Hit& hit, int x, int y, int sample, RayFan& fan) const
    {
        const GatherPoint receiver = gather_point(scene_, hit);
        const std::uint64_t number = morton_number(x, y) * samples_ + static_cast<std::uint64_t>(sample);
        Rgb irradiance = indirect_irradiance(receiver, x, y, fan);
        const SourceLight::Items items{*sequence_to_sources_, number * rays_to_sources_, rays_to_sources_};
        const double offset = bits_to_unit(0x9e3779b97f4a7c15u * number); // multiples of the golden ratio, modulo 1
        irradiance += source_light_.irradiance(receiver, items, offset, fan);
        return (hit.front ? scene_.surface_material(hit.surface).emittance : Rgb{}) +
               scene_.reflectance_at(hit.surface, hit.u, hit.v) * irradiance;
    }

private:
    /// Where indirect light varies slowly, one pixel in four is sampled; close to other surfaces every pixel is.
    /// `hits`: at the centre of each pixel.
    void gather_indirect_light(const std::vector<std::optional<Hit>>& hits)
    {
        const auto for_each_centre = [&](int spacing, const auto& act) {
            const int rows = (options_.height + spacing - 1) / spacing;
            parallel_blocks(static_cast<std::uint64_t>(rows), options_.threads, [&](std::uint64_t row) {
                const int y = spacing * static_cast<int>(row);
                RayFan fan;
                for (int x = 0; x < options_.width; x += spacing)
                    if (const std::optional<Hit>& hit = hits[pixel_index(options_.width, x, y)])
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
    }

    Rgb indirect_irradiance(const GatherPoint& receiver, int x, int y, RayFan& fan) const
    {
        if (const std::optional<Rgb> shared = grid_.irradiance(receiver, x, y))
            return *shared;
        // A surface that no pixel centre nearby shows.
        return indirect_light_.at(receiver, *sequence_around_, morton_number(x, y), fan).irradiance;
    }

    const Scene& scene_;
    RenderOptions options_;
    std::uint64_t samples_;
    std::size_t rays_to_sources_;
    std::unique_ptr<Sequence> sequence_around_;
    std::unique_ptr<Sequence> sequence_to_sources_;
    SourceLight source_light_;
    IndirectLight indirect_light_;
    IndirectGrid grid_;
};

} // namespace

// Every pixel is the mean of k x k samples. Their positions are distributed like a tent filter two pixels wide (filter
// importance sampling), so that the unweighted mean is the filtered picture. All pixels use the same pattern of
// samples: random patterns would roughen the long straight edges of rooms.

namespace {

/// Maps a uniform number in [0, 1) to an offset in (-1, 1) with tent-shaped density.
double uniform_to_tent(double u)
{
    return u < 0.5 ? std::sqrt(2.0 * u) - 1.0 : 1.0 - std::sqrt(2.0 - 2.0 * u);
}

/// Renders rows of a picture. paint_row() may be called by several threads at once.
class Painter
{
public:
    Painter(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera, const RenderOptions& options)
        : scene_(scene),
          radiosity_(radiosity),
          rays_(camera, options.width, options.height),
          options_(options),
          up_(normalized(camera.up))
    {
        if (scene.file().sky_surfaces > 0)
            sky_ = radiosity[scene.first_patch(scene.own_surfaces())];
        while (grid_ * grid_ < options.samples_per_pixel)
            ++grid_;
        if (options.shading == Shading::smooth)
            smooth_.emplace(scene, radiosity, options.threads, find_shown());
        if (options.shading == Shading::gather)
            gather_.emplace(scene, radiosity, rays_, options, grid_ * grid_);
    }

    void paint_row(int y, Rgb* pixels) const
    {
        Tools tools{VisibleHits(scene_), {}, {}};
        for_each_hit(y, tools, [&](Sample sample, const std::optional<Hit>& hit) {
            const bool is_sky = !hit || (options_.shaded_sky && scene_.is_sky(hit->surface));
            pixels[sample.x] += clipped(is_sky ? sky(ray(sample).direction) : shade(*hit, sample, tools));
        });
        for (int x = 0; x < options_.width; ++x)
            pixels[x] = 1.0 / (grid_ * grid_) * pixels[x];
    }

private:
    /// A sample of pixel (x, y).
    struct Sample
    {
        int x;
        int y;
        int number; ///< index in its pixel
    };

    /// Reusable buffers of one thread.
    struct Tools
    {
        VisibleHits visible;
        RayFan fan;
        std::vector<Line> rays;
    };

    /// Ray of a sample. The pattern is the regular arrangement of multi-jittered sampling (Chiu, Shirley and Wang
    /// 1994): one sample in each cell of a k x k grid, and no two in one row or column of a k^2 x k^2 grid. An almost
    /// horizontal edge gets k^2 shades instead of k.
    Line ray(Sample sample) const
    {
        const double k = grid_;
        const int row = sample.number / grid_;
        const int column = sample.number % grid_;
        const double u = (column + (row + 0.5) / k) / k;
        const double v = (row + (grid_ - column - 0.5) / k) / k;
        return rays_.through(sample.x + 0.5 + uniform_to_tent(u), sample.y + 0.5 + uniform_to_tent(v));
    }

    /// Index of a sample in the whole picture.
    std::size_t number_of(Sample sample) const
    {
        const std::size_t pixel = pixel_index(options_.width, sample.x, sample.y);
        return pixel * static_cast<std::size_t>(grid_ * grid_) + static_cast<std::size_t>(sample.number);
    }

    /// Calls visit(sample, hit) for the samples of a row, pixel by pixel.
    template <class Visit>
    void for_each_hit(int y, Tools& tools, const Visit& visit) const
    {
        constexpr int pixels_at_a_time = 64;
        const int samples = grid_ * grid_;
        for (int first = 0; first < options_.width; first += pixels_at_a_time) {
            const int count = samples * std::min(pixels_at_a_time, options_.width - first);
            const auto sample = [&](int k) { return Sample{first + k / samples, y, k % samples}; };
            tools.rays.clear();
            for (int k = 0; k < count; ++k)
                tools.rays.push_back(ray(sample(k)));
            const std::vector<std::optional<Hit>>* const hits =
                found_.empty() ? &tools.visible.first(tools.rays) : nullptr;
            for (std::size_t k = 0; k < tools.rays.size(); ++k) {
                const Sample s = sample(static_cast<int>(k));
                visit(s, hits ? (*hits)[k] : hit_on_found(tools.rays[k], s));
            }
        }
    }

    /// The hit of a sample on the surface that find_shown() found.
    std::optional<Hit> hit_on_found(const Line& ray, Sample sample) const
    {
        const std::uint32_t surface = found_[number_of(sample)];
        return surface == nothing ? std::nullopt : scene_.intersector().hit_on(ray, surface);
    }

    /// Finds the surface of every sample and stores it in found_. Returns the flags of the surfaces in the picture,
    /// since most surfaces of a detailed model are hidden. Does nothing and returns an empty list if there are few
    /// surfaces, or too many samples to store.
    std::vector<char> find_shown()
    {
        constexpr std::size_t few_surfaces = 10'000;
        constexpr std::size_t most_samples = std::size_t{1} << 26;
        const std::size_t count = number_of({0, options_.height, 0});
        if (scene_.surfaces().size() <= few_surfaces || count > most_samples)
            return {};
        std::vector<std::uint32_t> found(count);
        parallel_blocks(static_cast<std::uint64_t>(options_.height), options_.threads, [&](std::uint64_t row) {
            Tools tools{VisibleHits(scene_), {}, {}};
            for_each_hit(static_cast<int>(row), tools, [&](Sample sample, const std::optional<Hit>& hit) {
                found[number_of(sample)] = hit ? hit->surface : nothing;
            });
        });
        std::vector<char> shown(scene_.surfaces().size());
        for (const std::uint32_t surface : found)
            if (surface != nothing)
                shown[surface] = 1;
        found_ = std::move(found);
        return shown;
    }

    Rgb shade(const Hit& hit, Sample sample, Tools& tools) const
    {
        if (gather_)
            return gather_->at(hit, sample.x, sample.y, sample.number, tools.fan);
        return smooth_ ? smooth_->at(hit) : radiosity_[scene_.patch_at(hit.surface, hit.u, hit.v, hit.front)];
    }

    /// The sky in a direction. In pictures for a screen it is brighter towards the horizon; the mean over the upper
    /// hemisphere is that of the solution. It is never quite white, so that its colour shows.
    Rgb sky(Vec3 direction) const
    {
        if (!options_.shaded_sky)
            return sky_;
        constexpr double horizon = 1.424; // times the mean over the upper hemisphere
        constexpr double brightest = 0.6; // of white
        const double height = std::abs(dot(direction, up_));
        const double most = horizon * std::max({sky_.r, sky_.g, sky_.b});
        return std::min(1.0, brightest * options_.white / most) * (horizon - height * height / (height + 0.1)) * sky_;
    }

    Rgb clipped(Rgb value) const
    {
        return by_channel([&](double x) { return std::min(x, options_.white); }, value);
    }

    static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

    const Scene& scene_;
    const std::vector<Rgb>& radiosity_; ///< [W/m^2] per patch
    PixelRays rays_;
    RenderOptions options_;
    std::optional<ShownRadiosity> smooth_;
    std::optional<FinalGather> gather_;
    int grid_ = 1;                     ///< k: samples along a side of a pixel
    Rgb sky_;                          ///< [W/m^2] radiosity of the sky; black without one
    Vec3 up_;                          ///< unit vector
    std::vector<std::uint32_t> found_; ///< per sample: the visible surface, or `nothing`; empty if not computed
};

} // namespace

Image render(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera, const RenderOptions& options)
{
    const Painter painter(scene, radiosity, camera, options);
    Image image{options.width, options.height, {}};
    image.pixels.resize(pixel_index(image.width, 0, image.height));
    parallel_blocks(static_cast<std::uint64_t>(image.height), options.threads, [&](std::uint64_t row) {
        painter.paint_row(static_cast<int>(row), &image.at(0, static_cast<int>(row)));
    });
    return image;
}

double picture_scale(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                     const RenderOptions& options, const ToneMapOptions& tone)
{
    const double base = tone.scale ? *tone.scale : automatic_exposure(scene, radiosity, camera, options, tone.tone);
    return base * elementary::pow(2.0, tone.exposure);
}

ScreenImage picture(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                    const RenderOptions& options, const ToneMapOptions& tone)
{
    const double scale = picture_scale(scene, radiosity, camera, options, tone);
    RenderOptions clipped = options;
    clipped.white = white_point(tone.tone) / scale;
    clipped.shaded_sky = true;
    return tone_map(render(scene, radiosity, camera, clipped), tone.tone, scale);
}

} // namespace multipath

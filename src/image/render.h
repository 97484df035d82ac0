#pragma once

#include "geometry/hit.h"
#include "image/camera.h"
#include "image/gather/gather_point.h"
#include "image/gather/indirect_light.h"
#include "image/gather/source_light.h"
#include "image/image.h"
#include "image/tone_map.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace multipath {

/// Numbers of rays that FinalGather casts.
struct GatherRays
{
    int to_sources = 16; ///< shadow rays per camera ray
    /// Hemisphere rays per sample of indirect light; a sample also serves neighbouring pixels. 0: no indirect light.
    int around = 64;
};

/// Final gathering for one picture: the radiosity of each visible point is computed from the light that arrives there,
/// so that no patch borders show. Direct light is sampled for every point. Indirect light comes from an irradiance
/// cache (IndirectGrid), or is gathered where the cache has no valid sample. Immutable after construction and safe to
/// share between threads.
class FinalGather
{
public:
    /// Fills the irradiance cache for the pixels of a picture of width x height pixels. `radiosity`: the solution
    /// [W/m^2] per patch. The scene must outlive this object.
    FinalGather(const Scene& scene, const std::vector<Rgb>& radiosity, const PixelRays& pixels, int width, int height,
                GatherRays rays, int threads);

    /// [W/m^2] Radiosity at a visible hit of a camera ray through pixel (x, y), emitted light included. `sample`: index
    /// of the ray among the `samples` rays of its pixel. `fan`: reusable buffers of one thread.
    Rgb at(const Hit& hit, int x, int y, int sample, int samples, RayFan& fan) const;

private:
    /// The point seen through the centre of a pixel.
    struct PixelCentre
    {
        std::optional<Hit> hit;
        std::optional<Rgb> indirect; ///< [W/m^2] indirect irradiance; absent where it may vary within the pixel
    };

    void trace_pixel_centres(const PixelRays& pixels, int threads);
    void gather_indirect_light(int threads);
    Rgb indirect_irradiance(const GatherPoint& receiver, int x, int y, RayFan& fan) const;
    PixelCentre& centre(int x, int y) { return centres_[pixel_index(width_, x, y)]; }

    const Scene& scene_;
    int width_;
    int height_;
    std::size_t rays_to_sources_;
    std::unique_ptr<Sequence> sequence_around_;
    std::unique_ptr<Sequence> sequence_to_sources_;
    SourceLight source_light_;
    IndirectLight indirect_light_;
    IndirectGrid grid_;
    std::vector<PixelCentre> centres_; ///< row by row
};

enum class Shading {
    flat,   ///< one colour per patch
    smooth, ///< radiosity interpolated between patches (SmoothShading)
    gather, ///< final gathering: the last reflection is computed for every pixel (FinalGather)
};

struct RenderOptions
{
    int width = 800;
    int height = 600;
    int samples_per_pixel = 9; ///< rounded up to a square number k * k
    Shading shading = Shading::smooth;
    /// Final gathering: hemisphere rays at each point where indirect light is sampled. Twice as many shadow rays per
    /// pixel go to the sources; they are divided among the samples of the pixel, rounded up.
    int gather_rays = 64;
    bool indirect = true; ///< final gathering includes indirect light; false leaves direct light only
    int threads = 1;
    /// [W/m^2] Samples are clamped to this value before they are averaged. Pictures for a screen set it to the
    /// radiosity that is shown as white. Without the clamp, the edge of a lamp a thousand times brighter than the room
    /// would not be antialiased.
    double white = std::numeric_limits<double>::infinity();
};

/// Renders a scene with the given radiosity [W/m^2] per patch. Where a ray meets nothing, the picture is black, or
/// shows the radiosity of the sky in a scene with a sky. The backs of one-sided surfaces are transparent. With final
/// gathering, `radiosity` must be a solution, whose last reflection is computed anew. The result does not depend on the
/// number of threads. Throws SettingsError for an invalid camera or picture size (PixelRays).
Image render(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera, const RenderOptions& options);

/// Options for the conversion of radiosity to brightness on the screen.
struct ToneMapOptions
{
    ToneOperator tone = ToneOperator::reinhard;
    double exposure = 0.0; ///< [stops] the automatic or given scale is multiplied by 2^exposure
    /// [m^2/W] Factor from radiosity to the tone operator's input; chosen by automatic_scale() if absent.
    std::optional<double> scale = std::nullopt;
};

/// Options for a small preview of the same picture, on which the exposure is measured: sides of at most 160 pixels,
/// flat shading, one sample per pixel, no clamping.
RenderOptions preview_options(RenderOptions options);

/// [m^2/W] The factor from radiosity to the input of the tone operator that picture() uses: the given or automatic
/// scale, times 2^exposure.
double picture_scale(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                     const RenderOptions& options, const ToneMapOptions& tone);

/// Renders a tone-mapped picture for the screen. options.white is ignored: samples are clamped to the radiosity that
/// the tone operator shows as white at this exposure. Throws like render().
ScreenImage picture(const Scene& scene, const std::vector<Rgb>& radiosity, const Camera& camera,
                    const RenderOptions& options, const ToneMapOptions& tone);

} // namespace multipath

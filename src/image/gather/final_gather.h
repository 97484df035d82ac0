#pragma once

#include "geometry/hit.h"
#include "image/camera.h"
#include "image/gather/gather_point.h"
#include "image/gather/indirect_light.h"
#include "image/gather/source_light.h"
#include "image/image.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstddef>
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

} // namespace multipath

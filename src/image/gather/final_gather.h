#pragma once

#include "geometry/hit.h"
#include "image/camera.h"
#include "image/gather/indirect_light.h"
#include "image/gather/place.h"
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

/// Number of rays for one point.
struct GatherRays
{
    int to_sources = 16;
    int around = 64; ///< for indirect light, which neighbours share; 0 leaves it out
};

/// One picture of a scene in which the last reflection on the light's way to the eye is computed for each point on its
/// own: radiosity without patches. Immutable and safe to share between threads.
class FinalGather
{
public:
    /// Gathers the indirect light for all pixels. `radiosity`: the solution [W/m^2] per patch. The scene must outlive
    /// this object.
    FinalGather(const Scene& scene, const std::vector<Rgb>& radiosity, const PixelRays& pixels, int width, int height,
                GatherRays rays, int threads);

    /// [W/m^2] Radiosity where a line through pixel (x, y) meets a side that exists. `sample` is the number of the line
    /// in its pixel, 0 <= sample < samples; `fan` is room to work in.
    Rgb at(const Hit& hit, int x, int y, int sample, int samples, RayFan& fan) const;

private:
    /// The point seen through the middle of a pixel.
    struct Middle
    {
        std::optional<Hit> hit;
        std::optional<Rgb> indirect; ///< [W/m^2] irradiance, where it hardly changes within the pixel
    };

    void find_middles(const PixelRays& pixels, int threads);
    void gather_indirect_light(int threads);
    Rgb indirect_irradiance(const Place& place, int x, int y, RayFan& fan) const;
    Middle& middle(int x, int y) { return middles_[pixel_index(width_, x, y)]; }

    const Scene& scene_;
    int width_;
    int height_;
    std::size_t rays_to_sources_;
    std::unique_ptr<Sequence> sequence_around_;
    std::unique_ptr<Sequence> sequence_to_sources_;
    SourceLight source_light_;
    IndirectLight indirect_light_;
    IndirectGrid grid_;
    std::vector<Middle> middles_; ///< row by row
};

} // namespace multipath

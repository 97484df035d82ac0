#pragma once

#include "geometry/surface_table.h"
#include "image/smooth_shading.h"
#include "image/source_light.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace multipath {

/// The last reflection of the light on its way to the eye, for each point on its own: radiosity without patches. Light
/// straight from the sources comes from SourceLight, all other light from rays over the hemisphere, which look up what
/// the patches reflect. Immutable and safe to share between threads.
class FinalGather
{
public:
    /// `radiosity`: the solution [W/m^2] per patch. `rays` of each kind for a point. The scene must outlive this
    /// object.
    FinalGather(const Scene& scene, const std::vector<Rgb>& radiosity, int rays);
    FinalGather(const FinalGather&) = delete;
    FinalGather& operator=(const FinalGather&) = delete;

    /// [W/m^2] Radiosity where a line meets a side that exists. Points with neighbouring numbers get rays that
    /// complement each other; `items` is room to work in.
    Rgb at(const Hit& hit, std::uint64_t number, std::vector<Item>& items) const;

private:
    Rgb indirect_irradiance(const Place& place, const std::vector<Item>& items) const;

    const Scene& scene_;
    std::size_t rays_;
    std::unique_ptr<Sequence> sequence_;
    SourceLight source_light_;
    std::vector<Rgb> reflected_; ///< [W/m^2] per patch
    SmoothShading reflected_light_;
};

} // namespace multipath

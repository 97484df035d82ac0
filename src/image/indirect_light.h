#pragma once

#include "image/place.h"
#include "image/ray_fan.h"
#include "image/smooth_shading.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace multipath {

/// What arrives at a place by reflection.
struct IndirectSample
{
    Place place;
    Rgb irradiance;        ///< [W/m^2]
    double distance = 0.0; ///< [scene units] harmonic mean of the way to what is seen: how far the value changes little
};

/// Light that was reflected at least once, gathered by rays over the hemisphere, which look up what the patches
/// reflect. Immutable and safe to share between threads.
class IndirectLight
{
public:
    /// `radiosity`: the solution [W/m^2] per patch; `rays` for one place, 0 for darkness. The scene must outlive this
    /// object.
    IndirectLight(const Scene& scene, const std::vector<Rgb>& radiosity, int rays, int threads);
    IndirectLight(const IndirectLight&) = delete;
    IndirectLight& operator=(const IndirectLight&) = delete;

    /// Places with neighbouring numbers get rays that complement each other. `fan` is room to work in.
    IndirectSample at(const Place& place, std::uint64_t number, RayFan& fan) const;

private:
    const Scene& scene_;
    std::size_t rays_;
    std::unique_ptr<Sequence> sequence_;
    std::vector<Rgb> reflected_; ///< [W/m^2] per patch
    SmoothShading reflected_light_;
};

} // namespace multipath

#pragma once

#include "image/gather/place.h"
#include "image/shading/smooth_shading.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// Irradiance of a place by reflected light.
struct IndirectSample
{
    Place place;
    Rgb irradiance;        ///< [W/m^2]
    double distance = 0.0; ///< [scene units] harmonic mean distance to the surfaces seen
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

    /// Rays from the items of a sequence that belong to this number: places with neighbouring numbers get rays that
    /// complement each other. `fan` is room to work in.
    IndirectSample at(const Place& place, const Sequence& sequence, std::uint64_t number, RayFan& fan) const;

private:
    const Scene& scene_;
    std::size_t rays_;
    std::vector<Rgb> reflected_; ///< [W/m^2] per patch
    SmoothShading reflected_light_;
};

/// Irradiance cache: indirect light at the points seen through the middles of the pixels of a picture, interpolated at
/// points nearby. It varies slowly, except close to where surfaces meet (G. Ward, F. Rubinstein, R. Clear: A ray
/// tracing solution for diffuse interreflection, SIGGRAPH 1988).
class IndirectGrid
{
public:
    IndirectGrid(int width, int height);

    /// Each pixel once, by any thread.
    void set(int x, int y, const IndirectSample& sample);

    /// [W/m^2] Irradiance of a place that pixel (x, y) shows, from the samples around; none if none is near enough.
    std::optional<Rgb> irradiance(const Place& place, int x, int y) const;

    /// True if there are enough samples near a place that pixel (x, y) shows. Reads only the pixels with even
    /// coordinates, so that the others may be set meanwhile.
    bool is_supported(const Place& place, int x, int y) const;

private:
    struct Shared
    {
        Rgb irradiance; ///< [W/m^2] times the weights
        double weights = 0.0;
        int pixels = 0; ///< looked at
    };

    static bool is_enough(const Shared& found);
    Shared shared(const Place& place, int x, int y, int reach, int spacing) const;

    int width_;
    int height_;
    std::vector<IndirectSample> samples_; ///< distance 0 where there is none
};

} // namespace multipath

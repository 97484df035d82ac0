#pragma once

#include "image/indirect_light.h"
#include "scene/rgb.h"

#include <optional>
#include <vector>

namespace multipath {

/// Indirect light at what the middles of the pixels of a picture show, to be shared with places nearby: it varies
/// slowly, except close to where things meet (G. Ward, F. Rubinstein, R. Clear: A ray tracing solution for diffuse
/// interreflection, SIGGRAPH 1988).
class IndirectGrid
{
public:
    IndirectGrid(int width, int height);

    /// Each pixel once, by any thread.
    void set(int x, int y, const IndirectSample& sample);

    /// [W/m^2] Irradiance of a place that pixel (x, y) shows, from the samples around; none if none is near enough.
    std::optional<Rgb> irradiance(const Place& place, int x, int y) const;

    /// Are there so many samples near a place that pixel (x, y) shows that one more would change little? Looks at the
    /// pixels with even coordinates only, so that the others may be set meanwhile.
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

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

private:
    std::size_t index(int x, int y) const;

    int width_;
    int height_;
    std::vector<IndirectSample> samples_; ///< distance 0 where there is none
};

} // namespace multipath

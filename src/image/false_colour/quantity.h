#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// Something that every patch has its own value of, to be shown in a picture.
struct Quantity
{
    std::string title;       ///< with its unit in brackets, in the characters of draw_text
    std::vector<Rgb> values; ///< per patch, >= 0; not a number in the channels where a patch has none
    bool contours = false;   ///< it varies smoothly over surfaces: lines of equal values help to read it
};

/// [W/m^2] H = (B - E) / rho of every patch; not a number in the channels in which it reflects nothing, since there the
/// radiosity does not tell.
std::vector<Rgb> irradiance(const Scene& scene, const std::vector<Rgb>& radiosity);

/// Absolute values, channel by channel.
std::vector<Rgb> magnitudes(const std::vector<Rgb>& values);

/// The unit normal of every patch as a colour: 0.5 + 0.5 n, so that x is red, y green and z blue.
std::vector<Rgb> normal_colours(const Scene& scene);

/// For every patch a colour (linear light, 0 ... 1) that has nothing to do with its neighbours'.
std::vector<Rgb> patch_colours(std::size_t patches);

} // namespace multipath

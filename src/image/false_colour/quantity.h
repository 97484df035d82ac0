#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// A quantity with one value per patch, to be shown in false colours.
struct Quantity
{
    std::string title;       ///< with its unit in brackets, in the characters of draw_text()
    std::vector<Rgb> values; ///< per patch, >= 0; a patch with NaN in a channel has no value and is shown black
    bool contours = false;   ///< true: draw contour lines, for quantities that vary smoothly over surfaces
};

/// [W/m^2] Irradiance H = (B - E) / rho of every patch, at least 0. NaN in channels with a reflectance below 1e-6,
/// where B does not determine H.
std::vector<Rgb> irradiance(const Scene& scene, const std::vector<Rgb>& radiosity);

/// Absolute values of all channels.
std::vector<Rgb> magnitudes(const std::vector<Rgb>& values);

/// The unit normal of every patch as a colour: 0.5 + 0.5 n, with x in red, y in green and z in blue.
std::vector<Rgb> normal_colours(const Scene& scene);

/// A pseudo-random colour (linear light, 0 ... 1) for each of `patches` patches, so that neighbours can be
/// distinguished.
std::vector<Rgb> patch_colours(std::size_t patches);

} // namespace multipath

#pragma once

#include "image/camera.h"
#include "image/image.h"
#include "image/render.h"
#include "scene/scene.h"

#include <cstddef>
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

/// The unit normal of every patch as a colour (linear light, 0 ... 1) whose sRGB value is 0.5 + 0.5 n, with x in red, y
/// in green and z in blue.
std::vector<Rgb> normal_colours(const Scene& scene);

/// A pseudo-random colour (linear light, 0 ... 1) for each of `patches` patches, so that neighbours can be
/// distinguished.
std::vector<Rgb> patch_colours(std::size_t patches);

/// Renders the scene with a given colour per patch (linear light, 0 ... 1). Where a ray meets nothing, the picture is
/// black, or has the colour of the sky in a scene with a sky. There is no interpolation and no exposure:
/// options.shading and options.white are ignored. Throws SettingsError like render().
ScreenImage flat_picture(const Scene& scene, const std::vector<Rgb>& colours, const Camera& camera,
                         RenderOptions options);

/// Renders a quantity in false colours: one colour per patch, for the mean of the channels of its value; black where a
/// patch has no value. The picture has the size that the options give. If there is room, the lowest rows of the picture
/// are a legend. The scale goes from 0 to a round number at or above the smaller of two values: the 99th percentile of
/// the visible values, and twice their 90th percentile unless that is 0. With the latter, a small very bright spot does
/// not make the rest dark. If the quantity has contours, contour lines follow the interpolated values (SmoothShading)
/// at the numbers of the legend. Sources get no contour lines. Throws SettingsError like render().
ScreenImage false_colour(const Scene& scene, const Quantity& quantity, const Camera& camera, RenderOptions options);

} // namespace multipath

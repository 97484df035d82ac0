#pragma once

// The viewer is an HTML page that shows a solved room. Its content is given here as plain lists; the viewer does not
// know how they were computed.

#include "explain/stage_trace.h"
#include "image/camera.h"
#include "image/render.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// A quantity with one value per patch.
struct ViewerQuantity
{
    std::string key;         ///< for scripts: "radiosity"
    std::string title;       ///< for people, UTF-8
    std::string unit;        ///< for people, UTF-8
    bool is_light;           ///< shown as an eye would see it, else in false colours of the mean of the channels
    std::vector<Rgb> values; ///< per patch, >= 0; NaN where a patch has no value
};

/// Everything that a page shows besides the scene.
struct ViewerContent
{
    std::vector<std::string> record; ///< provenance: "command: multipath ..."
    Camera camera;                   ///< initial camera
    RenderOptions render;            ///< for the preview that sets the brightness; its shading is the initial one
    ToneMapOptions tone;             ///< operator and initial exposure; ToneMapOptions::scale is ignored
    std::vector<ViewerQuantity> quantities; ///< the first is the radiosity [W/m^2], shown as light
    std::size_t shown = 0;                  ///< index of the initial quantity
    std::vector<StageTrace> chapters;       ///< traces of successive lines of stages of a run
};

/// The texts before and after the JSON data of the room in a page.
constexpr const char* room_data_begin = "<script type=\"application/json\" id=\"room\">";
constexpr const char* room_data_end = "</script>";

/// A self-contained page (HTML) to walk through the solved room in a browser. The page loads no other file.
std::string viewer_page(const Scene& scene, const ViewerContent& content);

/// Smooth values at the corners of all patches, as pictures interpolate them (SmoothShading). Most patches of a side
/// share the value of a grid point. Where they do not, as on both sides of a wall that stands there, a patch has its
/// own.
struct CornerValues
{
    std::vector<Rgb>
        values; ///< of the points of each side, in the order in which its patches meet them; then the own ones
    std::vector<std::uint32_t> own_places; ///< of the own values: 4 * patch + index of the corner in Scene::corners()
};

CornerValues corner_values(const Scene& scene, const std::vector<Rgb>& values_per_patch, int threads);

constexpr double largest_half = 65504.0; ///< in 16 bits

/// Colours in a common `unit`, with 11 significant binary digits.
struct PackedLight
{
    double unit = 1.0;  ///< the brightest channel is largest_half units; 1 if no channel is positive
    std::string halves; ///< a Uint16Array of floating-point numbers of 16 bits (IEEE 754), three for each colour
};

/// Packs colours, which must be finite and not negative.
PackedLight packed_light(const std::vector<Rgb>& values);

} // namespace multipath

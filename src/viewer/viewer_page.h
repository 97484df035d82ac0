#pragma once

#include "export/svg/line_drawing.h"
#include "image/camera.h"
#include "image/render.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Content of the page in plain lists: the viewer does not know how any of it was computed.

namespace multipath {

/// Conversion of the values of a quantity to colours.
enum class ViewerColours {
    light, ///< the room as an eye would see it
    scale  ///< false colours of the mean of the channels, with a legend
};

/// A quantity with a value for every patch.
struct ViewerQuantity
{
    std::string key;   ///< for scripts: "radiosity"
    std::string title; ///< for people, UTF-8
    std::string unit;  ///< for people, UTF-8
    ViewerColours colours;
    std::vector<Rgb> values; ///< per patch, >= 0; NaN where a patch has none
};

/// The radiosity of a run with fewer lines.
struct ViewerStage
{
    std::uint64_t lines;
    std::vector<Rgb> radiosity; ///< [W/m^2] per patch
};

/// Power that is sent along one segment of a traced line, between two successive hits.
struct ViewerTransfer
{
    std::size_t segment; ///< index among the segments of the line
    std::uint32_t from;  ///< patch
    std::uint32_t to;    ///< patch, or Scene::no_patch if the power is lost
    Rgb forecast;        ///< [W] part of the sent power that is the forecast (G3)
    Rgb held;            ///< [W] part that the patch had received and reflected before
    Rgb counted;         ///< [W] power that the receiver counts as arrived
};

/// A traced line.
struct ViewerLine
{
    DrawnLine shape;
    std::vector<ViewerTransfer> transfers;
};

/// Traces of successive lines of one stage of a run.
struct ViewerChapter
{
    std::string title;
    std::string note; ///< explanation of these lines, a few sentences
    std::vector<ViewerLine> lines;
};

/// Everything that a page shows besides the scene.
struct ViewerContent
{
    std::vector<std::string> record;        ///< provenance: "command: multipath ..."
    Camera camera;                          ///< initial camera
    RenderOptions render;                   ///< picture for which the exposure is measured, and initial shading
    ToneMapOptions tone;                    ///< initial tone map
    std::vector<ViewerQuantity> quantities; ///< the radiosity [W/m^2] first
    std::size_t shown = 0;                  ///< index of the initial quantity
    std::uint64_t lines = 0;                ///< number of lines of the radiosity
    std::vector<ViewerStage> stages;        ///< with fewer lines, increasing
    std::vector<ViewerChapter> chapters;
};

/// Begin and end of the data of the room in a page.
constexpr const char* room_data_begin = "<script type=\"application/json\" id=\"room\">";
constexpr const char* room_data_end = "</script>";

/// A self-contained page (HTML) to walk through the solved room in a browser; it loads no other file.
std::string viewer_page(const Scene& scene, const ViewerContent& content);

/// Smooth values at the corners of all patches, as pictures interpolate them (SmoothShading). Most patches share the
/// value at a grid point of their surface. Where they do not, as on both sides of a wall that stands on the surface, a
/// patch has its own value.
struct CornerValues
{
    std::vector<Rgb> shared;          ///< at every grid point, surface by surface, fronts first; row by row with j
    std::vector<std::uint32_t> slots; ///< 4 * patch + index of its corner, in the order of Scene::corners()
    std::vector<Rgb> own;             ///< own value for each of these slots
};

/// Computes the corner values. On a surface that is cut by quadtrees, every patch has four shared values for itself.
CornerValues corner_values(const Scene& scene, const std::vector<Rgb>& values_per_patch, int threads);

/// The text of a file of the folder src/viewer/page. The Makefile embeds these files in the program. Throws
/// std::logic_error for an unknown name.
std::string_view page_file(std::string_view name);

} // namespace multipath

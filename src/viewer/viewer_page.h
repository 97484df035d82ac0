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

// What the viewer shows, in plain lists: it does not know how any of it was computed.

namespace multipath {

/// How the values of a quantity become colours.
enum class ViewerColours {
    light, ///< the room as an eye would see it
    scale  ///< false colours of the mean of the channels, with a legend
};

/// Something that every patch has its own value of.
struct ViewerQuantity
{
    std::string key;   ///< for scripts: "radiosity"
    std::string title; ///< for people, as is the unit: UTF-8
    std::string unit;
    ViewerColours colours;
    std::vector<Rgb> values; ///< per patch, >= 0; not a number where a patch has none
};

/// The radiosity after fewer lines.
struct ViewerStage
{
    std::uint64_t lines;
    std::vector<Rgb> radiosity; ///< [W/m^2] per patch
};

/// Power that goes along one stretch of a told line.
struct ViewerTransfer
{
    std::size_t stretch; ///< number among those of the line
    std::uint32_t from;  ///< patch
    std::uint32_t to;    ///< patch, or Scene::no_patch where the power is lost
    Rgb forecast;        ///< [W] sent because it was foreseen (G3)
    Rgb held;            ///< [W] sent because it had come before
    Rgb counted;         ///< [W] that counts as arrived
};

struct ViewerLine
{
    DrawnLine shape;
    std::vector<ViewerTransfer> transfers;
};

/// Some successive lines of one stage of a run.
struct ViewerChapter
{
    std::string title;
    std::string note; ///< what the reader should know of them, in a few sentences
    std::vector<ViewerLine> lines;
};

struct ViewerContent
{
    std::vector<std::string> record; ///< where the page comes from: "command: multipath ..."
    Camera camera;                   ///< of the first view
    RenderOptions render;            ///< the picture by which exposure is measured; its shading is the first one shown
    ToneMapOptions tone;             ///< at first
    std::vector<ViewerQuantity> quantities; ///< the radiosity [W/m^2] first
    std::size_t shown = 0;                  ///< the quantity of the first view
    std::uint64_t lines = 0;                ///< that led to the radiosity
    std::vector<ViewerStage> stages;        ///< with fewer lines, rising
    std::vector<ViewerChapter> chapters;
};

/// Where the data of the room stand in a page, and where they end.
constexpr const char* room_data_begin = "<script type=\"application/json\" id=\"room\">";
constexpr const char* room_data_end = "</script>";

/// A page (HTML) to walk through the solved room in a browser: complete in itself, it loads nothing.
std::string viewer_page(const Scene& scene, const ViewerContent& content);

/// Smooth values at the corners of all patches, as pictures interpolate them (SmoothShading). Most patches agree on the
/// value at a point of their surface's grid; those that do not, as on both sides of a wall that stands there, have one
/// of their own.
struct CornerValues
{
    std::vector<Rgb> shared;           ///< at every grid point, surface by surface, fronts first; row by row with j
    std::vector<std::uint32_t> places; ///< 4 * patch + number of its corner, in the order of Scene::corners()
    std::vector<Rgb> own;              ///< at these places
};

/// Sources have none of their own: they are never shown smooth.
CornerValues corner_values(const Scene& scene, const std::vector<Rgb>& values_per_patch, int threads);

/// The text of a file of the folder src/viewer/page, by its name; the Makefile puts the files into the program. Throws
/// std::logic_error for an unknown name.
std::string_view page_file(std::string_view name);

} // namespace multipath

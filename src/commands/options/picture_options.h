#pragma once

#include "cli/options/command_line.h"
#include "image/camera.h"
#include "image/gather/light_grid.h"
#include "image/render.h"
#include "radiosity/solution.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// How the values of a quantity become a picture.
enum class ShownAs {
    room,              ///< as an eye would see it: shaded and exposed
    directly_lit_room, ///< the same, without light that was reflected before
    false_colours,     ///< of the mean of the channels, with a legend
    light_of_screen,   ///< as linear light, 1 is white
    numbers_of_screen, ///< as the numbers of the file, 1 is white
};

/// A quantity that pictures show: one row of the table in picture_options.cpp.
struct ShownQuantity
{
    std::string_view name; ///< for --show
    std::string_view help; ///< a few words
    ShownAs as;
    std::string_view title; ///< of a legend or a menu; [W/m^2] unless the values are colours
    bool on_page;           ///< the page to walk through the room has it too
    bool needs_replicates;  ///< a single run does not tell it
    bool contours;          ///< false colours have lines of equal values
    /// Per patch, >= 0; not a number in the channels where a patch has none.
    std::vector<Rgb> (*values)(const Scene&, const Solution&, int threads);

    /// True for light in the room, which can be shaded and exposed.
    bool is_room() const { return as == ShownAs::room || as == ShownAs::directly_lit_room; }
};

/// All of them, the radiosity first.
std::vector<ShownQuantity> shown_quantities();

/// One of several views, each with a picture of its own.
struct View
{
    std::string name; ///< of its file, without folder and extension
    Camera camera;
};

/// How the user wants pictures to look.
struct PictureOptions
{
    ShownQuantity shown = shown_quantities().front();
    RenderOptions render;
    ToneMapOptions tone;
    Shading mesh_shading = Shading::smooth; ///< of meshes, which hold the radiosity whatever pictures show
    std::optional<Vec3> eye;
    std::optional<Vec3> target;
    std::optional<double> field_of_view; ///< [degrees]
    Vec3 up;
    std::optional<GridPlan> grid; ///< what tables hold instead of patches
    std::vector<View> views;      ///< if there are several: all of them, the first as above
};

/// The options of every command that makes pictures.
OptionGroup picture_option_group();

/// Throws UsageError.
PictureOptions read_picture_options(const CommandLine& line, int threads);

/// Throws SettingsError for a camera of the user's that has no direction in this scene: before the work.
void require_view(const Scene& scene, const PictureOptions& options);

/// The user's camera; what the user left open is chosen for the scene.
Camera camera_for(const Scene& scene, const PictureOptions& options);

/// The options with the camera that suits the solved light, radiosity [W/m^2] per patch, where the user left it open.
PictureOptions with_camera(PictureOptions options, const Scene& scene, const std::vector<Rgb>& radiosity);

/// One line for the user if nearly all of the picture is black though the scene has light: why, and what helps. Empty
/// if it is not. `radiosity` [W/m^2] is what pictures show of every patch.
std::string black_picture_warning(const Scene& scene, const std::vector<Rgb>& radiosity, const PictureOptions& options);

} // namespace multipath

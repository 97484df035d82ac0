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

/// Conversion of the values of a quantity to a picture.
enum class ShownAs {
    room,              ///< shaded and exposed, as an eye would see it
    directly_lit_room, ///< the same, with light that was reflected only once
    false_colours,     ///< of the mean of the channels, with a legend
    light_of_screen,   ///< values are linear light, 1 is white
    numbers_of_screen, ///< values are pixel values of the file, 1 is white
};

/// A quantity that pictures show: one row of the table in picture_options.cpp.
struct ShownQuantity
{
    std::string_view name; ///< for --show
    std::string_view help; ///< a few words
    ShownAs as;
    std::string_view title; ///< of a legend or a menu; [W/m^2] unless the values are colours
    bool on_page;           ///< also shown by the page to walk through the room
    bool needs_replicates;  ///< unknown after a single run
    bool contours;          ///< false colours have lines of equal values
    /// Per patch, >= 0; NaN in channels where a patch has no value.
    std::vector<Rgb> (*values)(const Scene&, const Solution&, int threads);

    /// True if the values are light in the room, which can be shaded and exposed.
    bool is_room() const { return as == ShownAs::room || as == ShownAs::directly_lit_room; }
};

/// All quantities, the radiosity first.
std::vector<ShownQuantity> shown_quantities();

/// One of several views, each with a picture of its own.
struct View
{
    std::string name; ///< name of its file without folder and extension
    Camera camera;
};

/// The picture options of a command line.
struct PictureOptions
{
    ShownQuantity shown = shown_quantities().front();
    RenderOptions render;
    ToneMapOptions tone;
    Shading mesh_shading = Shading::smooth; ///< of meshes, which always hold the radiosity
    std::optional<Vec3> eye;
    std::optional<Vec3> target;
    std::optional<double> field_of_view; ///< [degrees]
    Vec3 up;
    std::optional<GridPlan> grid; ///< tables hold this grid instead of patches
    std::vector<View> views;      ///< all views if there are several; the first also sets eye, target, ... above
};

/// The options of every command that makes pictures.
OptionGroup picture_option_group();

/// Reads these options. Throws UsageError.
PictureOptions read_picture_options(const CommandLine& line, int threads);

/// Throws SettingsError if a camera of the user has no direction in this scene. To be called before the work.
void require_view(const Scene& scene, const PictureOptions& options);

/// The user's camera. Parts that the user did not give are chosen for the scene.
Camera camera_for(const Scene& scene, const PictureOptions& options);

/// The options with a complete camera: parts that the user did not give are chosen for the radiosity [W/m^2] per patch.
PictureOptions with_camera(PictureOptions options, const Scene& scene, const std::vector<Rgb>& radiosity);

/// A warning of one line, with reason and remedy, if more than 90 % of the picture is black although the scene has
/// light; otherwise empty. `radiosity` [W/m^2] is what pictures show of every patch.
std::string black_picture_warning(const Scene& scene, const std::vector<Rgb>& radiosity, const PictureOptions& options);

} // namespace multipath

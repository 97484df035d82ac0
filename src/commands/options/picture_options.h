#pragma once

#include "cli/options/command_line.h"
#include "image/camera.h"
#include "image/gather/light_grid.h"
#include "image/render.h"
#include "radiosity/run/solution.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Conversion of the values of a quantity to a picture.
enum class ShownAs {
    room,              ///< shaded and exposed, as an eye would see the room
    directly_lit_room, ///< the same with light that was reflected only once
    false_colours,     ///< false colours of the mean of the channels, with a legend
    light_of_screen,   ///< the values are linear light of the screen; 1 is white
};

/// A quantity that pictures show: one row of the table in picture_options.cpp.
struct ShownQuantity
{
    std::string_view name; ///< value of --show
    std::string_view help; ///< a few words
    ShownAs as;
    std::string_view title; ///< title of a legend or a menu entry, without the unit
    bool on_page;           ///< true: the page to walk through the room shows the quantity as well
    bool needs_replicates;  ///< true: the values are unknown after a single run
    bool contours;          ///< true: false colours get lines of equal values
    /// The values per patch, [W/m^2] unless they are colours, >= 0; NaN in channels where a patch has no value.
    std::vector<Rgb> (*values)(const Scene&, const Solution&, int threads);

    /// True if the values are light in the room, which can be shaded and exposed.
    bool is_room() const { return as == ShownAs::room || as == ShownAs::directly_lit_room; }
};

/// All quantities, the radiosity first.
std::vector<ShownQuantity> shown_quantities();

/// A view of the scene, as far as the user has chosen it.
struct View
{
    std::string name = "camera"; ///< or that of its --camera file, without folder and extension
    std::optional<Vec3> eye;     ///< [m]; absent: chosen automatically
    std::optional<Vec3> target;  ///< [m]; absent: the centre of the scene if `eye` is given, otherwise chosen with it
    std::optional<double> field_of_view; ///< [degrees]; absent: 60 if `eye` is given, otherwise chosen with it
    Vec3 up = {0.0, 1.0, 0.0};           ///< upward direction
};

/// The picture options of a command line.
struct PictureOptions
{
    ShownQuantity shown = shown_quantities().front();
    RenderOptions render;
    ToneMapOptions tone;
    Shading mesh_shading = Shading::smooth; ///< shading of meshes; they always hold the radiosity, whatever is shown
    std::optional<GridPlan> grid;           ///< if set, tables hold the irradiance on this grid instead of patches
    std::vector<View> views = {View{}};     ///< at least one; each of several, by --camera, gets pictures of its own
};

/// The options of every command that makes pictures.
OptionGroup picture_option_group();

/// Reads these options. Throws UsageError, and InputError for a faulty file of --camera.
PictureOptions read_picture_options(const CommandLine& line, int threads);

/// Throws SettingsError if a camera that the user gave is invalid in this scene (see PixelRays), for example if it has
/// no viewing direction. To be called before the work.
void require_view(const Scene& scene, const PictureOptions& options);

/// The camera of a view. Parts that the user did not give are chosen for the scene and, if it is known, for the
/// radiosity [W/m^2] per patch.
Camera camera_for(const Scene& scene, const PictureOptions& options, const View& view,
                  const std::vector<Rgb>& radiosity = {});

/// The options with complete views. Parts that the user did not give are chosen for the radiosity [W/m^2] per patch.
PictureOptions with_camera(PictureOptions options, const Scene& scene, const std::vector<Rgb>& radiosity);

} // namespace multipath

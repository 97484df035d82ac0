#pragma once

#include "cli/options/command_line.h"
#include "cli/options/option_table.h"
#include "image/camera.h"
#include "image/render.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// The quantity of a solution that a picture shows.
enum class Shown { radiosity, direct, irradiance, error, unshot, patches, normals };

/// True for the room as an eye might see it, to be shaded and exposed.
bool shows_room(Shown shown);

/// How the user wants pictures to look.
struct PictureOptions
{
    Shown shown = Shown::radiosity;
    RenderOptions render;
    ToneMapOptions tone;
    Shading mesh_shading = Shading::smooth; ///< of meshes, which hold the radiosity whatever pictures show
    std::optional<Vec3> eye;
    std::optional<Vec3> target;
    std::optional<double> field_of_view; ///< [degrees]
    Vec3 up;
};

/// The options of every command that makes pictures.
OptionGroup picture_option_group();

/// Throws UsageError; InputError for a picture that the memory cannot hold.
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

#pragma once

#include "cli/files/output_file.h"
#include "cli/options/command_line.h"
#include "commands/options/picture_options.h"
#include "export/lightmap/lightmap.h"
#include "export/mesh/gltf_nodes.h"
#include "export/mesh/patch_mesh.h"
#include "radiosity/run/solve.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The formats in which `solve` and the commands like it write a solution.

namespace multipath {

/// A solution and everything that the formats need. Data that several files share are computed once, when they are
/// first needed.
class SolvedScene
{
public:
    /// Makes the bytes of a file that cannot be made from the solution alone. Called at most once for each file.
    using Bytes = std::function<std::string()>;

    /// `origin`: provenance of the outputs. The arguments passed by reference must outlive the object.
    SolvedScene(const Scene& of_scene, const Solution& of_solution, const PictureOptions& picture_options,
                const std::vector<std::string>& origin, Bytes state_bytes, Bytes page_bytes);

    const Scene& scene;
    const Solution& solution;
    const PictureOptions& options;
    const std::vector<std::string>& comments; ///< provenance, for formats that can hold text
    const Bytes state;                        ///< bytes of a state file
    const Bytes page;                         ///< bytes of a page

    void show(std::size_t view); ///< selects the view with this index in options.views; initially the first

    std::string one_comment() const;        ///< all comments in one line
    const std::vector<Rgb>& shown_values(); ///< per patch: the quantity that pictures show [W/m^2], or a colour [1]
    Image light();                          ///< the picture of these values, not tone-mapped
    const ScreenImage& screen();            ///< the picture for a screen
    const LightGrid& grid();                ///< the grid of --grid, which must be given
    /// One line for the user with the statistics of the grid; empty if grid() was not called.
    std::string grid_summary() const;
    const Lightmap& lightmap(); ///< lightmap of the radiosity
    /// [m^2/W] Scale from radiosity to the linear colours of GLB meshes and lightmaps, which are clipped at 1.
    double linear_colour_scale() const;
    std::string lightmap_png();
    std::string file_name;         ///< name of the current output, without folder
    const PatchMesh& mesh();       ///< mesh with the radiosity at its corners
    const PatchMesh& plain_mesh(); ///< the same, but without the detail of textures in the radiosity
    double mesh_scale();           ///< [m^2/W] scale by picture_scale(), for the colours of PLY and OBJ meshes
    ScreenColour mesh_colour();    ///< function from radiosity to the colours of these meshes
    std::vector<GlbCamera> mesh_cameras() const; ///< one for each view, or the only camera if options.views is empty
    std::vector<std::string> mesh_comments();    ///< the comments, and one with mesh_scale()

private:
    Camera camera() const;

    std::size_t view_ = 0;
    std::optional<std::vector<Rgb>> shown_values_;
    std::optional<ScreenImage> screen_;
    std::optional<LightGrid> grid_;
    std::optional<Lightmap> lightmap_;
    std::optional<PatchMesh> mesh_;
    std::optional<PatchMesh> plain_mesh_; ///< only in scenes with textures
    std::optional<double> mesh_scale_;
};

/// Kinds of formats in the order in which files are made: the quickest first. If a signal ends the program, the
/// remaining files can be made from the state.
enum class FormatKind { state, table, mesh, picture, page };

/// A format: one row of the table in formats.cpp. A new format is a function in `image` or `export` and a row.
struct OutputFormat
{
    std::string_view extension; ///< ".ppm" or "_lightmap.glb", see output_extension()
    FormatKind kind;
    std::string_view summary;           ///< a few words
    bool by_default;                    ///< true: written if no output is named
    std::string (*bytes)(SolvedScene&); ///< makes the content of a file
};

/// All formats. The first one is used for standard output.
std::vector<OutputFormat> output_formats();

/// The kind of the format that the ending of a file name selects. Throws UsageError with the list of extensions if
/// there is none.
FormatKind kind_of(const std::string& path);

/// True if one of the outputs is of this kind.
bool has_kind(const std::vector<PlannedOutput>& outputs, FormatKind kind);

/// True if one of the outputs needs a camera: a mesh, a picture or a page.
bool has_view(const std::vector<PlannedOutput>& outputs);

/// The options --output, --quiet, ... of every command that writes solutions.
OptionGroup solution_output_group();

/// The default outputs for an input NAME.*: NAME.ppm and NAME.png in the working directory.
std::vector<std::string> default_outputs(const std::string& path);

/// Calls open_outputs() with these formats and throws the same errors. If there are several views, every picture
/// becomes one file for each view: "room.png" becomes "room-door.png" for the view `door`; a picture on standard output
/// is a UsageError in this case.
std::vector<PlannedOutput> open_solution_outputs(const std::vector<std::string>& paths,
                                                 const std::vector<std::string>& inputs,
                                                 const std::vector<View>& views);

/// A warning of one line for each PLY whose coordinates are not those of the scene (see mesh_origin()).
std::string moved_coordinates_warning(const std::vector<PlannedOutput>& outputs, const Scene& scene);

/// Writes every output in its format and commits all. Throws OutputError. Throws InputError if a format cannot hold the
/// result, and SettingsError for a grid that has no points or more than a million.
void write_outputs(std::vector<PlannedOutput>& outputs, SolvedScene& solved);

} // namespace multipath

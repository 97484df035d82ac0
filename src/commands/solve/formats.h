#pragma once

#include "cli/files/output_file.h"
#include "cli/options/command_line.h"
#include "commands/options/picture_options.h"
#include "export/mesh/glb.h"
#include "export/mesh/lightmap.h"
#include "export/mesh/patch_mesh.h"
#include "radiosity/solve.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The formats in which `solve` and the commands like it write a solution.

namespace multipath {

/// A solution and all that formats are made of. What several files share is made once, for the first of them.
class SolvedScene
{
public:
    /// Bytes that tell more than the solution does; called at most once for each file.
    using Bytes = std::function<std::string()>;

    /// All references must outlive it.
    SolvedScene(const Scene& of_scene, const Solution& of_solution, const PictureOptions& picture_options,
                const std::vector<std::string>& origin, Bytes state_bytes, Bytes page_bytes);

    const Scene& scene;
    const Solution& solution;
    const PictureOptions& options;
    const std::vector<std::string>& comments; ///< origin, for formats that have a place for text
    const Bytes state;
    const Bytes page;

    void show(std::size_t view); ///< of the options' views, from now on; the first at the start

    std::string one_comment() const;
    const std::vector<Rgb>& shown_values(); ///< of the quantity that pictures show, per patch
    Image light();                          ///< the picture as numbers
    const ScreenImage& screen();            ///< the picture for a screen
    const LightGrid& grid();                ///< of --grid, which must be given
    /// What it comes to, for people; empty if no table was written of it.
    std::string grid_summary() const;
    const Lightmap& lightmap();
    double linear_colour_scale() const; ///< [m^2/W] of colours that end at 1, in meshes and lightmaps
    std::string lightmap_png();
    std::string file_name;         ///< of the output that is made, without folder
    const PatchMesh& mesh();       ///< with the radiosity at its corners
    const PatchMesh& plain_mesh(); ///< the same without the detail of textures
    double mesh_scale();           ///< [m^2/W] exposure of the mesh's colours, that of pictures of it
    ScreenColour mesh_colour();
    std::vector<GlbCamera> mesh_cameras();    ///< of all views
    std::vector<std::string> mesh_comments(); ///< with the scale

private:
    const Camera& camera();

    std::size_t view_ = 0;
    std::optional<Camera> camera_;
    std::optional<std::vector<Rgb>> shown_values_;
    std::optional<ScreenImage> screen_;
    std::optional<LightGrid> grid_;
    std::optional<Lightmap> lightmap_;
    std::optional<PatchMesh> mesh_;
    std::optional<PatchMesh> plain_mesh_; ///< of scenes with textures
    std::optional<double> mesh_scale_;
};

/// In the order in which files are made: first what is quick, so that what a signal costs can be made again from it.
enum class FormatKind { state, table, mesh, picture, page };

/// A format: one row of the table in formats.cpp. A new one is a function in `image` or `export` and a row.
struct OutputFormat
{
    std::string_view extension; ///< ".ppm"
    FormatKind kind;
    std::string_view summary; ///< a few words
    bool by_default;          ///< written when no output is named
    std::string (*bytes)(SolvedScene&);
};

/// All formats; the first one is that of standard output.
std::vector<OutputFormat> output_formats();

/// The kind that a file's extension names. Throws UsageError with the list of extensions.
FormatKind kind_of(const std::string& path);

/// True if one of the outputs is of this kind.
bool has_kind(const std::vector<PlannedOutput>& outputs, FormatKind kind);

/// True if one of them shows the scene from a camera, or with the exposure of such a picture.
bool has_view(const std::vector<PlannedOutput>& outputs);

/// --output, --quiet and the like, of every command that writes solutions.
OptionGroup solution_output_group();

/// For a file NAME.*: NAME.ppm and whatever else is written by default, in the working directory.
std::vector<std::string> default_outputs(const std::string& path);

/// open_outputs() with these formats. Of several views every picture becomes one for each: "room.png" becomes
/// "room-door.png" for the view `door`.
std::vector<PlannedOutput> open_solution_outputs(const std::vector<std::string>& paths,
                                                 const std::vector<std::string>& inputs,
                                                 const std::vector<View>& views);

/// Fills every output in its format and puts all into place. Throws OutputError.
void write_outputs(std::vector<PlannedOutput>& outputs, SolvedScene& solved);

} // namespace multipath

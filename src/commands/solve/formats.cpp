#include "commands/solve/formats.h"

#include "export/mesh/glb.h"
#include "export/mesh/obj_colours.h"
#include "export/mesh/patch_mesh.h"
#include "export/mesh/ply.h"
#include "export/patch_table.h"
#include "image/false_colour/false_colour.h"
#include "image/false_colour/quantity.h"
#include "image/pixmap.h"
#include "image/png.h"
#include "image/render.h"
#include "image/shading/smooth_shading.h"
#include "image/tone_map.h"
#include "radiosity/reuse/gathered_light.h"
#include "scene/text/text_format.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace multipath {

namespace {

constexpr std::array<FormatDescription, 9> known_formats = {
    {{OutputFormat::ppm, FormatKind::picture, ".ppm", "picture, binary PPM (P6)"},
     {OutputFormat::pfm, FormatKind::picture, ".pfm", "picture as numbers, W/m^2, not tone-mapped"},
     {OutputFormat::png, FormatKind::picture, ".png", "picture"},
     {OutputFormat::csv, FormatKind::numbers, ".csv", "table; of a solved scene one row per patch"},
     {OutputFormat::ply, FormatKind::mesh, ".ply", "mesh with the light as colours and as numbers"},
     {OutputFormat::glb, FormatKind::mesh, ".glb", "the same, for three.js and Blender"},
     {OutputFormat::obj, FormatKind::mesh, ".obj", "the same, for MeshLab"},
     {OutputFormat::html, FormatKind::page, ".html", "page to walk through the room in a browser"},
     {OutputFormat::state, FormatKind::numbers, ".state", "all of the run, to go on, merge or render again"}}};

std::vector<std::string_view> known_extensions()
{
    std::vector<std::string_view> extensions;
    for (const FormatDescription& known : known_formats)
        extensions.push_back(known.extension);
    return extensions;
}

const FormatDescription& format_with(std::string_view extension)
{
    return *std::find_if(known_formats.begin(), known_formats.end(),
                         [&](const FormatDescription& known) { return known.extension == extension; });
}

FormatKind kind_of(const PlannedOutput& output)
{
    return format_with(output.extension).kind;
}

PatchMesh mesh_of(const Scene& scene, const Solution& solution, Shading shading, int threads)
{
    const bool has_error = !solution.standard_error.empty();
    if (shading == Shading::flat)
        return patch_mesh(scene, flat_corners(solution.radiosity),
                          has_error ? flat_corners(solution.standard_error) : CornerFunction(), threads);
    const auto corners_of = [](const SmoothShading& smooth) {
        return [&smooth](std::uint32_t patch) { return smooth.at_corners(patch); };
    };
    const SmoothShading radiosity(scene, solution.radiosity, threads);
    if (!has_error)
        return patch_mesh(scene, corners_of(radiosity), {}, threads);
    const SmoothShading error(scene, solution.standard_error, threads);
    return patch_mesh(scene, corners_of(radiosity), corners_of(error), threads);
}

Quantity shown_quantity(const Scene& scene, const Solution& solution, Shown shown, int threads)
{
    switch (shown) {
    case Shown::direct:
        return {"direct radiosity [W/m\xB2]", direct_radiosity(scene, threads)};
    case Shown::unshot:
        return {"unshot radiosity [W/m\xB2]", magnitudes(solution.unshot)};
    case Shown::normals:
        return {"normals", normal_colours(scene)};
    case Shown::irradiance:
        return {"irradiance [W/m\xB2]", irradiance(scene, solution.radiosity)};
    case Shown::error:
        return {"standard error of the radiosity [W/m\xB2]", solution.standard_error};
    case Shown::patches:
        return {"patches", patch_colours(scene.patch_count())};
    case Shown::radiosity:
        break;
    }
    return {"radiosity [W/m\xB2]", solution.radiosity};
}

/// The light that makes a screen's numbers those of the colours.
std::vector<Rgb> decoded(std::vector<Rgb> colours)
{
    for (Rgb& colour : colours)
        colour = srgb_decoded(colour);
    return colours;
}

/// The quantity that pictures show, and from where.
struct View
{
    Camera camera;
    Quantity quantity;
};

ScreenImage screen_picture(const Scene& scene, const Quantity& quantity, const Camera& camera,
                           const PictureOptions& options)
{
    if (shows_room(options.shown))
        return picture(scene, quantity.values, camera, options.render, options.tone);
    if (options.shown == Shown::patches)
        return flat_picture(scene, quantity.values, camera, options.render);
    if (options.shown == Shown::normals)
        return flat_picture(scene, decoded(quantity.values), camera, options.render);
    return false_colour(scene, quantity, camera, options.render);
}

/// The bytes of every file of a solution. What several files share is made once, for the first of them.
class SolutionFiles
{
public:
    /// The arguments must outlive it.
    SolutionFiles(const Scene& scene, const Solution& solution, const PictureOptions& options,
                  const std::vector<std::string>& comments, const FormatMakers& makers)
        : scene_(scene), solution_(solution), options_(options), comments_(comments), makers_(makers)
    {
    }

    std::string bytes(OutputFormat format)
    {
        switch (format) {
        case OutputFormat::ppm:
            return ppm_bytes(screen(), one_comment());
        case OutputFormat::png:
            return png_bytes(screen(), one_comment());
        case OutputFormat::pfm:
            return pfm_bytes(render(scene_, view().quantity.values, view().camera, options_.render));
        case OutputFormat::csv:
            return patch_table(scene_, solution_.radiosity, solution_.standard_error, comments_,
                               options_.render.threads);
        case OutputFormat::ply:
            return ply();
        case OutputFormat::glb:
            return glb_bytes(mesh(), scene_,
                             std::exp2(options_.tone.exposure) * linear_scale(scene_, solution_.radiosity), comments_);
        case OutputFormat::obj:
            return obj();
        case OutputFormat::html:
        case OutputFormat::state:
            break;
        }
        return makers_.at(format)();
    }

private:
    const View& view()
    {
        if (!view_)
            view_ = View{camera_for(scene_, options_),
                         shown_quantity(scene_, solution_, options_.shown, options_.render.threads)};
        return *view_;
    }

    const ScreenImage& screen()
    {
        if (screen_.bytes.empty())
            screen_ = screen_picture(scene_, view().quantity, view().camera, options_);
        return screen_;
    }

    const PatchMesh& mesh()
    {
        if (!mesh_)
            mesh_ = mesh_of(scene_, solution_, options_.mesh_shading, options_.render.threads);
        return *mesh_;
    }

    std::string ply()
    {
        const double scale = mesh_scale();
        return ply_bytes(mesh(), solution_.radiosity, colour(scale), mesh_comments(scale));
    }

    std::string obj()
    {
        const double scale = mesh_scale();
        return obj_text(mesh(), scene_, colour(scale), mesh_comments(scale));
    }

    /// Exposure of a mesh, that of pictures of it.
    double mesh_scale() const
    {
        return picture_scale(scene_, solution_.radiosity, camera_for(scene_, options_), options_.render, options_.tone);
    }

    ScreenColour colour(double scale) const
    {
        const ToneOperator tone = options_.tone.tone;
        return [tone, scale](Rgb radiosity) { return srgb_encoded(screen_light(radiosity, tone, scale)); };
    }

    std::vector<std::string> mesh_comments(double scale) const
    {
        std::vector<std::string> comments = comments_;
        comments.push_back(format("colours: sRGB after the tone map of %.17g m^2/W * radiosity", scale));
        return comments;
    }

    std::string one_comment() const
    {
        std::string comment;
        for (const std::string& part : comments_)
            comment += (comment.empty() ? "" : "; ") + part;
        return comment;
    }

    const Scene& scene_;
    const Solution& solution_;
    const PictureOptions& options_;
    const std::vector<std::string>& comments_;
    const FormatMakers& makers_;
    std::optional<View> view_;
    ScreenImage screen_;
    std::optional<PatchMesh> mesh_;
};

std::vector<PlannedOutput*> quickest_first(std::vector<PlannedOutput>& outputs)
{
    std::vector<PlannedOutput*> result;
    for (PlannedOutput& output : outputs)
        result.push_back(&output);
    std::stable_sort(result.begin(), result.end(),
                     [](const PlannedOutput* a, const PlannedOutput* b) { return kind_of(*a) < kind_of(*b); });
    return result;
}

} // namespace

const std::array<FormatDescription, 9>& output_formats()
{
    return known_formats;
}

OutputFormat output_format(const std::string& path)
{
    return format_with(output_extension(path, known_extensions())).format;
}

OutputFormat format_of(const PlannedOutput& output)
{
    return format_with(output.extension).format;
}

OptionGroup solution_output_group()
{
    return {"Output",
            {{"output", 'o', "FILE", "",
              "Where to write; by extension .ppm, .png, .pfm (pictures), .ply, .glb, .obj (meshes whose vertices "
              "have the light as colours), .csv (one row per patch), .html (a page to walk through the room in a "
              "browser) or .state (all of the run, to go on or render again). '-' writes a PPM to standard output. "
              "Without it, a .ppm and a .png with the name of the input are written here.",
              true},
             {"json", 0, "", "", "Print a machine-readable summary on standard output."},
             {"quiet", 'q', "", "", "Print nothing on stderr but errors."},
             {"verbose", 'v', "", "", "Also show where the power is after every stage."},
             {"progress", 0, "WHEN", "auto", "Show progress on stderr.", false, {"auto", "always", "never"}}}};
}

std::vector<std::string> default_outputs(const std::string& path)
{
    std::string name = path.substr(path.find_last_of('/') + 1);
    const std::size_t dot = name.find_last_of('.');
    if (dot != std::string::npos && dot > 0)
        name.resize(dot);
    return {name + ".ppm", name + ".png"};
}

bool wants_pictures(const std::vector<std::string>& paths)
{
    return paths.empty() || std::any_of(paths.begin(), paths.end(), [](const std::string& path) {
               return format_with(output_extension(path, known_extensions())).kind == FormatKind::picture;
           });
}

std::vector<PlannedOutput> open_solution_outputs(const std::vector<std::string>& paths,
                                                 const std::vector<std::string>& inputs)
{
    return open_outputs(paths, inputs, known_extensions());
}

bool has_format(const std::vector<PlannedOutput>& outputs, OutputFormat format)
{
    return std::any_of(outputs.begin(), outputs.end(),
                       [&](const PlannedOutput& output) { return format_of(output) == format; });
}

bool has_view(const std::vector<PlannedOutput>& outputs)
{
    return std::any_of(outputs.begin(), outputs.end(),
                       [](const PlannedOutput& output) { return kind_of(output) != FormatKind::numbers; });
}

void write_outputs(std::vector<PlannedOutput>& outputs, const Scene& scene, const Solution& solution,
                   const PictureOptions& picture_options, const std::vector<std::string>& comments,
                   const FormatMakers& makers)
{
    SolutionFiles files(scene, solution, picture_options, comments, makers);
    for (PlannedOutput* const output : quickest_first(outputs)) {
        output->file.write(files.bytes(format_of(*output)));
        output->file.complete();
    }
    commit(outputs);
}

} // namespace multipath

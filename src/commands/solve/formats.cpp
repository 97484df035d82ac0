#include "commands/solve/formats.h"

#include "base/elementary.h"
#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/text_format.h"
#include "cli/files/standard_streams.h"
#include "cli/provenance.h"
#include "commands/options/memory_limit.h"
#include "commands/solve/solution_page.h"
#include "commands/solve/solve_job.h"
#include "export/csv_text.h"
#include "export/lightmap/lightmap.h"
#include "export/lightmap/lightmap_glb.h"
#include "export/mesh/coloured_mesh.h"
#include "export/mesh/glb.h"
#include "export/mesh/gltf_nodes.h"
#include "export/mesh/linear_scale.h"
#include "export/mesh/patch_mesh.h"
#include "export/patch_table.h"
#include "image/false_colour.h"
#include "image/image.h"
#include "image/png.h"
#include "image/shading/smooth_shading.h"
#include "image/tone_map.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>

namespace multipath {

namespace {

ScreenImage screen_picture(const Scene& scene, const std::vector<Rgb>& values, const Camera& camera,
                           const PictureOptions& options)
{
    switch (options.shown.as) {
    case ShownAs::room:
    case ShownAs::directly_lit_room:
        return picture(scene, values, camera, options.render, options.tone);
    case ShownAs::light_of_screen:
        return flat_picture(scene, values, camera, options.render);
    case ShownAs::false_colours:
        break;
    }
    return false_colour(scene,
                        {std::string(options.shown.title) + " [" + light_units(scene.file()).per_area_latin1 + "]",
                         values, options.shown.contours},
                        camera, options.render);
}

/// The origin of a result: its provenance, and what the defaults of the command were for this scene.
std::vector<std::string> origin(const SolveJob& job, const Scene& scene, const Solution& solution)
{
    std::vector<std::string> facts = provenance(job.line, scene);
    facts.push_back("run: method " + std::string(job.options.method->name) + ", sequence " + job.sequence + ", " +
                    std::to_string(solution.all_lines) + " lines, " + std::to_string(scene.patch_count()) +
                    (scene.levels().empty() ? "" : " adaptive") + " patches");
    return facts;
}

} // namespace

/// A solved scene and the parts of its files, computed when they are first needed; those that several files share are
/// kept.
class SolvedScene
{
public:
    /// `has_view`: some output needs a camera. The references must outlive the object.
    SolvedScene(const SolveJob& job, const Scene& solved, const Solution& result, const std::string& bytes_of_state,
                bool has_view)
        : scene(solved), solution(result), state(bytes_of_state), comments(origin(job, solved, result)), job_(job)
    {
        options = has_view ? with_camera(job.pictures, scene, solution.radiosity) : job.pictures;
        if (has_view)
            shown = options.shown.values(scene, solution, threads());
    }

    const Scene& scene;
    const Solution& solution;
    const std::string& state;                ///< bytes of a state file
    const std::vector<std::string> comments; ///< provenance, for formats that can hold text
    PictureOptions options;                  ///< with complete views
    std::vector<Rgb> shown;                  ///< per patch: what pictures show [W/m^2], or a colour [1]

    /// Selects the view with this index in options.views; initially the first.
    void show(std::size_t view)
    {
        if (view != view_)
            screen_.reset();
        view_ = view;
    }

    /// All comments in one line.
    std::string one_comment() const { return join(comments, "; "); }

    Camera camera() const { return camera_for(scene, options, options.views[view_]); }

    /// The picture for a screen.
    const ScreenImage& screen()
    {
        return once(screen_, [&] { return screen_picture(scene, shown, camera(), options); });
    }

    /// The picture as numbers.
    Image linear() const { return render(scene, shown, camera(), options.render); }

    /// The grid of --grid, which must be given.
    const LightGrid& grid()
    {
        constexpr int rays = 1024;
        return once(grid_, [&] { return light_grid(scene, solution.radiosity, *options.grid, rays, threads()); });
    }

    /// One line for the user with the statistics of the grid; empty if grid() was not called.
    std::string grid_note() const { return grid_ ? "grid       " + light_grid_summary(scene, *grid_) + "\n" : ""; }

    /// The lightmap of the radiosity.
    const Lightmap& lightmap()
    {
        return once(lightmap_, [&] {
            const ShownRadiosity radiosity(scene, solution.radiosity, threads());
            const auto light = [&](std::uint32_t surface, bool front, double u, double v) {
                return radiosity.at({0.0, surface, u, v, front});
            };
            return multipath::lightmap(scene, default_lightmap_size, light, threads());
        });
    }

    std::string lightmap_png()
    {
        const Lightmap& map = lightmap();
        const double scale = linear_colour_scale();
        ScreenImage image{static_cast<int>(map.width), static_cast<int>(map.height), {}};
        image.bytes.reserve(3 * map.texels.size());
        for (const Rgb& texel : map.texels)
            for (const double channel : {texel.r, texel.g, texel.b})
                image.bytes.push_back(screen_byte(scale * channel));
        return png_bytes(image, one_comment());
    }

    /// [m^2/W] Scale from radiosity to the linear colours of GLB meshes and lightmaps, which are clipped at 1.
    double linear_colour_scale() const
    {
        return elementary::pow(2.0, options.tone.exposure) * linear_scale(scene, solution.radiosity);
    }

    /// The mesh with the radiosity at its corners.
    const PatchMesh& mesh()
    {
        return once(mesh_, [&] { return mesh_with(solution.radiosity); });
    }

    /// The same, but without the detail of textures in the radiosity.
    const PatchMesh& plain_mesh()
    {
        if (scene.file().textures.empty())
            return mesh();
        return once(plain_mesh_, [&] { return mesh_with(without_texture(scene, solution.radiosity)); });
    }

    /// Function from radiosity to the colours of PLY and OBJ meshes.
    ScreenColour mesh_colour()
    {
        return [tone = options.tone.tone, scale = mesh_scale()](Rgb radiosity) {
            return srgb_encoded(screen_light(radiosity, tone, scale));
        };
    }

    /// The comments, and one with the scale of these colours.
    std::vector<std::string> mesh_comments()
    {
        std::vector<std::string> all = comments;
        all.push_back(format("colours: sRGB after the tone map of %.17g m^2/W * radiosity", mesh_scale()));
        return all;
    }

    /// A camera for each view.
    std::vector<GlbCamera> mesh_cameras() const
    {
        return mapped(options.views, [&](const View& view) -> GlbCamera {
            const Camera c = camera_for(scene, options, view);
            return {view.name, c.eye, c.target, c.up, c.field_of_view};
        });
    }

    std::string page() const { return solution_page(scene, job_.options, solution, options, comments); }

private:
    /// The kept value, which is made first if there is none.
    template <class Value, class Make>
    static const Value& once(std::optional<Value>& kept, const Make& make)
    {
        if (!kept)
            kept = make();
        return *kept;
    }

    int threads() const { return options.render.threads; }

    /// The mesh with a radiosity per patch, smooth or flat, and with the standard errors if there are any.
    PatchMesh mesh_with(const std::vector<Rgb>& radiosity) const
    {
        const auto corners = [&](const std::vector<Rgb>& values) -> CornerFunction {
            if (values.empty() || options.mesh_shading == Shading::flat)
                return values.empty() ? CornerFunction() : flat_corners(values);
            return [smooth = std::make_shared<const SmoothShading>(scene, values, threads())](std::uint32_t patch) {
                return smooth->at_corners(patch);
            };
        };
        return patch_mesh(scene, corners(radiosity), corners(solution.standard_error), threads());
    }

    /// [m^2/W] By picture_scale(), for the colours of PLY and OBJ meshes.
    double mesh_scale()
    {
        return once(mesh_scale_,
                    [&] { return picture_scale(scene, solution.radiosity, camera(), options.render, options.tone); });
    }

    const SolveJob& job_;
    std::size_t view_ = 0;
    std::optional<ScreenImage> screen_;
    std::optional<LightGrid> grid_;
    std::optional<Lightmap> lightmap_;
    std::optional<PatchMesh> mesh_;
    std::optional<PatchMesh> plain_mesh_; ///< only in scenes with textures
    std::optional<double> mesh_scale_;
};

namespace {

constexpr std::array known_formats = {
    OutputFormat{".ppm", FormatKind::picture, "picture, binary PPM (P6)",
                 [](SolvedScene& s) { return ppm_bytes(s.screen(), s.one_comment()); }},
    OutputFormat{".pfm", FormatKind::picture, "picture as numbers in W/m^2, not tone-mapped",
                 [](SolvedScene& s) { return pfm_bytes(s.linear()); }},
    OutputFormat{".exr", FormatKind::picture, "the same as half floats, OpenEXR",
                 [](SolvedScene& s) { return exr_bytes(s.linear(), s.one_comment()); }},
    OutputFormat{".hdr", FormatKind::picture, "the same as bytes with exponents, Radiance RGBE",
                 [](SolvedScene& s) { return hdr_bytes(s.linear(), s.one_comment()); }},
    OutputFormat{".png", FormatKind::picture, "picture",
                 [](SolvedScene& s) { return png_bytes(s.screen(), s.one_comment()); }},
    OutputFormat{".csv", FormatKind::table, "table; for a solved scene one row per patch",
                 [](SolvedScene& s) {
                     if (s.options.grid) {
                         std::vector<std::string> comments = s.comments;
                         comments.push_back("grid: " + light_grid_summary(s.scene, s.grid()));
                         return comment_lines(comments) + light_grid_table(s.scene, s.grid());
                     }
                     return patch_table(s.scene, s.solution.radiosity, s.solution.standard_error, s.comments,
                                        s.options.render.threads);
                 }},
    OutputFormat{
        ".ply", FormatKind::mesh, "mesh with the light as colours and as numbers",
        [](SolvedScene& s) { return ply_bytes(s.mesh(), s.solution.radiosity, s.mesh_colour(), s.mesh_comments()); }},
    OutputFormat{".glb", FormatKind::mesh, "the same, for three.js and Blender",
                 [](SolvedScene& s) {
                     return glb_bytes(s.plain_mesh(), s.scene, s.linear_colour_scale(), s.mesh_cameras(), s.comments,
                                      texture_files(s.scene), s.camera().up);
                 }},
    OutputFormat{".obj", FormatKind::mesh, "the same, for MeshLab",
                 [](SolvedScene& s) { return obj_text(s.mesh(), s.scene, s.mesh_colour(), s.mesh_comments()); }},
    OutputFormat{"_lightmap.glb", FormatKind::mesh, "the undivided surfaces with the light in one texture",
                 [](SolvedScene& s) {
                     return lightmap_glb(s.scene, s.lightmap(), s.lightmap_png(), s.linear_colour_scale(),
                                         s.mesh_cameras(), s.comments, s.camera().up);
                 }},
    OutputFormat{".html", FormatKind::page, "page to walk through the room in a browser",
                 [](SolvedScene& s) { return s.page(); }},
    OutputFormat{".state", FormatKind::state, "the whole run, to resume, merge or render it",
                 [](SolvedScene& s) { return s.state; }}};

OutputFormat format_with(std::string_view extension)
{
    return row_named(known_formats, "--output", extension);
}

} // namespace

std::vector<OutputFormat> output_formats()
{
    return {known_formats.begin(), known_formats.end()};
}

FormatKind kind_of(const std::string& path)
{
    return format_with(output_extension(path, names_of(known_formats))).kind;
}

bool has_kind(const std::vector<PlannedOutput>& outputs, FormatKind kind)
{
    return std::any_of(outputs.begin(), outputs.end(),
                       [&](const PlannedOutput& output) { return format_with(output.extension).kind == kind; });
}

OptionGroup solution_output_group()
{
    return {"Output",
            {{"output", 'o', "FILE", "",
              "Output file, by its extension " + join(names_of(known_formats)) +
                  "; see 'help outputs'. '-' writes the first of these to standard output. By default a .ppm and a "
                  ".png with the name of the input.",
              true},
             {"json", 0, "", "", "Print a machine-readable summary on standard output."},
             {"quiet", 'q', "", "", "Print only errors on stderr."},
             {"verbose", 'v', "", "", "Also show the balance of power after every stage."}}};
}

std::vector<std::string> default_outputs(const std::string& path)
{
    const std::string name = path_of(path).stem().u8string();
    return {name + ".ppm", name + ".png"};
}

std::vector<PlannedOutput> open_solution_outputs(const CommandLine& line, const std::vector<std::string>& paths,
                                                 const std::vector<std::string>& inputs, const PictureOptions& pictures)
{
    const std::vector<View>& views = pictures.views;
    std::vector<std::string> names;
    std::vector<std::size_t> shown;
    for (const std::string& path : paths) {
        const bool several = views.size() > 1 && kind_of(path) == FormatKind::picture;
        if (several && path == "-")
            throw UsageError("--camera: standard output takes one picture, not one for each view; expected -o FILE");
        for (std::size_t k = 0; k < (several ? views.size() : 1); ++k) {
            const std::size_t end = path.size() - output_extension(path, names_of(known_formats)).size();
            names.push_back(several ? path.substr(0, end) + "-" + views[k].name + path.substr(end) : path);
            shown.push_back(k);
        }
    }
    std::vector<PlannedOutput> outputs = open_outputs(names, inputs, names_of(known_formats));
    for (std::size_t i = 0; i < outputs.size(); ++i)
        outputs[i].view = shown[i];
    const RenderOptions& render = pictures.render;
    if (has_kind(outputs, FormatKind::picture))
        require_memory_for_picture(line, render.width, render.height, render.shading == Shading::gather);
    return outputs;
}

namespace {

/// A warning of one line for each PLY whose coordinates are not those of the scene (see mesh_origin()).
std::string moved_coordinates_warning(const std::vector<PlannedOutput>& outputs, const Scene& scene)
{
    std::string text;
    const Vec3 origin = mesh_origin(scene);
    for (const PlannedOutput& output : outputs)
        if (output.extension == ".ply" && origin != Vec3{})
            text += format("warning    %s: the seven digits of its numbers are too few so far from the origin; its "
                           "coordinates are those of the scene less (%.17g, %.17g, %.17g)\n",
                           output.file.name().c_str(), origin.x, origin.y, origin.z);
    return text;
}

} // namespace

std::string write_outputs(std::vector<PlannedOutput>& outputs, const SolveJob& job, const Scene& scene,
                          const Solution& solution, const std::string& state)
{
    const bool has_view = has_kind(outputs, FormatKind::mesh) || has_kind(outputs, FormatKind::picture) ||
                          has_kind(outputs, FormatKind::page);
    SolvedScene solved(job, scene, solution, state, has_view);
    std::multimap<FormatKind, PlannedOutput*> quickest_first;
    for (PlannedOutput& output : outputs)
        quickest_first.emplace(format_with(output.extension).kind, &output);
    for (const auto& [kind, output] : quickest_first) {
        solved.show(output->view);
        output->file.write(format_with(output->extension).bytes(solved));
        output->file.complete();
    }
    commit(outputs);
    std::string names;
    if (job.quiet)
        return names;
    print_note(solved.grid_note() + moved_coordinates_warning(outputs, scene));
    for (const PlannedOutput& output : outputs)
        names += "wrote      " + output.file.name() + "\n";
    return names;
}

} // namespace multipath

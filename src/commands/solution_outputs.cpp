#include "commands/solution_outputs.h"

#include "commands/mesh_outputs.h"
#include "export/patch_table.h"
#include "image/false_colour.h"
#include "image/pfm.h"
#include "image/picture.h"
#include "image/png.h"
#include "image/ppm.h"
#include "image/quantity.h"
#include "image/srgb.h"
#include "radiosity/reuse/gathered_light.h"

#include <algorithm>
#include <optional>

namespace multipath {

namespace {

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

/// What pictures show.
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

std::vector<PlannedOutput*> quickest_first(std::vector<PlannedOutput>& outputs)
{
    const auto effort = [](const PlannedOutput* output) {
        return output->format == OutputFormat::html ? 3 : is_picture(output->format) ? 2 : is_mesh(output->format);
    };
    std::vector<PlannedOutput*> result;
    for (PlannedOutput& output : outputs)
        result.push_back(&output);
    std::stable_sort(result.begin(), result.end(),
                     [&](const PlannedOutput* a, const PlannedOutput* b) { return effort(a) < effort(b); });
    return result;
}

} // namespace

bool has_format(const std::vector<PlannedOutput>& outputs, OutputFormat format)
{
    return std::any_of(outputs.begin(), outputs.end(),
                       [&](const PlannedOutput& output) { return output.format == format; });
}

bool has_view(const std::vector<PlannedOutput>& outputs)
{
    return std::any_of(outputs.begin(), outputs.end(), [](const PlannedOutput& output) {
        return is_picture(output.format) || is_mesh(output.format) || output.format == OutputFormat::html;
    });
}

void write_outputs(std::vector<PlannedOutput>& outputs, const Scene& scene, const Solution& solution,
                   const PictureOptions& picture_options, const std::vector<std::string>& comments,
                   const std::map<OutputFormat, std::function<std::string()>>& makers)
{
    std::string comment;
    for (const std::string& part : comments)
        comment += (comment.empty() ? "" : "; ") + part;

    std::optional<View> view;
    ScreenImage screen;
    std::optional<SolvedMesh> mesh;
    for (PlannedOutput* const planned : quickest_first(outputs)) {
        PlannedOutput& output = *planned;
        const bool shows_screen = output.format == OutputFormat::ppm || output.format == OutputFormat::png;
        if (is_picture(output.format) && !view)
            view = View{
                camera_for(scene, picture_options),
                shown_quantity(scene, solution, picture_options.shown, picture_options.render.threads),
            };
        if (shows_screen && screen.bytes.empty())
            screen = screen_picture(scene, view->quantity, view->camera, picture_options);
        if (is_mesh(output.format) && !mesh)
            mesh.emplace(scene, solution, picture_options);
        if (is_mesh(output.format))
            output.file.write(mesh->bytes(output.format, comments));
        else if (output.format == OutputFormat::ppm)
            output.file.write(ppm_bytes(screen, comment));
        else if (output.format == OutputFormat::png)
            output.file.write(png_bytes(screen, comment));
        else if (output.format == OutputFormat::pfm)
            output.file.write(pfm_bytes(render(scene, view->quantity.values, view->camera, picture_options.render)));
        else if (output.format == OutputFormat::html || output.format == OutputFormat::state)
            output.file.write(makers.at(output.format)());
        else
            output.file.write(patch_table(scene, solution.radiosity, solution.standard_error, comments,
                                          picture_options.render.threads));
        output.file.complete();
    }
    commit(outputs);
}

} // namespace multipath

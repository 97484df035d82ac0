#include "commands/solution_page.h"

#include "commands/viewer_stages.h"
#include "commands/viewer_story.h"
#include "image/quantity.h"
#include "radiosity/reuse/gathered_light.h"
#include "viewer/viewer_page.h"

namespace multipath {

namespace {

std::vector<Rgb> patch_areas(const Scene& scene)
{
    std::vector<Rgb> areas;
    for (const double area : scene.areas())
        areas.push_back({area, area, area});
    return areas;
}

/// What people may choose to see; the radiosity first.
std::vector<ViewerQuantity> quantities(const Scene& scene, const Solution& solution, int threads)
{
    std::vector<ViewerQuantity> result = {
        {"radiosity", "Radiosity", "W/m²", ViewerColours::light, solution.radiosity},
        {"direct", "Direct light", "W/m²", ViewerColours::light, direct_radiosity(scene, threads)},
        {"irradiance", "Irradiance", "W/m²", ViewerColours::scale, irradiance(scene, solution.radiosity)},
        {"area", "Patch size", "m²", ViewerColours::scale, patch_areas(scene)}};
    if (!solution.standard_error.empty())
        result.push_back({"error", "Standard error", "W/m²", ViewerColours::scale, solution.standard_error});
    return result;
}

/// The quantity that pictures would show, or the radiosity.
std::size_t shown_first(const std::vector<ViewerQuantity>& quantities, Shown shown)
{
    const std::string key = shown == Shown::direct       ? "direct"
                            : shown == Shown::irradiance ? "irradiance"
                            : shown == Shown::error      ? "error"
                                                         : "radiosity";
    for (std::size_t k = 0; k < quantities.size(); ++k)
        if (quantities[k].key == key)
            return k;
    return 0;
}

} // namespace

std::string solution_page(const ToldRun& run, const Solution& solution, const PictureOptions& picture_options,
                          const std::vector<std::string>& comments, const ProgressCallback& progress)
{
    ViewerContent content;
    content.record = comments;
    content.camera = camera_for(run.scene, picture_options);
    content.render = picture_options.render;
    content.tone = picture_options.tone;
    content.quantities = quantities(run.scene, solution, run.options.threads);
    content.shown = shown_first(content.quantities, picture_options.shown);
    content.lines = solution.local_lines + solution.global_lines;
    content.stages =
        solve_stages(run.scene, run.options, stage_lines(content.lines, run.scene.patch_count()), progress);
    content.chapters = viewer_story(run);
    return viewer_page(run.scene, content);
}

} // namespace multipath

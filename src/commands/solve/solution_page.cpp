#include "commands/solve/solution_page.h"

#include "base/errors.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "scene/scene_file.h"
#include "viewer/viewer_page.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace multipath {

namespace {

constexpr std::uint64_t most_lines_of_run = std::uint64_t{1} << 16; ///< the trace then takes less than a second

/// Appends a chapter with the first 100, 10 or 1 lines of a stage, as many as it has; none if it has no lines.
void append(std::vector<StageTrace>& chapters, const StageTracer& tracer, const Scene& scene,
            const SolveOptions& options)
{
    for (const std::uint64_t count : {100u, 10u, 1u}) {
        try {
            chapters.push_back(tracer.trace(scene, options, {0, count}));
            StageTrace& trace = chapters.back();
            trace.context.push_back("These are the first " + grouped(count) + " of " + grouped(trace.count) + " " +
                                    trace.kind + "s.");
            return;
        } catch (const InputError&) {
            continue; // the stage has fewer lines
        }
    }
}

/// The quantities that the page can show, the radiosity first.
std::vector<ViewerQuantity> quantities(const Scene& scene, const Solution& solution, int threads)
{
    std::vector<ViewerQuantity> result;
    for (const ShownQuantity& shown : shown_quantities())
        if (shown.on_page && !(shown.needs_replicates && solution.standard_error.empty())) {
            std::string title(shown.title);
            title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
            result.push_back({std::string(shown.name), title, light_units(scene.file()).per_area_utf8, shown.is_room(),
                              shown.values(scene, solution, threads)});
        }
    const std::vector<Rgb> areas = mapped(scene.weights(), [](double area) { return Rgb{area, area, area}; });
    result.push_back({"area", "Patch size", "m²", false, areas});
    return result;
}

} // namespace

std::vector<StageTrace> viewer_chapters(const Scene& scene, const SolveOptions& options)
{
    const Method method = options.method;
    const bool only_counts = !method->traced_as.empty();
    SolveOptions traced = options;
    traced.lines = std::min(options.lines, most_lines_of_run);
    if (only_counts) {
        traced.method = method_named(method->traced_as);
        traced.ratio.reset(); // has another meaning for that method
    }
    std::vector<StageTrace> chapters;
    for (const std::string_view stage : traced_stages(traced.method))
        for (const StageTracer& tracer : stage_tracers)
            if (tracer.stage == stage && stage != later_pass) // chapters show the first pass alone
                append(chapters, tracer, scene, traced);
    if (only_counts)
        for (StageTrace& chapter : chapters)
            chapter.context.push_back("The method " + std::string(method->name) +
                                      " only counts such lines and afterwards solves a linear system: these are the "
                                      "lines of --method " +
                                      std::string(method->traced_as) + ".");
    return chapters;
}

std::string solution_page(const Scene& scene, const SolveOptions& options, const Solution& solution,
                          const PictureOptions& picture_options, const std::vector<std::string>& comments)
{
    ViewerContent content;
    content.record = comments;
    content.camera = camera_for(scene, picture_options, picture_options.views.front());
    content.render = picture_options.render;
    content.tone = picture_options.tone;
    content.quantities = quantities(scene, solution, options.threads);
    content.shown = 0; // the radiosity, if the page does not have what pictures show
    for (std::size_t k = 0; k < content.quantities.size(); ++k)
        if (content.quantities[k].key == picture_options.shown.name)
            content.shown = k;
    content.chapters = viewer_chapters(scene, options);
    return viewer_page(scene, content);
}

} // namespace multipath

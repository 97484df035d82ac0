#include "commands/solve/solution_page.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "commands/explain/trace_drawing.h"
#include "scene/scene_file.h"
#include "viewer/viewer_page.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <string_view>

namespace multipath {

namespace {

constexpr std::uint64_t most_lines_of_run = std::uint64_t{1} << 16; ///< the trace then takes less than a second

std::vector<ViewerLine> viewer_lines(const StageTrace& trace)
{
    std::vector<ViewerLine> lines;
    for (const DrawnLine& shape : drawn_lines(trace)) {
        lines.push_back({shape, {}});
        for (const Transfer& transfer : trace.lines[lines.size() - 1].transfers)
            lines.back().transfers.push_back({transfer.segment, transfer.from,
                                              Segment::is_patch(transfer.to) ? transfer.to : Scene::no_patch,
                                              transfer.forecast, transfer.held, transfer.counted});
    }
    return lines;
}

/// Appends a chapter with the first 100, 10 or 1 lines of a stage, as many as it has; none if it has no lines.
void append(std::vector<ViewerChapter>& chapters, const StageTracer& tracer, const Scene& scene,
            const SolveOptions& options)
{
    for (const std::uint64_t count : {100u, 10u, 1u}) {
        try {
            const StageTrace trace = tracer.trace(scene, options, {0, count});
            chapters.push_back({trace.chapter,
                                trace.chapter_note + " The first " + grouped(trace.lines.size()) + " of " +
                                    grouped(trace.count) + " " + trace.which + ".",
                                viewer_lines(trace)});
            return;
        } catch (const InputError&) {
            continue; // the stage has fewer lines
        }
    }
}

constexpr int first_power = 8;                ///< the first stage has 2^8 lines
constexpr std::uint64_t most_values = 300000; ///< patches of all stages together; each takes about 11 bytes of the page

/// The radiosity with these options; empty if the method cannot work with so few lines, or no surface absorbs light.
std::vector<Rgb> radiosity_with(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
                                const ProgressCallback& progress)
{
    try {
        const Solution solution = solve(scene, preparation, options, progress);
        return mean(solution.balance.absorbed) > 0.0 ? solution.radiosity : std::vector<Rgb>{};
    } catch (const InputError&) {
        return {};
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
            result.push_back({std::string(shown.name), title, light_units(scene.file()).per_area_utf8,
                              shown.is_room() ? ViewerColours::light : ViewerColours::scale,
                              shown.values(scene, solution, threads)});
        }
    std::vector<Rgb> areas;
    for (const double area : scene.weights())
        areas.push_back({area, area, area});
    result.push_back({"area", "Patch size", "m²", ViewerColours::scale, areas});
    return result;
}

} // namespace

std::vector<ViewerChapter> viewer_chapters(const TracedRun& run)
{
    const Method method = run.options.method;
    const bool only_counts = !method->traced_as.empty();
    SolveOptions options = run.options;
    options.lines = std::min(options.lines, most_lines_of_run);
    if (only_counts) {
        options.method = method_named(method->traced_as);
        options.ratio.reset(); // has another meaning for that method
    }
    std::vector<ViewerChapter> chapters;
    for (const std::string_view stage : traced_stages(options.method))
        for (const StageTracer& tracer : stage_tracers)
            if (tracer.stage == stage && stage != later_pass) // chapters show the first pass alone
                append(chapters, tracer, run.scene, options);
    if (only_counts)
        for (ViewerChapter& chapter : chapters)
            chapter.note += " The method " + std::string(method->name) +
                            " only counts such lines and afterwards solves a linear system: these are the lines of "
                            "--method " +
                            std::string(method->traced_as) + ".";
    return chapters;
}

std::vector<std::uint64_t> stage_lines(std::uint64_t lines, std::uint32_t patches)
{
    const std::uint64_t most = std::min<std::uint64_t>(most_values / patches, 20);
    if (most == 0)
        return {};
    for (int step = 2;; step += 2) {
        std::vector<std::uint64_t> result;
        for (int power = first_power; power < 64 && std::uint64_t{1} << power < lines; power += step)
            result.push_back(std::uint64_t{1} << power);
        if (result.size() <= most)
            return result;
    }
}

std::vector<ViewerStage> solve_stages(const Scene& scene, const SolveOptions& options,
                                      const std::vector<std::uint64_t>& lines, const ProgressCallback& progress)
{
    std::vector<ViewerStage> stages;
    if (lines.empty())
        return stages;
    const Preparation preparation = prepare(scene, options);
    const auto all = static_cast<double>(std::accumulate(lines.begin(), lines.end(), std::uint64_t{0}));
    double done = 0.0;
    for (const std::uint64_t count : lines) {
        SolveOptions fewer = options;
        fewer.lines = count;
        const double share = static_cast<double>(count) / all;
        std::vector<Rgb> radiosity =
            radiosity_with(scene, preparation, fewer, [&](double part) { progress(done + share * part); });
        done += share;
        if (!radiosity.empty())
            stages.push_back({count, std::move(radiosity)});
    }
    return stages;
}

std::string solution_page(const TracedRun& run, const Solution& solution, const PictureOptions& picture_options,
                          const std::vector<std::string>& comments, const ProgressCallback& progress)
{
    ViewerContent content;
    content.record = comments;
    content.camera = camera_for(run.scene, picture_options);
    content.render = picture_options.render;
    content.tone = picture_options.tone;
    content.quantities = quantities(run.scene, solution, run.options.threads);
    content.shown = 0; // the radiosity, if the page does not have what pictures show
    for (std::size_t k = 0; k < content.quantities.size(); ++k)
        if (content.quantities[k].key == picture_options.shown.name)
            content.shown = k;
    content.lines = solution.local_lines + solution.global_lines;
    content.stages =
        solve_stages(run.scene, run.options, stage_lines(content.lines, run.scene.patch_count()), progress);
    content.chapters = viewer_chapters(run);
    return viewer_page(run.scene, content);
}

} // namespace multipath

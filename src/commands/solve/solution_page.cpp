#include "commands/solve/solution_page.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "commands/explain/trace_drawing.h"
#include "scene/scene_file.h"
#include "viewer/viewer_page.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <functional>
#include <numeric>
#include <string_view>

namespace multipath {

namespace {

constexpr std::uint64_t most_lines_of_run = std::uint64_t{1} << 16; ///< the trace then takes less than a second

/// The patch that receives power, or Scene::no_patch.
std::uint32_t receiver(std::uint32_t where)
{
    return Segment::is_patch(where) ? where : Scene::no_patch;
}

std::vector<ViewerLine> viewer_lines(const std::vector<GlobalLine>& global_lines)
{
    const std::vector<DrawnLine> drawn = drawn_lines(global_lines);
    std::vector<ViewerLine> lines;
    for (std::size_t n = 0; n < global_lines.size(); ++n) {
        ViewerLine line{drawn[n], {}};
        for (const TracedSegment& traced : global_lines[n].segments)
            for (const Transfer& transfer : traced.transfers)
                line.transfers.push_back({traced.after, transfer.from, receiver(transfer.to), transfer.forecast,
                                          transfer.held, transfer.sent()});
        lines.push_back(line);
    }
    return lines;
}

std::vector<ViewerLine> viewer_lines(const Scene& scene, const ShotTrace& trace)
{
    const std::vector<DrawnLine> drawn = drawn_lines(scene, trace);
    std::vector<ViewerLine> lines;
    for (std::size_t n = 0; n < trace.rays.size(); ++n) {
        const ShotRay& ray = trace.rays[n];
        lines.push_back({drawn[n], {{0, ray.shooter, receiver(ray.where), {}, ray.power, ray.power}}});
    }
    return lines;
}

/// The lines of some paths, whose step k is drawn as segment 2 k: between two steps a path goes on within a patch, for
/// which the drawing has a segment, too. add_transfer(path, k, transfers) adds what step k carries.
template <class AddTransfer>
std::vector<ViewerLine> path_lines(const std::vector<DrawnLine>& drawn, const std::vector<TracedParticle>& paths,
                                   const AddTransfer& add_transfer)
{
    std::vector<ViewerLine> lines;
    for (std::size_t n = 0; n < paths.size(); ++n) {
        lines.push_back({drawn[n], {}});
        for (std::size_t k = 0; k < paths[n].steps.size(); ++k)
            add_transfer(paths[n], k, lines.back().transfers);
    }
    return lines;
}

std::vector<ViewerLine> viewer_lines(const Scene& scene, const ParticleTrace& trace)
{
    return path_lines(
        drawn_lines(scene, trace), trace.particles,
        [](const TracedParticle& path, std::size_t k, std::vector<ViewerTransfer>& transfers) {
            const TracedStep& traced = path.steps[k];
            transfers.push_back(
                {2 * k, traced.step.from, receiver(traced.step.where), {}, traced.step.power, traced.counted});
        });
}

/// A step of a walk brings light from where it arrives to the patch where the walk starts.
std::vector<ViewerLine> viewer_lines(const Scene& scene, const WalkTrace& trace)
{
    return path_lines(drawn_lines(scene, trace), trace.walks,
                      [&](const TracedParticle& path, std::size_t k, std::vector<ViewerTransfer>& transfers) {
                          const std::uint32_t first = path.steps.front().step.from;
                          const Rgb power = scene.area(first) * path.steps[k].counted;
                          if (power != Rgb{})
                              transfers.push_back({2 * k, path.steps[k].step.where, first, {}, power, power});
                      });
}

std::vector<ViewerLine> viewer_lines(const Scene& scene, const JacobiTrace& trace)
{
    const std::vector<DrawnLine> drawn = drawn_lines(scene, trace);
    std::vector<ViewerLine> lines;
    for (std::size_t n = 0; n < trace.rays.size(); ++n) {
        const IterationRay& ray = trace.rays[n].carried;
        ViewerLine line{drawn[n], {{0, ray.from, receiver(ray.to), {}, ray.sent, ray.sent}}};
        if (ray.to_density > 0.0)
            line.transfers.push_back({0, ray.to, ray.from, {}, ray.returned, ray.returned});
        lines.push_back(line);
    }
    return lines;
}

ViewerChapter shots(const TracedRun& run, const TracedRange& range)
{
    const ShotTrace trace = trace_shot_pass(run.scene, run.options, 0, range);
    return {"First shot",
            "Rays carry the light of the sources to the patches that they see, all with the same power. What a patch "
            "reflects of it is unshot until it is sent on. The first " +
                grouped(trace.rays.size()) + " of " + grouped(trace.shot_passes.front().lines) + " rays.",
            viewer_lines(run.scene, trace)};
}

ViewerChapter global_lines(const TracedRun& run, const TracedRange& range)
{
    const GlobalTrace trace = trace_global_pass(run.scene, run.options, range);
    const std::string before =
        trace.local_lines > 0 ? ", after " + grouped(trace.local_lines) + " rays of the first shot" : "";
    return {"Global lines",
            "A line crosses the whole scene. Where it leaves one patch and meets another, the two exchange power: each "
            "sends its forecast, a share of what was unshot, and all that it has received and reflected since. The "
            "first " +
                grouped(trace.lines.size()) + " of " + grouped(trace.lines_cast) + " lines" + before + ".",
            viewer_lines(trace.lines)};
}

ViewerChapter bundle(const TracedRun& run, const TracedRange& range)
{
    const BundleTrace trace = trace_bundle(run.scene, run.options, range);
    return {"Parallel lines",
            "Parallel lines cross the whole scene. Where one leaves a patch and meets another, the two exchange power "
            "according to their radiosities after the last iteration. The first " +
                grouped(trace.lines.size()) + " of " + grouped(trace.lines_cast) + " lines along the first of " +
                grouped(trace.directions) + " directions.",
            viewer_lines(trace.lines)};
}

ViewerChapter particles(const TracedRun& run, const TracedRange& range)
{
    const ParticleTrace trace = trace_particles(run.scene, run.options, range);
    return {"Particles",
            "Particles leave the sources and are reflected from patch to patch, until they are absorbed or leave the "
            "scene. The first " +
                grouped(trace.particles.size()) + " of " + grouped(trace.particle_count) + " particles.",
            viewer_lines(run.scene, trace)};
}

ViewerChapter walks(const TracedRun& run, const TracedRange& range)
{
    const WalkTrace trace = trace_walks(run.scene, run.options, range);
    return {"Walks",
            "Walks leave the patches whose light is wanted and are reflected from patch to patch until they end. Where "
            "they meet a source, its light is added to the patch where they started. The first " +
                grouped(trace.walks.size()) + " of " + grouped(trace.walk_count) + " walks of the first round.",
            viewer_lines(run.scene, trace)};
}

ViewerChapter iteration(const TracedRun& run, const TracedRange& range)
{
    const JacobiTrace trace = trace_iteration(run.scene, run.options, range);
    return {
        "First iteration",
        "All patches send their power, emitted and reflected, by rays in proportion to it" +
            std::string(run.options.bidirectional ? "; a ray also brings back what the patch at its end sends" : "") +
            ". The first " + grouped(trace.rays.size()) + " of " + grouped(trace.ray_count) + " rays, after " +
            grouped(trace.series_rays) + " rays of a first estimate.",
        viewer_lines(run.scene, trace)};
}

struct ChapterKind
{
    std::string_view stage; ///< see MethodInfo::traced; there are no chapters of later passes
    ViewerChapter (*make)(const TracedRun&, const TracedRange&);
};

constexpr std::array<ChapterKind, 6> chapter_kinds = {{{"first-shot", shots},
                                                       {"global", global_lines},
                                                       {"bundle", bundle},
                                                       {"local", particles},
                                                       {"gathering", walks},
                                                       {"iteration", iteration}}};

/// Appends a chapter with the first 100, 10 or 1 lines of a stage, as many as it has; none if it has no lines.
void append(std::vector<ViewerChapter>& chapters, const std::function<ViewerChapter(const TracedRange&)>& make)
{
    for (const std::uint64_t count : {100u, 10u, 1u}) {
        try {
            chapters.push_back(make({0, count}));
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

std::vector<Rgb> patch_areas(const Scene& scene)
{
    std::vector<Rgb> areas;
    for (const double area : scene.weights())
        areas.push_back({area, area, area});
    return areas;
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
    result.push_back({"area", "Patch size", "m²", ViewerColours::scale, patch_areas(scene)});
    return result;
}

/// Index of the quantity that pictures show, or of the radiosity if the page does not have it.
std::size_t shown_first(const std::vector<ViewerQuantity>& quantities, const ShownQuantity& shown)
{
    const auto found = std::find_if(quantities.begin(), quantities.end(),
                                    [&](const ViewerQuantity& quantity) { return quantity.key == shown.name; });
    return found == quantities.end() ? 0 : static_cast<std::size_t>(found - quantities.begin());
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
    const TracedRun walk{run.scene, options, run.method, run.sequence};
    std::vector<ViewerChapter> chapters;
    for (const std::string_view stage : traced_stages(options.method))
        for (const ChapterKind& kind : chapter_kinds)
            if (kind.stage == stage)
                append(chapters, [&](const TracedRange& range) { return kind.make(walk, range); });
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
    content.shown = shown_first(content.quantities, picture_options.shown);
    content.lines = solution.local_lines + solution.global_lines;
    content.stages =
        solve_stages(run.scene, run.options, stage_lines(content.lines, run.scene.patch_count()), progress);
    content.chapters = viewer_chapters(run);
    return viewer_page(run.scene, content);
}

} // namespace multipath

#include "base/errors.h"
#include "base/text_format.h"
#include "explain/stage_trace.h"
#include "explain/trace_lines.h"
#include "explain/words.h"
#include "radiosity/family/stochastic_jacobi.h"
#include "radiosity/family/transillumination.h"

#include <algorithm>

namespace multipath {

namespace {

/// Number of directions of the first iteration.
std::uint64_t directions_of(const BundlePlan& plan, const JacobiIterations& iterations)
{
    if (plan.directions == 0)
        throw SettingsError("this run has too few lines for a direction");
    return std::clamp<std::uint64_t>(iterations.next_lines(plan.directions * plan.bundle) / plan.bundle, 1,
                                     plan.directions);
}

/// The stage without its lines. `rays`: those of the estimate before the first iteration; `lines_to_meet`: number of
/// lines per direction that meet the scene's box, in expectation (N1).
StageTrace bundle_stage(std::uint64_t shot_lines, std::uint64_t rays, std::uint64_t lines_to_meet,
                        std::uint64_t directions, const Bundle& bundle)
{
    return {"Lines of one direction of transillumination",
            {"Before it the first shot took " + counted(shot_lines, "ray", "rays") +
                 ". The power that patches reflected from them is unshot, and " + counted(rays, "ray", "rays") +
                 " from patch to patch gave a first estimate of all light that it brings. The iterations improve it: "
                 "in the first one " +
                 counted(lines_to_meet, "parallel line meets", "parallel lines meet") +
                 " the scene's box along each of " + counted(directions, "direction", "directions") + ".",
             "This direction is " + point_text(bundle.direction()) +
                 ". Through the smallest rectangle that hides the box " +
                 counted(bundle.count(), "line is", "lines are") + " cast; each stands for" +
                 format(" %.4g m^2 of it. ", bundle.section()) +
                 "Along a line that joins two patches, each sends the other its radiosity times twice that, over the "
                 "number of directions (P1)."},
            "line",
            bundle.count()};
}

/// Traces the power along a line through the scene; sent(patch) [W] is what a patch sends along every line.
template <class Sent>
void trace_exchange(const Scene& scene, const Sent& sent, TracedLine& line)
{
    const auto sends = [&](std::size_t after, std::uint32_t from, std::uint32_t to) {
        line.transfers.push_back({after, from, to, sent(from), {}, sent(from)});
        line.notes.push_back(patch_name(scene, from) + " sends " + watts(sent(from)) + destination(scene, to));
    };
    for (std::size_t after = 0; after <= line.crossings.size(); ++after) {
        const Segment segment = segment_after(line, after);
        if (Segment::is_patch(segment.from))
            sends(after, segment.from, segment.to);
        if (Segment::is_patch(segment.to))
            sends(after, segment.to, segment.from);
    }
    if (line.crossings.empty())
        line.notes.push_back("meets nothing");
}

} // namespace

StageTrace trace_bundle(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    Run run(scene, options);
    options.method->stages.front()(run); // the first shot
    run.plan_global_lines();
    const PowerState start = run.state;
    const std::uint64_t rays = estimate_by_rays(run);
    const JacobiIterations iterations(scene, start, run.state, static_cast<double>(rays));
    const BundlePlan plan = plan_bundles(run, rays);
    const std::uint64_t directions = directions_of(plan, iterations);
    const std::uint64_t item = run.next_item() + rays;
    const Item numbers = run.sequence->item(item);
    const Bundle bundle(scene.bounds(), numbers, plan.bundle);
    require_in_stage(range, bundle.count(), "lines along the first direction");

    StageTrace trace = bundle_stage(run.solution.local_lines, rays, plan.bundle, directions, bundle);
    const std::vector<Rgb> power = iterations.power();
    const auto sent = [&](std::uint32_t patch) {
        return power_along_line((1.0 / scene.area(patch)) * power[patch], bundle.section(), directions);
    };
    std::vector<Hit> hits;
    for (std::uint64_t n = range.first; n < range.first + range.count; ++n) {
        const Line line = bundle.line(n);
        scene.intersector().all_hits(line, hits);
        const double past_scene = 2.0 * dot(scene.bounds().centre() - line.origin, line.direction);
        trace.lines.push_back(
            through_scene(scene, {n, item, numbers}, line, line.origin + past_scene * line.direction, hits));
        trace_exchange(scene, sent, trace.lines.back());
    }
    return trace;
}

} // namespace multipath

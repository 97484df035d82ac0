// What a receiver of the first shot has unshot depends on the rays before. So the rays before the range are followed as
// well, but not recorded.

#include "base/errors.h"
#include "base/text_format.h"
#include "explain/stage_trace.h"
#include "explain/trace_lines.h"
#include "explain/words.h"
#include "radiosity/paper/extended_first_shot.h"
#include "radiosity/paper/first_shot.h"
#include "radiosity/paper/line_budget.h"
#include "radiosity/run/run.h"
#include "transport/lines/local_rays.h"

namespace multipath {

namespace {

/// The trace of a ray that arrives at `where`, after its power has been added to the unshot power of `state`.
TracedLine trace_ray(const Scene& scene, const Shot& shot, const LineOrigin& origin, std::uint32_t where,
                     const PowerState& state)
{
    const Rgb power = shot.power_per_ray;
    TracedLine line = traced_ray(scene, origin, shot.patch, where, " with " + watts(power));
    line.transfers.push_back({0, shot.patch, where, {}, power, power});
    if (!Segment::is_patch(where)) {
        line.notes.push_back("carries " + watts(power) + ", " + loss(where));
        return line;
    }
    line.transfers.back().then_held = state.unshot[where];
    const Rgb rho = scene.reflectance(where);
    line.notes.push_back(patch_name(scene, where) + " receives " + watts(power) + " and reflects " + colour_text(rho) +
                         " of it: " + watts(rho * power) + " more is unshot; it then has " +
                         watts(state.unshot[where]) + " unshot");
    return line;
}

/// The traces of the rays of the range in a pass. `state` is that in which the pass begins, with the power of the shots
/// already spent.
std::vector<TracedLine> trace_rays(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                   const std::vector<Shot>& shots, PowerState state, const TracedRange& range)
{
    require_in_stage(range, rays_of(shots).rays(), "rays");
    std::vector<TracedLine> lines;
    std::uint64_t n = 0;
    for (const Shot& shot : shots)
        for (std::uint64_t k = 0; k < shot.rays && n < range.first + range.count; ++k, ++n) {
            const LineOrigin origin{n, first_item + n, sequence.item(first_item + n)};
            const Patch patch = scene.patch(shot.patch);
            const std::uint32_t where = receiver(scene, patch.surface, local_line(patch, origin.numbers));
            if (Segment::is_patch(where))
                state.unshot[where] += scene.reflectance(where) * shot.power_per_ray; // (S1)
            if (range.includes(n))
                lines.push_back(trace_ray(scene, shot, origin, where, state));
        }
    return lines;
}

/// Throws SettingsError unless there is a pass of this number.
void require_pass(const std::vector<ShotPass>& passes, std::size_t pass)
{
    if (passes.empty())
        throw SettingsError(
            "the first shot has no pass: nothing is unshot above the threshold, or no line is left for it");
    if (pass >= passes.size())
        throw SettingsError("the first shot of this run ends after pass " + std::to_string(passes.size()) +
                            ", but pass " + std::to_string(pass + 1) + " is asked for");
}

/// The stage without its rays. `threshold` [W/m^2]: unshot radiosity above which patches shoot.
StageTrace shot_stage(const std::vector<ShotPass>& passes, std::size_t pass, std::size_t shooters, double threshold)
{
    return {"Rays of pass " + std::to_string(pass + 1) + " of the first shot",
            {"A patch whose unshot radiosity exceeds the threshold" +
             format(", %.4g W/m^2 (4), shoots the excess. ", threshold) + "In this pass " +
             counted(shooters, "patch shoots", "patches shoot") + format(" %.4g W with ", passes[pass].power) +
             counted(passes[pass].lines, "ray", "rays") +
             ", one after the other. A ray takes one item of four numbers: two for a uniform point of the "
             "patch, two for a direction that favours the normal by the cosine, as diffuse light does. "
             "Where it arrives its power is added to what has arrived, and the reflected part is unshot "
             "until a later pass or the global lines send it on (S1)."},
            "ray",
            passes[pass].lines};
}

} // namespace

StageTrace trace_shot_pass(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    Run run(scene, options);
    std::vector<TracedLine> rays;
    std::size_t shooters = 0;
    std::size_t passes_begun = 0;
    const auto observe = [&](std::uint64_t first_of_pass, const std::vector<Shot>& shots, const PowerState& state) {
        if (passes_begun++ != range.pass)
            return;
        shooters = shots.size();
        rays = trace_rays(scene, *run.sequence, first_of_pass, shots, state, range);
    };
    shoot_first(run, observe);
    const std::vector<ShotPass>& passes = run.solution.shot_passes;
    require_pass(passes, range.pass);
    StageTrace trace = shot_stage(passes, range.pass, shooters, options.threshold.value_or(threshold_radiosity(scene)));
    trace.lines = rays;
    return trace;
}

} // namespace multipath

// Each trace repeats the run up to the lines of the range with the functions of the solver itself. What a global line
// carries depends on the lines before it, and what a receiver of the first shot has unshot depends on the rays before.
// So in these two stages the lines before the range are followed as well, but not recorded. The lines of a bundle, the
// particles and the walks are independent of each other: only those of the range are traced.

#include "explain/line_trace.h"

#include "base/errors.h"
#include "radiosity/family/gathering_walk.h"
#include "radiosity/family/transillumination.h"
#include "radiosity/paper/first_stage.h"
#include "radiosity/paper/line_budget.h"
#include "radiosity/paper/multipath.h"
#include "radiosity/paper/power_walk.h"
#include "radiosity/run/item_plan.h"
#include "radiosity/run/solve_options.h"
#include "transport/lines/global_lines.h"
#include "transport/lines/local_rays.h"

#include <algorithm>

namespace multipath {

Crossing crossing_at(const Scene& scene, const Line& line, const Hit& hit)
{
    return {hit, line.at(hit.t), passage_at(scene, hit)};
}

void require_in_stage(const TracedRange& range, std::uint64_t lines, const char* what)
{
    if (range.first >= lines || range.count > lines - range.first)
        throw SettingsError("this stage has " + std::to_string(lines) + " " + what + ", but number " +
                            std::to_string(range.first + range.count) + " is asked for");
}

namespace {

/// Lets the walk follow one segment and records what its patches held before and hold afterwards.
TracedSegment trace_segment(const Segment& segment, bool bidirectional, PowerWalk& walk)
{
    TracedSegment traced{0, segment, {}, {}, {}};
    const auto sends = [&](std::uint32_t from, std::uint32_t to) {
        traced.transfers.push_back({from, to, walk.at(from).forecast, walk.at(from).held});
    };
    if (Segment::is_patch(segment.from))
        sends(segment.from, segment.to);
    if (Segment::is_patch(segment.to) && bidirectional)
        sends(segment.to, segment.from);
    walk.follow(segment);
    if (Segment::is_patch(segment.from))
        traced.from_holds = walk.at(segment.from).held;
    if (Segment::is_patch(segment.to))
        traced.to_holds = walk.at(segment.to).held;
    return traced;
}

/// For each segment, in order, the number of crossings before it. append_segments leaves out segments without a patch.
std::vector<std::size_t> crossings_before(const std::vector<Crossing>& crossings)
{
    std::vector<std::size_t> before;
    for (std::size_t after = 0; after <= crossings.size(); ++after)
        if ((after > 0 && Segment::is_patch(crossings[after - 1].patches.leaves)) ||
            (after < crossings.size() && Segment::is_patch(crossings[after].patches.arrives_at)))
            before.push_back(after);
    return before;
}

/// The trace of a line, given its hits in order. follow(segment) returns the TracedSegment of each segment.
template <class Follow>
GlobalLine trace_line(const Scene& scene, const LineOrigin& origin, const Line& line, const std::vector<Hit>& hits,
                      const std::vector<Segment>& segments, const Follow& follow)
{
    GlobalLine trace{origin, line.origin, line.at(1.0), {}, {}};
    for (const Hit& hit : hits)
        trace.crossings.push_back(crossing_at(scene, line, hit));
    const std::vector<std::size_t> before = crossings_before(trace.crossings);
    for (std::size_t k = 0; k < segments.size(); ++k) {
        trace.segments.push_back(follow(segments[k]));
        trace.segments.back().after = before.at(k);
    }
    return trace;
}

/// The same for an infinite line, whose hits this function finds. The trace ends a little past the scene.
template <class Follow>
GlobalLine trace_line(const Scene& scene, const LineOrigin& origin, const Line& line, const Follow& follow)
{
    std::vector<Hit> hits;
    scene.intersector().all_hits(line, hits);
    std::vector<Segment> segments;
    append_segments(scene, {hits}, segments);
    GlobalLine trace = trace_line(scene, origin, line, hits, segments, follow);
    trace.to = line.origin + (2.0 * dot(scene.bounds().centre() - line.origin, line.direction)) * line.direction;
    return trace;
}

/// Runs the first stage as solve does. Returns a trace without lines, with the figures of the run up to the global
/// pass.
GlobalTrace run_first_stage(const Scene& scene, const Sequence& sequence, const GlobalLines& lines,
                            const SolveOptions& options, PowerState& state)
{
    const ItemPlan all_items = plan_items(sequence, options.skip, 0, lines.lines_to_cast(options.lines));
    GlobalTrace trace;
    trace.shot_passes = shoot_first(scene, sequence, all_items.first_shot, options, {options.threads}, state);
    for (const ShotPass& pass : trace.shot_passes)
        trace.local_lines += pass.lines;
    trace.lines_charged = options.lines - std::min(options.lines, trace.local_lines);
    trace.lines_cast = lines.lines_to_cast(trace.lines_charged);
    trace.crossings_per_area = lines.expected_crossings(1.0, trace.lines_cast); // (G1)
    for (const Rgb unshot : state.unshot) {
        trace.unshot += unshot;
        trace.unshot_patches += mean(unshot) > 0.0 ? 1 : 0;
    }
    return trace;
}

} // namespace

GlobalTrace trace_global_pass(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const GlobalLines lines(scene.bounds(), chords_of(options));
    PowerState state(scene);
    GlobalTrace trace = run_first_stage(scene, *sequence, lines, options, state);
    require_in_stage(range, trace.lines_cast, "global lines");

    const ItemPlan items = plan_items(*sequence, options.skip, trace.local_lines, trace.lines_cast);
    const ShuffledOrder order = walking_order(*sequence, options.line_order, items.global_pass, trace.lines_cast);
    PowerWalk walk(scene, trace.crossings_per_area, options.bidirectional, state);
    std::vector<Hit> hits;
    std::vector<Segment> segments;
    for (std::uint64_t n = 0; n < range.first + range.count; ++n) {
        const std::uint64_t item = order.item_at(items.global_pass + n);
        const LineOrigin origin{n, item, sequence->item(item)};
        const Line line = lines.line(origin.numbers);
        scene.intersector().all_hits(line, hits);
        segments.clear();
        append_segments(scene, hits, segments);
        if (range.includes(n))
            trace.lines.push_back(trace_line(scene, origin, line, hits, segments, [&](const Segment& segment) {
                return trace_segment(segment, options.bidirectional, walk);
            }));
        else
            for (const Segment& segment : segments)
                walk.follow(segment);
    }
    return trace;
}

BundleTrace trace_bundle(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const GlobalLines lines(scene.bounds(), chords_of(options));
    PowerState state(scene);
    const GlobalTrace before = run_first_stage(scene, *sequence, lines, options, state);
    const ItemPlan items = plan_items(*sequence, options.skip, 0, before.lines_cast);
    const TransilluminationOptions bundles{items.first_shot + before.local_lines, before.lines_charged, options.bundle,
                                           options.seed};
    const PowerState start = state;
    BundleTrace trace;
    trace.shot_lines = before.local_lines;
    trace.rays = estimate_by_rays(scene, *sequence, bundles, {options.threads}, state);
    const JacobiIterations iterations(scene, start, state, static_cast<double>(trace.rays));
    const BundlePlan plan = plan_bundles(bundles, trace.rays);
    if (plan.directions == 0)
        throw SettingsError("this run has too few lines for a direction");
    trace.lines_to_meet = plan.bundle;
    trace.directions = std::clamp<std::uint64_t>(iterations.next_lines(plan.directions * plan.bundle) / plan.bundle, 1,
                                                 plan.directions);
    const std::uint64_t item = bundles.first_item + trace.rays;
    const Item numbers = sequence->item(item);
    const Bundle bundle(scene.bounds(), numbers, plan.bundle);
    trace.lines_cast = bundle.count();
    trace.direction = bundle.direction();
    trace.section = bundle.section();
    require_in_stage(range, bundle.count(), "lines along the first direction");
    const std::vector<Rgb> power = iterations.power();
    const auto sent = [&](std::uint32_t from, std::uint32_t to) {
        const Rgb radiosity = (1.0 / scene.area(from)) * power[from];
        return Transfer{from, to, power_along_line(radiosity, trace.section, trace.directions), {}};
    };
    for (std::uint64_t n = range.first; n < range.first + range.count; ++n)
        trace.lines.push_back(trace_line(scene, {n, item, numbers}, bundle.line(n), [&](const Segment& segment) {
            TracedSegment traced{0, segment, {}, {}, {}};
            if (Segment::is_patch(segment.from))
                traced.transfers.push_back(sent(segment.from, segment.to));
            if (Segment::is_patch(segment.to))
                traced.transfers.push_back(sent(segment.to, segment.from));
            return traced;
        }));
    return trace;
}

namespace {

/// Index of the first item that the run does not skip.
std::uint64_t first_item_of(const Scene& scene, const Sequence& sequence, const SolveOptions& options)
{
    const GlobalLines lines(scene.bounds(), chords_of(options));
    return plan_items(sequence, options.skip, 0, lines.lines_to_cast(options.lines)).first_shot;
}

/// Where a ray from a patch meets the next surface; empty if it leaves the scene.
std::optional<Crossing> first_crossing(const Scene& scene, const Patch& patch, const Line& ray)
{
    const std::optional<Hit> hit = scene.intersector().closest_hit_from(patch.surface, ray);
    return hit ? std::optional(crossing_at(scene, ray, *hit)) : std::nullopt;
}

/// Traces one ray of a shot and adds its power to the receiver's unshot power.
ShotRay trace_ray(const Scene& scene, const Shot& shot, const LineOrigin& origin, PowerState& state)
{
    const Patch patch = scene.patch(shot.patch);
    const Line ray = local_line(patch, origin.numbers);
    ShotRay trace{origin,
                  shot.patch,
                  ray,
                  first_crossing(scene, patch, ray),
                  receiver(scene, patch.surface, ray),
                  shot.power_per_ray,
                  {}};
    if (Segment::is_patch(trace.where)) {
        state.unshot[trace.where] += scene.reflectance(trace.where) * trace.power; // (S1)
        trace.unshot = state.unshot[trace.where];
    }
    return trace;
}

/// The shots of a pass, and the state in which it begins, with their power already spent.
struct ObservedPass
{
    std::uint64_t first_item = 0;
    std::vector<Shot> shots;
    std::optional<PowerState> state;
};

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

} // namespace

ShotTrace trace_shot_pass(const Scene& scene, const SolveOptions& options, std::size_t pass, const TracedRange& range)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const std::uint64_t first_item = first_item_of(scene, *sequence, options);

    ObservedPass observed;
    std::size_t passes_begun = 0;
    const auto keep_pass = [&](std::uint64_t first_of_pass, const std::vector<Shot>& shots, const PowerState& state) {
        if (passes_begun++ == pass)
            observed = {first_of_pass, shots, state};
    };
    PowerState state(scene);
    const std::vector<ShotPass> passes =
        shoot_first(scene, *sequence, first_item, options, {options.threads}, state, keep_pass);
    require_pass(passes, pass);
    require_in_stage(range, ray_count(observed.shots), "rays");

    ShotTrace trace{passes, pass, options.threshold.value_or(threshold_radiosity(scene)), observed.shots.size(), {}};
    std::uint64_t n = 0;
    for (const Shot& shot : observed.shots)
        for (std::uint64_t k = 0; k < shot.rays && n < range.first + range.count; ++k, ++n) {
            const std::uint64_t item = observed.first_item + n;
            const ShotRay ray = trace_ray(scene, shot, {n, item, sequence->item(item)}, *observed.state);
            if (range.includes(n))
                trace.rays.push_back(ray);
        }
    return trace;
}

namespace {

/// The trace of one segment of a particle's path.
TracedStep trace_step(const Scene& scene, const ParticleStep& step)
{
    const Patch patch = scene.patch(step.from);
    const Line ray = local_line(patch, step.item);
    return {step, ray, first_crossing(scene, patch, ray), {}};
}

/// The paths of the range, each of which begins with the item of its number after first_item. counted(step) is what
/// the estimator adds for a step that ends at a patch.
template <class Counted>
std::vector<TracedParticle> trace_paths(const Scene& scene, const Sequence& sequence, const Particles& particles,
                                        std::uint64_t first_item, const TracedRange& range, const Counted& counted)
{
    std::vector<TracedParticle> traces;
    for (std::uint64_t n = range.first; n < range.first + range.count; ++n) {
        TracedParticle particle{{n, first_item + n, sequence.item(first_item + n)}, {}};
        ParticlePaths paths;
        particles.follow(n, {particle.origin.numbers}, paths);
        for (const ParticleStep& step : paths.steps) {
            particle.steps.push_back(trace_step(scene, step));
            if (Segment::is_patch(step.where))
                particle.steps.back().counted = counted(step);
        }
        traces.push_back(particle);
    }
    return traces;
}

} // namespace

ParticleTrace trace_particles(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const std::uint64_t first_item = first_item_of(scene, *sequence, options);
    const Particles particles = plan_particles(scene, PowerState(scene), options.lines, options.seed, options.threads);
    require_in_stage(range, particles.count(), "particles");
    return {particles.count(), particles.shots().size(),
            trace_paths(scene, *sequence, particles, first_item, range,
                        [&](const ParticleStep& step) { return scored_power(scene, step, options.estimator); })};
}

WalkTrace trace_walks(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const std::uint64_t first_item = first_item_of(scene, *sequence, options);
    const Particles walks =
        first_walks(scene, {options.lines, options.estimator, first_item, options.seed}, options.threads);
    require_in_stage(range, walks.count(), "walks");
    return {walks.count(), trace_paths(scene, *sequence, walks, first_item, range, [&](const ParticleStep& step) {
                return gathered_irradiance(scene, step, options.estimator); // (W1)
            })};
}

JacobiTrace trace_iteration(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const std::uint64_t first_item = first_item_of(scene, *sequence, options);
    PowerState state(scene);
    JacobiTrace trace;
    trace.series_rays = send_series(
        scene, *sequence, series_before_iterations(first_item, options.lines, options.bidirectional, options.seed),
        {options.threads}, state);
    const JacobiOptions jacobi{
        first_item + trace.series_rays, trace.series_rays, options.lines - std::min(options.lines, trace.series_rays),
        options.bidirectional,          options.seed,      options.importance.get()};
    if (jacobi.lines == 0)
        throw SettingsError("this run has too few lines for an iteration");
    const IterationTrace iteration =
        trace_first_iteration(scene, *sequence, jacobi, state, range.first, range.count, options.threads);
    require_in_stage(range, iteration.ray_count, "rays");
    trace.ray_count = iteration.ray_count;
    for (const IterationRay& ray : iteration.rays) {
        const Patch patch = scene.patch(ray.from);
        const LineOrigin origin{range.first + trace.rays.size(), ray.item, sequence->item(ray.item)};
        const Line line = local_line(patch, origin.numbers);
        trace.rays.push_back({origin, ray, line, first_crossing(scene, patch, line)});
    }
    return trace;
}

} // namespace multipath

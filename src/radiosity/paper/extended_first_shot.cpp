// Section 4.1 of the paper (Castro, Martinez, Sbert 1998) in the order in which it is done here, and where:
//
//   Threshold by (4), number of lines by (3)              line_budget.cpp
//   PowerByLine                                           power_by_next_line()
//   for each step, until no patch is above Threshold      shoot_passes(): no shots are the end
//     for each patch i with UNSHOT[i] > Threshold         share_above() and plan_shots() in shots.cpp
//       numberOfLines = AREA[i] (UNSHOT[i] - Threshold) / PowerByLine        rays_due there
//       UNSHOT[i] -= what i emits                         spend() in shots.cpp
//     for each line: hit = first patch that it meets      shoot() in shot_rays.cpp
//       RADIOSITY[hit] and UNSHOT[hit] += what it gets    deposit() there, for all rays of a patch at a time
//
// PowerState::unshot is AREA[i] UNSHOT[i], and radiosity() in power_state.h gives RADIOSITY from what has arrived. The
// differences to the paper:
//
// 1. The paper's user sets PowerByLine (here with --power-per-line). Otherwise N_l, the number of rays, is given, and
//    PowerByLine is the power of all passes over N_l. That power is not known beforehand: a pilot with a few rays,
//    which do not count among the N_l, estimates it. Each pass takes of the rays that are left the part that the pilot
//    gave it, so that all rays carry about the same power as far as the pilot is right.
// 2. All shots of a pass are planned before its first ray, and their power is subtracted then: what a patch receives in
//    a pass it shoots in the next one, as the text of the paper says. The pseudocode changes the patches while it goes
//    over them.
// 3. The n rays of a patch carry its excess over n each, not PowerByLine, so that nothing is lost by rounding. A patch
//    that is worth less than a ray gets one at random (plan_shots), but the power of a pass is taken from all its
//    patches (spend); one factor for each colour, at most 2, makes up for the rounding.
// 4. The passes also end after a number of steps, as in the paper, when no patch gets a ray by rounding, and when the
//    N_l rays are used up; if the user sets PowerByLine, with the lines of the run: the last pass then has stronger
//    rays. What patches still have above the threshold is sent by the global pass.
// 5. Powers instead of radiosities, and three colours: the threshold applies to their mean.

#include "radiosity/paper/extended_first_shot.h"

#include "base/lists.h"
#include "radiosity/paper/shot_rays.h"

#include <algorithm>

namespace multipath {

namespace {

std::uint64_t lines_of(const std::vector<ShotPass>& passes)
{
    return sum_over(passes, &ShotPass::lines);
}

/// [1] Power that is still to be shot, in units of that of the next pass, number k, as the pilot found it; 1 from its
/// last pass on.
double relative_power_to_come(const std::vector<ShotPass>& pilot, std::size_t k)
{
    double power = 0.0;
    for (std::size_t i = k; i < pilot.size(); ++i)
        power += pilot[i].power;
    return k < pilot.size() ? power / pilot[k].power : 1.0;
}

/// [W] PowerByLine of the next pass: what is still to be shot over the rays that are left, at least what the user has
/// set; 0 if no rays are left.
double power_by_next_line(const ExtendedShotOptions& options, const std::vector<ShotPass>& pilot,
                          const std::vector<ShotPass>& done, double excess)
{
    const std::uint64_t used = std::min(options.lines, lines_of(done));
    const auto left = static_cast<double>(options.lines - used);
    if (!(left > 0.0))
        return 0.0;
    return std::max(options.power_by_line.value_or(0.0), excess * relative_power_to_come(pilot, done.size()) / left);
}

/// The passes of section 4.1, appended to those that are done.
void shoot_passes(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                  const ExtendedShotOptions& options, const std::vector<ShotPass>& pilot, const RunControl& run,
                  PowerState& state, std::vector<ShotPass>& passes, const PassObserver& observe)
{
    while (passes.size() < static_cast<std::size_t>(options.most_steps) && !run.stopped()) {
        const double excess = power_above(scene, state, options.threshold);
        const double power_by_line = power_by_next_line(options, pilot, passes, excess);
        const std::vector<Shot> shots =
            plan_shots(scene, state, options.threshold, power_by_line, options.seed, passes.size());
        if (shots.empty())
            break;
        PowerState next = state; // a run that is resumed within the pass plans it again, from the same state
        spend(scene, options.threshold, shots, next);
        const std::uint64_t first_ray_item = first_item + lines_of(passes);
        observe(first_ray_item, shots, next);
        const std::uint64_t rays = shoot(scene, sequence, first_ray_item, shots, run, next); // (S1)
        state = std::move(next);
        passes.push_back({rays, excess, power_balance(scene, state)});
    }
}

} // namespace

std::vector<ShotPass> shoot_pilot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                  ExtendedShotOptions options, std::uint64_t rays, int threads, PowerState& state)
{
    options.power_by_line = power_above(scene, state, options.threshold) / static_cast<double>(rays);
    options.lines = ExtendedShotOptions::no_limit;
    return shoot_extended(scene, sequence, first_item, options, {threads}, state);
}

namespace {

/// The pilot by which the passes divide N_l; empty if they do not.
std::vector<ShotPass> pilot_passes(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                   const ExtendedShotOptions& options, int threads)
{
    if (options.power_by_line || options.most_steps == 1)
        return {};
    PowerState start(scene);
    const std::uint64_t rays = std::clamp<std::uint64_t>(options.lines / 16, 1, 4096);
    return shoot_pilot(scene, sequence, first_item, options, rays, threads, start);
}

} // namespace

std::vector<ShotPass> shoot_extended(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                     const ExtendedShotOptions& options, const RunControl& run, PowerState& state,
                                     const PassObserver& observe)
{
    std::vector<ShotPass> passes;
    const Checkpoint::Part part(run.checkpoint, "shot passes", [&](Archive& archive) { visit(archive, passes); });
    const std::vector<ShotPass> pilot = pilot_passes(scene, sequence, first_item, options, run.threads);
    shoot_passes(scene, sequence, first_item, options, pilot, run, state, passes, observe); // (S2)
    return passes;
}

void visit(Archive& archive, std::vector<ShotPass>& passes)
{
    archive.records(passes, field<std::uint64_t>("pass lines", &ShotPass::lines),
                    field<double>("pass power", &ShotPass::power), field<double>("pass balances", &ShotPass::balance));
}

} // namespace multipath

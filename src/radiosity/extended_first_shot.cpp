// The total power of all passes is not known beforehand, and neither is the power per ray with which the passes use N_l
// rays. A pilot run with a small fraction of the rays, which are not charged, estimates how the power is distributed
// over the passes. Each pass then gets a fraction of the remaining rays: the power that the pilot shot in this pass,
// over the power that it shot in this and all later passes. So later passes correct the errors of the pilot. The last
// pass of the pilot, and any pass after it, gets all rays that are left.

#include "radiosity/extended_first_shot.h"

#include "sampling/random.h"

#include <algorithm>
#include <numeric>

namespace multipath {

namespace {

/// Offset of the rounding: 0.5 in the first pass, which thus shoots exactly its number of lines; random in later
/// passes, so that no patch is favoured.
double rounding_offset(std::uint64_t seed, std::size_t pass)
{
    if (pass == 0)
        return 0.5;
    return bits_to_unit(random_bits(random_key(RandomStream::rounded_shots, seed), pass));
}

/// One pass over the patches: all that exceed the threshold shoot their excess with rays of `power_by_line` [W] each.
/// False if there is no ray to cast.
bool shoot_pass(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                const ExtendedShotOptions& options, double power_by_line, const RunControl& run,
                const PassObserver& observe, std::vector<ShotPass>& passes, PowerState& state)
{
    const ShotRule rule{options.threshold, power_by_line, rounding_offset(options.seed, passes.size())};
    const double excess = power_above(scene, state, options.threshold);
    const std::vector<Shot> shots = plan_shots(scene, state, rule);
    if (ray_count(shots) == 0)
        return false;
    PowerState next = state; // so that a run that is resumed within the pass plans it again from the same state
    spend(scene, options.threshold, shots, next);
    if (observe)
        observe(first_item, shots, next);
    shoot(scene, sequence, first_item, shots, run, next); // (S1)
    state = std::move(next);
    passes.push_back({ray_count(shots), excess, power_balance(scene, state)});
    return true;
}

std::uint64_t lines_of(const std::vector<ShotPass>& passes)
{
    return std::accumulate(passes.begin(), passes.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const ShotPass& pass) { return sum + pass.lines; });
}

/// [W] Power that the pilot shot in pass k and all later ones.
double power_from(const std::vector<ShotPass>& passes, std::size_t k)
{
    double power = 0.0;
    for (std::size_t i = k; i < passes.size(); ++i)
        power += passes[i].power;
    return power;
}

/// Passes with a small share of the lines, to estimate how the power of the sources is distributed over them.
std::vector<ShotPass> run_pilot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                const ExtendedShotOptions& options, int threads, PowerState state)
{
    const std::uint64_t pilot_lines = std::clamp<std::uint64_t>(options.lines / 16, 1, 4096);
    const double power_by_line = power_above(scene, state, options.threshold) / static_cast<double>(pilot_lines);
    std::vector<ShotPass> passes;
    while (power_by_line > 0.0 && passes.size() < static_cast<std::size_t>(options.most_steps) &&
           shoot_pass(scene, sequence, first_item + lines_of(passes), options, power_by_line, {threads}, {}, passes,
                      state))
        ;
    return passes;
}

/// [W] Power of one ray of the next pass, so that all passes together have options.lines rays; 0 if none are left.
double power_by_line(const ExtendedShotOptions& options, const std::vector<ShotPass>& pilot,
                     const std::vector<ShotPass>& done, double excess)
{
    if (options.power_by_line)
        return *options.power_by_line;
    const std::uint64_t used = std::min(options.lines, lines_of(done));
    const auto left = static_cast<double>(options.lines - used);
    const std::size_t k = done.size();
    const double this_pass = k < pilot.size() ? pilot[k].power : 1.0;
    const double from_here = k < pilot.size() ? power_from(pilot, k) : 1.0;
    return left > 0.0 ? excess * (from_here / this_pass) / left : 0.0;
}

} // namespace

void visit(Archive& archive, std::vector<ShotPass>& passes)
{
    archive.records(passes, field<std::uint64_t>("pass lines", &ShotPass::lines),
                    field<double>("pass power", &ShotPass::power), field<double>("pass balances", &ShotPass::balance));
}

std::vector<ShotPass> shoot_extended(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                     const ExtendedShotOptions& options, const RunControl& run, PowerState& state,
                                     const PassObserver& observe)
{
    std::vector<ShotPass> pilot;
    std::vector<ShotPass> passes;
    const Checkpoint::Part part(run.checkpoint, "shot passes", [&](Archive& archive) {
        visit(archive, passes);
        const Archive::Inner inner(archive, "pilot");
        visit(archive, pilot);
    });
    if (!part.resumed() && !options.power_by_line && options.most_steps > 1)
        pilot = run_pilot(scene, sequence, first_item, options, run.threads, state);
    while (passes.size() < static_cast<std::size_t>(options.most_steps) && !run.stopped()) {
        const double excess = power_above(scene, state, options.threshold);
        const double power = excess > 0.0 ? power_by_line(options, pilot, passes, excess) : 0.0;
        if (!(power > 0.0) ||
            !shoot_pass(scene, sequence, first_item + lines_of(passes), options, power, run, observe, passes, state))
            break;
    }
    return passes;
}

} // namespace multipath

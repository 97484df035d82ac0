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

/// Successive passes over the patches, in one range of items.
class Passes
{
public:
    Passes(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const ExtendedShotOptions& options)
        : scene_(scene), sequence_(sequence), next_item_(first_item), options_(options)
    {
    }

    /// Carries out passes. power_by_line(excess, passes so far) returns the power [W] of one ray, or 0 to end.
    template <class PowerByLine>
    std::vector<ShotPass> run(PowerState& state, const RunControl& control, const PassObserver& observe,
                              const PowerByLine& power_by_line)
    {
        std::vector<ShotPass> passes;
        std::vector<Shot> shots; // of the current pass
        double excess = 0.0;
        const Checkpoint::Part part(control.checkpoint, "shot passes", [&](Archive& archive) {
            archive.value<std::uint64_t>("next item", next_item_);
            archive.value<double>("excess", excess);
            visit(archive, passes);
            visit(archive, scene_, shots);
        });
        for (bool under_way = part.resumed();; under_way = false) {
            if (!under_way) {
                if (passes.size() >= static_cast<std::size_t>(options_.most_steps) || control.stopped())
                    break;
                excess = power_above(scene_, state, options_.threshold);
                const double power = excess > 0.0 ? power_by_line(excess, passes) : 0.0;
                if (!(power > 0.0))
                    break;
                shots = plan_shots(scene_, state,
                                   {options_.threshold, power, rounding_offset(options_.seed, passes.size())});
                if (ray_count(shots) == 0)
                    break;
                spend(scene_, options_.threshold, shots, state);
            }
            if (observe)
                observe(next_item_, shots, state);
            shoot(scene_, sequence_, next_item_, shots, control, state);
            const std::uint64_t lines = ray_count(shots);
            next_item_ += lines;
            passes.push_back({lines, excess, power_balance(scene_, state)});
        }
        return passes;
    }

private:
    const Scene& scene_;
    const Sequence& sequence_;
    std::uint64_t next_item_;
    const ExtendedShotOptions& options_;
};

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
                                const ExtendedShotOptions& options, const RunControl& run, PowerState state)
{
    const std::uint64_t pilot_lines = std::clamp<std::uint64_t>(options.lines / 16, 1, 4096);
    const double pilot_power = power_above(scene, state, options.threshold) / static_cast<double>(pilot_lines);
    const Checkpoint::Part part(run.checkpoint, "pilot", [&](Archive& archive) { state.visit(archive); });
    return Passes(scene, sequence, first_item, options)
        .run(state, {run.threads, {}, run.checkpoint}, {}, [&](double, const auto&) { return pilot_power; });
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
    Passes passes(scene, sequence, first_item, options);
    if (options.power_by_line)
        return passes.run(state, run, observe, [&](double, const auto&) { return *options.power_by_line; });

    if (options.most_steps == 1)
        return passes.run(state, run, observe, [&](double excess, const auto&) {
            return options.lines > 0 ? excess / static_cast<double>(options.lines) : 0.0;
        });

    std::vector<ShotPass> pilot;
    std::uint64_t pilot_done = 0;
    const Checkpoint::Part part(run.checkpoint, "extended first shot", [&](Archive& archive) {
        archive.value<std::uint64_t>("pilot done", pilot_done);
        visit(archive, pilot);
    });
    if (pilot_done == 0)
        pilot = run_pilot(scene, sequence, first_item, options, run, state);
    if (run.stopped())
        return {};
    pilot_done = 1;
    return passes.run(state, run, observe, [&](double excess, const std::vector<ShotPass>& done) {
        const std::uint64_t used = std::min(options.lines, lines_of(done));
        const auto left = static_cast<double>(options.lines - used);
        const std::size_t k = done.size();
        const double this_pass = k < pilot.size() ? pilot[k].power : 1.0;
        const double from_here = k < pilot.size() ? power_from(pilot, k) : 1.0;
        return left > 0.0 ? excess * (from_here / this_pass) / left : 0.0;
    });
}

} // namespace multipath

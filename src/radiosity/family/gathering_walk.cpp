// A gathering walk is traced like a particle (Particles), but from the receiver. It starts with a weight instead of a
// power: the inverse of the number of walks of its patch. At each patch that it meets, the emittance there times the
// weight is added to the irradiance of the first patch. The walks are cast in rounds over all patches, so that a run
// that is stopped has sampled all patches alike.

#include "radiosity/family/gathering_walk.h"

#include "parallel/stage.h"
#include "sampling/allotment.h"
#include "transport/lines/line_segments.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// Plans walks from each patch in proportion to the square root of its area, which minimises the error (1) if all
/// patches have the same variance. The weight of a walk, the same in all channels, is the inverse of the number of
/// walks of its patch, or of the expected number if that is below 1. `offset` in [0, 1) is that of the systematic
/// rounding.
std::vector<Shot> plan_walks(const Scene& scene, std::uint64_t walks, double offset)
{
    double all = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        all += std::sqrt(scene.area(i));
    std::vector<double> expected;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        expected.push_back(static_cast<double>(walks) * std::sqrt(scene.area(i)) / all);
    const Allotment rounded(expected, offset);
    std::vector<Shot> shots;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (const std::uint64_t number = rounded.rays_of(i); number > 0) {
            const double share = 1.0 / (expected[i] < 1.0 ? expected[i] : static_cast<double>(number));
            shots.push_back({i, number, {share, share, share}});
        }
    return shots;
}

/// Number of rounds.
std::uint64_t count_rounds(const Scene& scene, std::uint64_t lines)
{
    constexpr std::uint64_t most = 16;
    constexpr std::uint64_t lines_per_patch =
        64; // in each round; with fewer, the items distribute the walks less evenly
    return std::clamp<std::uint64_t>(lines / (lines_per_patch * scene.patch_count()), 1, most);
}

/// Offset of the rounding in a round, an additive recurrence, so that successive rounds round differently.
double rounding_offset(std::uint64_t round)
{
    constexpr double golden = 0.61803398874989485;
    const double sum = 0.5 + golden * static_cast<double>(round);
    return sum - std::floor(sum);
}

Particles walks_of_round(const Run& run, const std::vector<Shot>& shots, std::uint64_t round)
{
    return {run.scene, shots, mix_bits(mix_bits(run.options.seed) + round)};
}

/// Sums over the walks of a patch.
struct Gathered
{
    Rgb irradiance;       ///< [W/m^2]
    double outside = 0.0; ///< [1] fraction of the rays that leave the scene
    double behind = 0.0;  ///< [1] fraction of the rays that meet a side without a patch
};

/// Adds the gathered light to the state, as the mean over the rounds, and closes the balance.
void take_gathered(const Scene& scene, const std::vector<Gathered>& gathered, double rounds, PowerState& state)
{
    Rgb absorbed;
    Rgb escaped;
    Rgb behind;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double area = scene.area(i);
        state.incident[i] += (area / rounds) * gathered[i].irradiance;
        state.unshot[i] = {};
        absorbed += (Rgb{1.0, 1.0, 1.0} - scene.reflectance(i)) * state.incident[i];
        const Rgb sent = area * scene.emittance(i) + scene.reflectance(i) * state.incident[i];
        escaped += (gathered[i].outside / rounds) * sent;
        behind += (gathered[i].behind / rounds) * sent;
    }
    settle_losses(state.emitted, absorbed, escaped, behind, state);
}

/// The walks of one round.
struct WalkStage
{
    using Block = ParticlePaths;

    Blocks lines() const { return {walks.count(), particles_together(scene)}; }
    void trace(std::uint64_t number, ParticlePaths& block) const
    {
        walks.follow(sequence, first_item, lines().first(number), lines().length(number), block);
    }
    std::uint64_t take(std::uint64_t, const ParticlePaths& block)
    {
        std::uint32_t patch = 0; // where the present walk started
        bool starts = true;
        for (const ParticleStep& step : block.steps) {
            if (starts) {
                patch = step.from;
                gathered[patch].outside += step.where == Segment::outside ? step.power.r : 0.0;
                gathered[patch].behind += step.where == Segment::behind ? step.power.r : 0.0;
            }
            gathered[patch].irradiance += gathered_irradiance(scene, step, estimator);
            starts = step.ends();
        }
        segments += block.steps.size();
        return block.steps.size();
    }
    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("segments", segments);
        archive.list<double>("gathered", gathered);
    }

    const Scene& scene;
    const Sequence& sequence;
    const std::uint64_t first_item;
    const Estimator estimator;
    const Particles walks;
    std::vector<Gathered> gathered; ///< per patch, in all rounds so far
    std::uint64_t segments;         ///< in all rounds so far
};

} // namespace

Rgb gathered_irradiance(const Scene& scene, const ParticleStep& step, Estimator estimator)
{
    return Segment::is_patch(step.where) ? scored_power(scene, step, estimator) * scene.first_light(step.where)
                                         : Rgb{}; // (W1)
}

Particles first_walks(const Run& run)
{
    const auto shots = [&](std::uint64_t walks) { return plan_walks(run.scene, walks, rounding_offset(0)); };
    const std::uint64_t lines = run.options.lines / count_rounds(run.scene, run.options.lines);
    return walks_of_round(run, plan_particles(run.scene, shots, lines, run.options.seed, run.options.threads).shots(),
                          0);
}

void gather_by_walks(Run& run)
{
    const Scene& scene = run.scene;
    const RunControl control = run.control(1, 1);
    const std::uint64_t rounds = count_rounds(scene, run.options.lines);
    const std::uint64_t walks_per_round = first_walks(run).count();
    std::vector<Gathered> gathered(scene.patch_count()); // in the finished rounds
    std::uint64_t segments = 0;                          // in the finished rounds
    std::uint64_t round = 0;
    std::uint64_t first_walk = 0; // of the current round
    const Checkpoint::Part part(control.checkpoint, "rounds of walks", [&](Archive& archive) {
        archive.value<std::uint64_t>("round", round);
        archive.value<std::uint64_t>("first walk", first_walk);
        archive.value<std::uint64_t>("segments", segments);
        archive.list<double>("gathered", gathered);
    });
    for (; round < rounds; ++round) {
        const std::vector<Shot> shots = plan_walks(scene, walks_per_round, rounding_offset(round));
        WalkStage stage{scene,
                        *run.sequence,
                        run.next_item() + first_walk,
                        run.options.estimator,
                        walks_of_round(run, shots, round),
                        gathered,
                        segments};
        if (run_stage("walks", stage, control) < stage.walks.count()) // (W1)
            break;
        gathered = std::move(stage.gathered);
        segments = stage.segments;
        first_walk += stage.walks.count();
    }
    run.solved = round > 0;
    if (run.solved)
        take_gathered(scene, gathered, static_cast<double>(round), run.state);
    run.solution.local_lines += segments;
}

} // namespace multipath

// A gathering walk is traced like a particle (Particles), but from the receiver. It starts with a weight instead of a
// power: the inverse of the number of walks of its patch. At each patch that it meets, the emittance there times the
// weight is added to the irradiance of the first patch. The walks are cast in rounds over all patches, so that a run
// that is stopped has sampled all patches.

#include "radiosity/family/gathering_walk.h"

#include "parallel/stage.h"
#include "sampling/allotment.h"
#include "sampling/random.h"
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

/// Number of rounds. Each covers all patches, so that a run which is stopped has sampled all patches about equally.
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

/// Walks from all patches that cast about the lines of one round.
std::vector<Shot> plan_first_round(const Scene& scene, const LocalOptions& options, int threads)
{
    const auto shots = [&](std::uint64_t walks) { return plan_walks(scene, walks, rounding_offset(0)); };
    return plan_particles(scene, shots, options.lines / count_rounds(scene, options.lines), options.seed, threads)
        .shots();
}

Particles walks_of_round(const Scene& scene, const std::vector<Shot>& shots, std::uint64_t seed, std::uint64_t round)
{
    return {scene, shots, mix_bits(mix_bits(seed) + round)};
}

/// Sums over the walks of each patch.
struct Gathered
{
    explicit Gathered(const Scene& scene)
        : irradiance(scene.patch_count()), outside(scene.patch_count()), behind(scene.patch_count())
    {
    }

    /// Adds a path, whose first segment leaves the receiver.
    void add(const Scene& scene, const ParticleStep* first, const ParticleStep* end, Estimator estimator)
    {
        const std::uint32_t patch = first->from;
        if (!Segment::is_patch(first->where))
            (first->where == Segment::outside ? outside : behind)[patch] += first->power.r;
        for (const ParticleStep* step = first; step != end; ++step)
            irradiance[patch] += gathered_irradiance(scene, *step, estimator);
    }

    void visit(Archive& archive) ///< for a checkpoint
    {
        archive.list<double>("irradiance", irradiance);
        archive.list<double>("outside", outside);
        archive.list<double>("behind", behind);
    }

    std::vector<Rgb> irradiance; ///< [W/m^2]
    std::vector<double> outside; ///< [1] fraction of the rays that leave the scene
    std::vector<double> behind;  ///< [1] fraction of the rays that meet a side without a patch
};

/// Number of rounds in which each patch was sampled: `whole` rounds, and a fraction of one with walks_done walks.
std::vector<double> rounds_of_patches(const Scene& scene, std::uint64_t whole, const std::vector<Shot>& shots,
                                      std::uint64_t walks_done)
{
    std::vector<double> rounds(scene.patch_count(), static_cast<double>(whole));
    std::uint32_t next = 0; // patch
    for (const Shot& shot : shots) {
        if (walks_done == 0)
            break;
        for (; next < shot.patch; ++next)
            rounds[next] += 1.0;
        const std::uint64_t done = std::min(walks_done, shot.rays);
        rounds[next++] += static_cast<double>(done) / static_cast<double>(shot.rays);
        walks_done -= done;
    }
    return rounds;
}

/// Adds the gathered light to the state, as the mean over the rounds of each patch, and closes the balance.
void take_gathered(const Scene& scene, const Gathered& gathered, const std::vector<double>& rounds, PowerState& state)
{
    Rgb absorbed;
    Rgb escaped;
    Rgb behind;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double area = scene.area(i);
        state.incident[i] += (area / rounds[i]) * gathered.irradiance[i];
        state.unshot[i] = {};
        absorbed += (Rgb{1.0, 1.0, 1.0} - scene.reflectance(i)) * state.incident[i];
        const Rgb sent = area * scene.emittance(i) + scene.reflectance(i) * state.incident[i];
        escaped += (gathered.outside[i] / rounds[i]) * sent;
        behind += (gathered.behind[i] / rounds[i]) * sent;
    }
    settle_losses(state.emitted, absorbed, escaped, behind, state);
}

/// The walks of one round.
struct WalkStage
{
    using Block = ParticleBlock;

    Blocks lines() const { return {walks.count(), particles_together(scene)}; }
    void trace(std::uint64_t number, ParticleBlock& block) const
    {
        block.follow(walks, sequence, first_item, lines(), number);
    }
    std::uint64_t take(std::uint64_t, const ParticleBlock& block)
    {
        const std::vector<ParticleStep>& steps = block.paths.steps;
        for (std::size_t first = 0; first < steps.size();) {
            std::size_t last = first;
            while (!steps[last].ends())
                ++last;
            gathered.add(scene, &steps[first], &steps[last] + 1, estimator);
            first = last + 1;
        }
        segments += steps.size();
        return steps.size();
    }
    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("segments", segments);
        gathered.visit(archive);
    }

    const Scene& scene;
    const Sequence& sequence;
    const std::uint64_t first_item;
    const Estimator estimator;
    const Particles walks;
    Gathered& gathered;      ///< in all rounds
    std::uint64_t& segments; ///< in all rounds
};

} // namespace

Rgb gathered_irradiance(const Scene& scene, const ParticleStep& step, Estimator estimator)
{
    return Segment::is_patch(step.where) ? scored_power(scene, step, estimator) * scene.first_light(step.where)
                                         : Rgb{}; // (W1)
}

Particles first_walks(const Scene& scene, const LocalOptions& options, int threads)
{
    return walks_of_round(scene, plan_first_round(scene, options, threads), options.seed, 0);
}

GatheringResult gather_by_walks(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                                const RunControl& run, PowerState& state)
{
    const std::uint64_t rounds = count_rounds(scene, options.lines);
    const std::uint64_t walks_per_round = rays_of(plan_first_round(scene, options, run.threads)).rays();
    Gathered gathered(scene);
    std::uint64_t round = 0;
    std::uint64_t first_walk = 0; // of the current round
    std::uint64_t segments = 0;
    const Checkpoint::Part part(run.checkpoint, "rounds of walks", [&](Archive& archive) {
        archive.value<std::uint64_t>("round", round);
        archive.value<std::uint64_t>("first walk", first_walk);
        archive.value<std::uint64_t>("segments", segments);
        gathered.visit(archive);
    });
    std::vector<Shot> shots;
    std::uint64_t done = 0; // walks of the unfinished round
    for (; round < rounds; ++round) {
        shots = plan_walks(scene, walks_per_round, rounding_offset(round));
        WalkStage stage{scene,
                        sequence,
                        options.first_item + first_walk,
                        options.estimator,
                        walks_of_round(scene, shots, options.seed, round),
                        gathered,
                        segments};
        done = run_stage("walks", stage, run); // (W1)
        if (done < stage.walks.count())
            break;
        first_walk += done;
        done = 0;
    }
    if (round > 0)
        take_gathered(scene, gathered, rounds_of_patches(scene, round, shots, done), state);
    return {segments, round > 0};
}

} // namespace multipath

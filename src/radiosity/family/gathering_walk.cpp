#include "radiosity/family/gathering_walk.h"

#include "parallel/blocks.h"
#include "sampling/systematic_rounding.h"
#include "transport/lines/line_segments.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// So many walks, from each patch in proportion to the root of its area: that makes the error (1) smallest if all
/// patches are equally noisy. What one brings counts with the share of a walk of its patch, the same in all channels.
std::vector<Shot> plan_walks(const Scene& scene, std::uint64_t walks)
{
    double all = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        all += std::sqrt(scene.area(i));
    std::vector<Shot> shots;
    constexpr double begin = 0.5;
    double wanted = begin;
    SystematicRounding rounding(begin);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double expected = static_cast<double>(walks) * std::sqrt(scene.area(i)) / all;
        wanted += expected;
        const std::uint64_t number = rounding.up_to(wanted);
        const double share = 1.0 / (expected < 1.0 ? expected : static_cast<double>(number));
        if (number > 0)
            shots.push_back({i, number, {share, share, share}});
    }
    return shots;
}

/// What the walks of each patch have told.
struct Gathered
{
    explicit Gathered(const Scene& scene)
        : irradiance(scene.patch_count()), outside(scene.patch_count()), behind(scene.patch_count())
    {
    }

    /// Takes a path, whose first segment leaves the patch that asks.
    void add(const Scene& scene, const ParticleStep* first, const ParticleStep* end, Estimator estimator)
    {
        const std::uint32_t patch = first->from;
        if (!Segment::is_patch(first->where))
            (first->where == Segment::outside ? outside : behind)[patch] += first->power.r;
        for (const ParticleStep* step = first; step != end; ++step)
            if (Segment::is_patch(step->where))
                irradiance[patch] += counted_power(scene, *step, estimator) * scene.first_light(step->where); // (W1)
    }

    void visit(Archive& archive) ///< for a checkpoint
    {
        archive.list<double>("irradiance", irradiance);
        archive.list<double>("outside", outside);
        archive.list<double>("behind", behind);
    }

    std::vector<Rgb> irradiance; ///< [W/m^2]
    std::vector<double> outside; ///< [1] share of the rays that leave the scene
    std::vector<double> behind;  ///< [1] and that meet a side without a patch
};

/// The light that the patches gathered as the state.
void take_gathered(const Scene& scene, const Gathered& gathered, PowerState& state)
{
    Rgb absorbed;
    Rgb escaped;
    Rgb behind;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double area = scene.area(i);
        state.incident[i] += area * gathered.irradiance[i];
        state.unshot[i] = {};
        absorbed += (Rgb{1.0, 1.0, 1.0} - scene.reflectance(i)) * state.incident[i];
        const Rgb sent = area * scene.emittance(i) + scene.reflectance(i) * state.incident[i];
        escaped += gathered.outside[i] * sent;
        behind += gathered.behind[i] * sent;
    }
    settle_losses(state.emitted, absorbed, escaped, behind, state);
}

} // namespace

std::uint64_t gather_by_walks(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                              const RunControl& run, PowerState& state)
{
    std::vector<Shot> shots;
    Gathered gathered(scene);
    std::uint64_t segments = 0;
    std::uint64_t next_block = 0;
    const Checkpoint::Part part(run.checkpoint, "walks", [&](Archive& archive) {
        archive.value<std::uint64_t>("next block", next_block);
        archive.value<std::uint64_t>("segments", segments);
        gathered.visit(archive);
        visit(archive, scene, shots);
    });
    if (!part.resumed())
        shots = plan_particles(
                    scene, [&](std::uint64_t walks) { return plan_walks(scene, walks); }, options.lines, options.seed,
                    run.threads)
                    .shots();
    const Particles walks(scene, shots, options.seed);
    const Blocks all = {walks.count(), particles_together(scene)};
    BlockBuffers<ParticleBlock> blocks(run.threads);
    const auto trace = [&](std::uint64_t number, int slot) {
        blocks[slot].follow(walks, sequence, options.first_item, all, number);
    };
    const auto take = [&](std::uint64_t, int slot) {
        const std::vector<ParticleStep>& steps = blocks[slot].paths.steps;
        for (std::size_t first = 0; first < steps.size();) {
            std::size_t last = first;
            while (!steps[last].ends())
                ++last;
            gathered.add(scene, &steps[first], &steps[last] + 1, options.estimator);
            first = last + 1;
        }
        segments += steps.size();
        run.count_lines(steps.size());
    };
    resumable_blocks(next_block, all.count(), run, trace, take);
    take_gathered(scene, gathered, state);
    return segments;
}

} // namespace multipath

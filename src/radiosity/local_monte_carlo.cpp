#include "radiosity/local_monte_carlo.h"

#include "parallel/ordered_blocks.h"
#include "radiosity/shooting.h"
#include "transport/intersection_list.h"

#include <algorithm>

namespace multipath {

namespace {

void deposit(const Scene& scene, const ParticleStep& step, Estimator estimator, PowerState& state)
{
    if (!Segment::is_patch(step.where)) {
        (step.where == Segment::behind ? state.behind : state.escaped) += step.power;
        return;
    }
    const Rgb counted = counted_power(scene, step, estimator);
    const Rgb absorbed = (Rgb{1.0, 1.0, 1.0} - scene.reflectance(step.where)) * counted;
    state.incident[step.where] += counted;
    state.surplus += absorbed - (step.power - step.goes_on);
}

/// Sums in two levels: adding equal powers to a large sum 10^8 times would drift.
class PartialSums
{
public:
    explicit PartialSums(PowerState empty) : empty_(std::move(empty)), recent_(empty_) {}

    void deposit_all(const Scene& scene, const std::vector<ParticleStep>& steps, Estimator estimator, PowerState& total)
    {
        for (const ParticleStep& step : steps)
            deposit(scene, step, estimator, recent_);
        count_ += steps.size();
        if (count_ > 4 * recent_.incident.size() + 65536) // seldom enough to cost nothing
            flush(total);
    }
    void visit(Archive& archive) ///< for a checkpoint
    {
        recent_.visit(archive);
        archive.value<std::uint64_t>("deposits", count_);
    }
    void flush(PowerState& total)
    {
        for (std::size_t i = 0; i < recent_.incident.size(); ++i)
            total.incident[i] += recent_.incident[i];
        total.escaped += recent_.escaped;
        total.behind += recent_.behind;
        total.surplus += recent_.surplus;
        recent_ = empty_;
        count_ = 0;
    }

private:
    PowerState empty_;
    PowerState recent_;
    std::uint64_t count_ = 0;
};

} // namespace

std::uint64_t cast_particles(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                             const RunControl& run, PowerState& state)
{
    std::vector<Shot> shots;
    PartialSums sums(PowerState::empty(scene));
    std::uint64_t segments = 0;
    std::uint64_t next_block = 0;
    const Checkpoint::Part part(run.checkpoint, "particles", [&](Archive& archive) {
        archive.value<std::uint64_t>("next block", next_block);
        archive.value<std::uint64_t>("segments", segments);
        sums.visit(archive);
        visit(archive, scene, shots);
    });
    if (!part.resumed()) {
        shots = plan_particles(scene, state, options.lines, options.seed, run.threads).shots();
        spend(scene, 0.0, shots, state);
    }
    const Particles particles(scene, shots, options.seed);
    const std::uint64_t particles_per_block = particles_together(scene);

    struct Block
    {
        std::vector<Item> items;
        ParticlePaths paths;
    };
    std::vector<Block> blocks(static_cast<std::size_t>(slot_count(run.threads)));
    const auto trace = [&](std::uint64_t number, int slot) {
        Block& block = blocks[static_cast<std::size_t>(slot)];
        const std::uint64_t first = number * particles_per_block;
        block.items.resize(static_cast<std::size_t>(std::min(particles_per_block, particles.count() - first)));
        sequence.generate(options.first_item + first, block.items);
        particles.follow(first, block.items, block.paths);
    };
    const auto deposit_all = [&](std::uint64_t, int slot) {
        const Block& block = blocks[static_cast<std::size_t>(slot)];
        sums.deposit_all(scene, block.paths.steps, options.estimator, state);
        segments += block.paths.steps.size();
        run.count_lines(block.paths.steps.size());
    };
    const std::uint64_t block_count = (particles.count() + particles_per_block - 1) / particles_per_block;
    resumable_blocks(next_block, block_count, run, trace, deposit_all);
    sums.flush(state);
    keep_unsent(shots, std::min(particles.count(), next_block * particles_per_block), state);
    return segments;
}

} // namespace multipath

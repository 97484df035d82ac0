// Particles survive by Russian roulette. At a patch with reflectance rho, a particle survives with the mean of the
// channels of rho as its probability, and is then multiplied by rho over this mean. So the expected reflected power is
// rho times the arriving power in every channel, and in a grey scene every particle keeps its power.

#include "radiosity/paper/local_monte_carlo.h"

#include "parallel/stage.h"
#include "radiosity/paper/first_shot.h"
#include "sampling/random.h"
#include "transport/lines/line_segments.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace multipath {

Particles::Particles(const Scene& scene, std::vector<Shot> shots, std::uint64_t seed)
    : scene_(scene), shots_(std::move(shots)), key_(random_key(RandomStream::particles, seed))
{
    for (const Shot& shot : shots_)
        first_particle_.push_back(first_particle_.back() + shot.rays);
}

const Shot& Particles::shot_of(std::uint64_t particle) const
{
    const auto above = std::upper_bound(first_particle_.begin(), first_particle_.end(), particle);
    return shots_[static_cast<std::size_t>(above - first_particle_.begin()) - 1];
}

namespace {

constexpr std::uint64_t numbers_per_step = 5; // one number decides on survival, four on the next ray
/// No path is longer: one that gathers light in a white cavity without light would never end.
constexpr std::uint32_t longest_path = 1u << 14;

double random_number(std::uint64_t key, std::uint64_t particle, std::uint64_t counter)
{
    return bits_to_unit(random_bits(random_bits(key, particle), counter));
}

/// Probability that a particle that arrives at `where` survives.
double survival(const Scene& scene, std::uint32_t where)
{
    return Segment::is_patch(where) ? mean(scene.reflectance(where)) : 0.0;
}

} // namespace

Item Particles::next_item(std::uint64_t particle, std::uint32_t depth) const
{
    const std::uint64_t counter = numbers_per_step * depth + 1;
    Item item;
    for (std::uint64_t i = 0; i < item.size(); ++i)
        item[i] = random_number(key_, particle, counter + i);
    return item;
}

ParticleStep Particles::step(std::uint64_t particle, std::uint32_t depth, std::uint32_t from, const Item& item,
                             std::uint32_t where, Rgb power) const
{
    const double chance = survival(scene_, where);
    const double drawn = random_number(key_, particle, numbers_per_step * depth);
    const bool goes_on = drawn < chance && depth + 1 < longest_path;
    return {from, item, where, power, drawn, goes_on ? (1.0 / chance) * (scene_.reflectance(where) * power) : Rgb{}};
}

// Traces all particles breadth first: all first segments, then the second segments of the survivors, and so on, since
// many rays together are traced faster.
void Particles::follow(std::uint64_t first, const std::vector<Item>& items, ParticlePaths& paths) const
{
    RayBlock& rays = paths.rays_;
    paths.by_depth_.clear();
    paths.particle_.clear();
    paths.first_step_.assign(items.size() + 1, 0);
    paths.survivors_.resize(items.size());
    paths.power_.resize(items.size());
    rays.patches.resize(items.size());
    rays.items = items;
    for (std::uint32_t k = 0; k < items.size(); ++k) {
        const Shot& shot = shot_of(first + k);
        paths.survivors_[k] = k;
        paths.power_[k] = shot.power_per_ray;
        rays.patches[k] = shot.patch;
    }
    for (std::uint32_t depth = 0; !paths.survivors_.empty(); ++depth) {
        rays.trace(scene_);
        std::size_t left = 0;
        for (std::size_t k = 0; k < paths.survivors_.size(); ++k) {
            const std::uint32_t number = paths.survivors_[k];
            const ParticleStep taken =
                step(first + number, depth, rays.patches[k], rays.items[k], rays.receivers[k], paths.power_[k]);
            paths.by_depth_.push_back(taken);
            paths.particle_.push_back(number);
            ++paths.first_step_[number + 1];
            if (taken.ends())
                continue;
            paths.survivors_[left] = number;
            paths.power_[left] = taken.goes_on;
            rays.patches[left] = taken.where;
            rays.items[left] = next_item(first + number, depth);
            ++left;
        }
        paths.survivors_.resize(left);
        rays.patches.resize(left);
        rays.items.resize(left);
    }
    paths.sort_by_particle();
}

/// Counting sort. The steps of each particle are in order already.
void ParticlePaths::sort_by_particle()
{
    std::partial_sum(first_step_.begin(), first_step_.end(), first_step_.begin());
    steps.resize(by_depth_.size());
    for (std::size_t k = 0; k < by_depth_.size(); ++k)
        steps[first_step_[particle_[k]]++] = by_depth_[k];
}

std::uint64_t particles_together(const Scene& scene)
{
    constexpr double most_steps = 65536.0; // about 200 bytes each
    const double absorption = 1.0 - mean(scene.average_reflectance());
    return static_cast<std::uint64_t>(std::clamp(most_steps * absorption, 1.0, 1024.0));
}

Particles plan_particles(const Scene& scene, const std::function<std::vector<Shot>(std::uint64_t particles)>& shots,
                         std::uint64_t lines, std::uint64_t seed, int threads)
{
    const std::uint64_t pilot_particles = std::clamp<std::uint64_t>(lines / 16, 256, 4096);
    const Particles pilot(scene, shots(pilot_particles), ~seed);
    const std::unique_ptr<Sequence> random = make_sequence("random", ~seed);
    const Blocks blocks = {pilot.count(), particles_together(scene)};
    std::vector<double> further_steps(static_cast<std::size_t>(blocks.count()), 0.0);
    parallel_blocks(blocks.count(), threads, [&](std::uint64_t block) {
        std::vector<Item> items(blocks.length(block));
        random->generate(blocks.first(block), items);
        ParticlePaths paths;
        pilot.follow(blocks.first(block), items, paths);
        for (const ParticleStep& step :
             paths.steps) // the expected number of further steps has less variance than the actual one
            further_steps[static_cast<std::size_t>(block)] += survival(scene, step.where);
    });
    const double segments =
        1.0 + std::accumulate(further_steps.begin(), further_steps.end(), 0.0) / static_cast<double>(pilot.count());
    const auto wanted = static_cast<std::uint64_t>(std::llround(static_cast<double>(lines) / segments));
    return Particles(scene, shots(std::max<std::uint64_t>(1, wanted)), seed);
}

Particles plan_particles(const Scene& scene, const PowerState& state, std::uint64_t lines, std::uint64_t seed,
                         int threads)
{
    const auto from_sources = [&](std::uint64_t particles) {
        return plan_first_shot(scene, state, 0.0, particles, seed);
    };
    return plan_particles(scene, from_sources, lines, seed, threads);
}

Rgb scored_power(const Scene& scene, const ParticleStep& step, Estimator estimator)
{
    const double absorption = 1.0 - mean(scene.reflectance(step.where));
    if (estimator == Estimator::collision || !(absorption > 0.0)) // on perfect white no path ever ends
        return step.power;
    return step.goes_on == Rgb{} ? (1.0 / absorption) * step.power : Rgb{};
}

namespace {

void deposit(const Scene& scene, const ParticleStep& step, Estimator estimator, PowerState& state)
{
    if (!Segment::is_patch(step.where)) {
        (step.where == Segment::behind ? state.behind : state.escaped) += step.power;
        return;
    }
    const Rgb counted = scored_power(scene, step, estimator);
    const Rgb absorbed = (Rgb{1.0, 1.0, 1.0} - scene.reflectance(step.where)) * counted;
    state.incident[step.where] += counted;
    state.surplus += absorbed - (step.power - step.goes_on);
}

/// Two-level sums, since adding equal powers to a large sum 10^8 times would drift.
class PartialSums
{
public:
    explicit PartialSums(PowerState empty) : empty_(std::move(empty)), recent_(empty_) {}

    void deposit_all(const Scene& scene, const std::vector<ParticleStep>& steps, Estimator estimator, PowerState& total)
    {
        for (const ParticleStep& step : steps)
            deposit(scene, step, estimator, recent_);
        count_ += steps.size();
        if (count_ > 4 * recent_.incident.size() + 65536) // rarely enough to cost nothing
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

/// The particles, whose power is added to the state where they arrive.
class ParticleStage
{
public:
    using Block = ParticleBlock;

    ParticleStage(const Scene& scene, const Sequence& sequence, const LocalOptions& options, const Particles& particles,
                  PowerState& state)
        : scene_(scene),
          sequence_(sequence),
          options_(options),
          particles_(particles),
          state_(state),
          sums_(PowerState::empty(scene))
    {
    }

    Blocks lines() const { return {particles_.count(), particles_together(scene_)}; }
    void trace(std::uint64_t number, ParticleBlock& block) const
    {
        block.follow(particles_, sequence_, options_.first_item, lines(), number);
    }
    std::uint64_t take(std::uint64_t, const ParticleBlock& block)
    {
        sums_.deposit_all(scene_, block.paths.steps, options_.estimator, state_);
        segments_ += block.paths.steps.size();
        return block.paths.steps.size();
    }
    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("segments", segments_);
        sums_.visit(archive);
        const Archive::Inner inner(archive, "state");
        state_.visit(archive);
    }

    /// Completes the sums; returns the number of segments.
    std::uint64_t finish()
    {
        sums_.flush(state_);
        return segments_;
    }

private:
    const Scene& scene_;
    const Sequence& sequence_;
    const LocalOptions& options_;
    const Particles& particles_;
    PowerState& state_;
    PartialSums sums_;
    std::uint64_t segments_ = 0;
};

} // namespace

std::uint64_t cast_particles(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                             const RunControl& run, PowerState& state)
{
    const Particles particles = plan_particles(scene, state, options.lines, options.seed, run.threads);
    PowerState next = state; // so that a run that is resumed plans the same particles again
    spend(scene, 0.0, particles.shots(), next);
    ParticleStage stage(scene, sequence, options, particles, next);
    const std::uint64_t sent = run_stage("particles", stage, run); // (L1)
    const std::uint64_t segments = stage.finish();
    keep_unsent(particles.shots(), sent, next);
    state = std::move(next);
    return segments;
}

} // namespace multipath

// Particles survive by Russian roulette. At a patch with reflectance rho, a particle survives with the mean of the
// channels of rho as its probability, and is then multiplied by rho over this mean. So the expected reflected power is
// rho times the arriving power in every channel, and in a grey scene every particle keeps its power.

#include "radiosity/paper/local_monte_carlo.h"

#include "parallel/stage.h"
#include "radiosity/run/run.h"
#include "sampling/random.h"
#include "transport/lines/line_segments.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace multipath {

Particles::Particles(const Scene& scene, std::vector<Shot> shots, std::uint64_t seed)
    : scene_(scene),
      shots_(std::move(shots)),
      particles_(rays_of(shots_)),
      key_(random_key(RandomStream::particles, seed))
{
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
void Particles::follow(const Sequence& sequence, std::uint64_t first_item, std::uint64_t first, std::size_t count,
                       ParticlePaths& paths) const
{
    RayBlock& rays = paths.rays_;
    paths.by_depth_.clear();
    paths.particle_.clear();
    paths.first_step_.assign(count + 1, 0);
    paths.survivors_.resize(count);
    std::iota(paths.survivors_.begin(), paths.survivors_.end(), std::uint32_t{0});
    paths.power_.clear();
    rays.patches.clear();
    rays.items.resize(count);
    sequence.generate(first_item + first, rays.items);
    particles_.for_range(first, count, [&](std::uint32_t shot, std::uint64_t, std::size_t number) {
        paths.power_.insert(paths.power_.end(), number, shots_[shot].power_per_ray);
        rays.patches.insert(rays.patches.end(), number, shots_[shot].patch);
    });
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
        ParticlePaths paths;
        pilot.follow(*random, 0, blocks.first(block), blocks.length(block), paths);
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
    const double chance = survival(scene, step.where);
    if (estimator == Estimator::collision || !(chance < 1.0)) // on perfect white no path ever ends
        return step.power;
    return step.drawn < chance ? Rgb{} : 1.0 / (1.0 - chance) * step.power;
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

/// The particles, whose power is added to the state where they arrive.
struct ParticleStage
{
    using Block = ParticlePaths;

    Blocks lines() const { return {particles.count(), particles_together(scene)}; }
    void trace(std::uint64_t number, ParticlePaths& block) const
    {
        particles.follow(sequence, first_item, lines().first(number), lines().length(number), block);
    }
    std::uint64_t take(std::uint64_t, const ParticlePaths& block)
    {
        for (const ParticleStep& step : block.steps)
            deposit(scene, step, estimator, recent);
        segments += block.steps.size();
        deposits += block.steps.size();
        if (deposits > 4 * recent.incident.size() + 65536) // rarely enough to cost nothing
            flush();
        return block.steps.size();
    }
    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("segments", segments);
        recent.visit(archive);
        archive.value<std::uint64_t>("deposits", deposits);
        archive.object("state", state);
    }

    /// Completes the sums.
    void flush()
    {
        for (std::size_t i = 0; i < recent.incident.size(); ++i)
            state.incident[i] += recent.incident[i];
        state.escaped += recent.escaped;
        state.behind += recent.behind;
        state.surplus += recent.surplus;
        recent = PowerState::empty(scene);
        deposits = 0;
    }

    const Scene& scene;
    const Sequence& sequence;
    const std::uint64_t first_item;
    const Estimator estimator;
    const Particles particles;
    PowerState& state;
    PowerState recent = PowerState::empty(scene); ///< not yet in `state`: sums of 10^8 equal powers would drift
    std::uint64_t deposits = 0;                   ///< number of powers in `recent`
    std::uint64_t segments = 0;
};

} // namespace

void cast_particles(Run& run)
{
    const SolveOptions& options = run.options;
    PowerState next = run.state; // so that a run that is resumed plans the same particles again
    ParticleStage stage{run.scene,
                        *run.sequence,
                        run.next_item(),
                        options.estimator,
                        plan_particles(run.scene, run.state, run.lines_left(), options.seed, options.threads),
                        next};
    spend(run.scene, 0.0, stage.particles.shots(), next);
    const std::uint64_t sent = run_stage("particles", stage, run.control(1, 1)); // (L1)
    stage.flush();
    keep_unsent(stage.particles.shots(), sent, next);
    run.state = std::move(next);
    run.solution.local_lines += stage.segments;
}

} // namespace multipath

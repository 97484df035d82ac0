#pragma once

#include "parallel/blocks.h"
#include "parallel/run_control.h"
#include "radiosity/first_shot.h"
#include "sampling/sequence.h"
#include "transport/lines/local_rays.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// Where the power of a particle is scored: at every patch that it meets, or only at the patch that absorbs it.
enum class Estimator { collision, absorption };

/// One segment of a particle's path, from a patch to the next surface, and the decision made there.
struct ParticleStep
{
    std::uint32_t from;  ///< patch that the segment leaves
    Item item;           ///< of the ray, see local_line
    std::uint32_t where; ///< patch that it meets, or Segment::behind or Segment::outside
    Rgb power;           ///< [W] arriving
    double drawn;        ///< [0, 1) random number; the particle survives if it is below the survival probability
    Rgb goes_on;         ///< [W] reflected; black if the path ends here

    bool ends() const { return goes_on == Rgb{}; }
};

/// Paths of a group of particles, with reusable buffers.
class ParticlePaths
{
public:
    std::vector<ParticleStep> steps; ///< all paths, one after the other

private:
    friend class Particles;

    void sort_by_particle();

    RayBlock rays_;                        ///< of the surviving particles, one segment each
    std::vector<std::uint32_t> survivors_; ///< indices of the surviving particles
    std::vector<Rgb> power_;               ///< [W] of each surviving particle
    std::vector<ParticleStep> by_depth_;   ///< all first segments, then all second ones, ...
    std::vector<std::uint32_t> particle_;  ///< index of the particle of each of these steps
    std::vector<std::size_t> first_step_;  ///< of each particle, in `steps`
};

/// The particles of a run (L1): numbered through all sources, and the path of each, which is a function of its number
/// and its first item.
class Particles
{
public:
    Particles(const Scene& scene, std::vector<Shot> shots, std::uint64_t seed);

    std::uint64_t count() const { return first_particle_.back(); }
    const std::vector<Shot>& shots() const { return shots_; }

    /// Follows the particles first, first + 1, ... and replaces the contents of `paths` by their paths. There is one
    /// item per particle, for its first segment; everything after it is random.
    void follow(std::uint64_t first, const std::vector<Item>& items, ParticlePaths& paths) const;

private:
    ParticleStep step(std::uint64_t particle, std::uint32_t depth, std::uint32_t from, const Item& item,
                      std::uint32_t where, Rgb power) const;
    Item next_item(std::uint64_t particle, std::uint32_t depth) const;
    const Shot& shot_of(std::uint64_t particle) const;

    const Scene& scene_;
    std::vector<Shot> shots_;
    std::vector<std::uint64_t> first_particle_ = {0}; ///< of each shot, and the total number
    std::uint64_t key_;
};

/// Consecutive particles that are followed together, with reusable buffers.
struct ParticleBlock
{
    std::vector<Item> items;
    ParticlePaths paths;

    /// Follows block `number` of all particles, which take the items from first_item on.
    void follow(const Particles& particles, const Sequence& sequence, std::uint64_t first_item, const Blocks& all,
                std::uint64_t number)
    {
        items.resize(all.length(number));
        sequence.generate(first_item + all.first(number), items);
        particles.follow(all.first(number), items, paths);
    }
};

/// Number of particles to follow together: their paths must fit into memory, and they are long in bright scenes.
std::uint64_t particles_together(const Scene& scene);

/// As many particles as make about `lines` segments, to 1 %. A pilot estimates the mean length of a path. `shots`
/// returns the shots of a given number of particles.
Particles plan_particles(const Scene& scene, const std::function<std::vector<Shot>(std::uint64_t particles)>& shots,
                         std::uint64_t lines, std::uint64_t seed, int threads);

/// The same for particles from the sources.
Particles plan_particles(const Scene& scene, const PowerState& state, std::uint64_t lines, std::uint64_t seed,
                         int threads);

/// [W] Power that the estimator scores as incident at the end of a step, which must be a patch.
Rgb scored_power(const Scene& scene, const ParticleStep& step, Estimator estimator);

struct LocalOptions
{
    std::uint64_t lines = 0; ///< N_l, reached to about 1 %: every segment counts, and the lengths of paths are random
    Estimator estimator = Estimator::collision;
    std::uint64_t first_item = 0; ///< of the sequence; one item per particle, for its first segment
    std::uint64_t seed = 0;       ///< of the random numbers after the first segment
};

/// Phi_T local Monte Carlo (L1): particles of equal power leave the sources, are reflected with probability rho, and
/// continue from a uniform point of the patch that they hit. Returns the number of segments. The noise of Russian
/// roulette goes into PowerState::surplus. If the run is stopped, the power of particles that did not start stays
/// unshot. The caller must save `state` in the checkpoint; this function saves the rest.
std::uint64_t cast_particles(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                             const RunControl& run, PowerState& state);

} // namespace multipath

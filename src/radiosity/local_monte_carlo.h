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

/// Where a particle's power is counted: at every patch that it meets, or only where it ends.
enum class Estimator { collision, absorption };

/// One segment of a particle's path, from the patch that it leaves to what happens where it arrives.
struct ParticleStep
{
    std::uint32_t from;  ///< patch
    Item item;           ///< of its ray (see local_line)
    std::uint32_t where; ///< patch, Segment::behind or Segment::outside
    Rgb power;           ///< [W] that arrives
    double drawn;        ///< [0, 1) number that decides: below the patch's survival it goes on
    Rgb goes_on;         ///< [W] that leaves again; black where the particle ends

    bool ends() const { return goes_on == Rgb{}; }
};

/// The paths of some particles, with memory that serves again.
class ParticlePaths
{
public:
    std::vector<ParticleStep> steps; ///< all paths one after the other

private:
    friend class Particles;

    void sort_by_particle();

    RayBlock rays_;                       ///< of the particles that still go on, one segment each
    std::vector<std::uint32_t> going_on_; ///< which particles these are
    std::vector<Rgb> power_;              ///< [W] of each of them
    std::vector<ParticleStep> by_depth_;  ///< all first segments, then all second ones, ...
    std::vector<std::uint32_t> particle_; ///< whose these are
    std::vector<std::size_t> first_step_; ///< of each particle
};

/// The particles of a run (L1): which source sends which, counted through, and the path of each, a function of its
/// number and its first item.
class Particles
{
public:
    Particles(const Scene& scene, std::vector<Shot> shots, std::uint64_t seed);

    std::uint64_t count() const { return before_.back(); }
    const std::vector<Shot>& shots() const { return shots_; }

    /// The paths of particles first, first + 1, ..., one after the other. The items are for their first segments, all
    /// that follows is random. Replaces what `paths` held.
    void follow(std::uint64_t first, const std::vector<Item>& items, ParticlePaths& paths) const;

private:
    ParticleStep step(std::uint64_t particle, std::uint32_t depth, std::uint32_t from, const Item& item,
                      std::uint32_t where, Rgb power) const;
    Item next_item(std::uint64_t particle, std::uint32_t depth) const;
    const Shot& shot_of(std::uint64_t particle) const;

    const Scene& scene_;
    std::vector<Shot> shots_;
    std::vector<std::uint64_t> before_ = {0};
    std::uint64_t key_;
};

/// Successive particles, followed together; the memory serves again.
struct ParticleBlock
{
    std::vector<Item> items;
    ParticlePaths paths;

    /// Block `number` of all particles, which take the items from first_item on.
    void follow(const Particles& particles, const Sequence& sequence, std::uint64_t first_item, const Blocks& all,
                std::uint64_t number)
    {
        items.resize(all.length(number));
        sequence.generate(first_item + all.first(number), items);
        particles.follow(all.first(number), items, paths);
    }
};

/// As many as may be followed together: their paths must fit into memory, and get long in bright scenes.
std::uint64_t particles_together(const Scene& scene);

/// As many particles as make `lines` segments, to about 1 %: a pilot tells how long their paths are. `shots`: those of
/// a given number of particles.
Particles plan_particles(const Scene& scene, const std::function<std::vector<Shot>(std::uint64_t particles)>& shots,
                         std::uint64_t lines, std::uint64_t seed, int threads);

/// The same for particles from the sources.
Particles plan_particles(const Scene& scene, const PowerState& state, std::uint64_t lines, std::uint64_t seed,
                         int threads);

/// [W] What the estimator counts as incident where a step ends on a patch.
Rgb counted_power(const Scene& scene, const ParticleStep& step, Estimator estimator);

struct LocalOptions
{
    std::uint64_t lines = 0; ///< N_l to use, to about 1 %: every segment of a path counts, and their number is random
    Estimator estimator = Estimator::collision;
    std::uint64_t first_item = 0; ///< of the sequence; one item per particle, for its first segment
    std::uint64_t seed = 0;       ///< of all that is random after the first segment
};

/// Phi_T local Monte Carlo (L1): particles of equal power leave the sources, are reflected with the probability rho,
/// and go on from a uniform point of the patch that they hit. Returns the segments cast. Unshot power then holds what
/// Russian roulette created (negative) or destroyed, which is zero in expectation; and, if the run is stopped, that of
/// the particles that did not leave. A checkpoint must hold the state besides what this function makes it hold.
std::uint64_t cast_particles(const Scene& scene, const Sequence& sequence, const LocalOptions& options,
                             const RunControl& run, PowerState& state);

} // namespace multipath

#pragma once

#include "radiosity/paper/shots.h"
#include "sampling/sequence.h"
#include "transport/lines/local_rays.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

class Run;

/// Where the power of a particle is scored: at every patch that it meets, or only at the patch that absorbs it.
enum class Estimator { collision, absorption };

/// One segment of a particle's path, from a patch to the next surface, and the decision made there.
struct ParticleStep
{
    std::uint32_t from;  ///< patch that the segment leaves
    Item item;           ///< item that makes the ray (local_line)
    std::uint32_t where; ///< patch that the segment meets, or Segment::behind or Segment::outside
    Rgb power;           ///< [W] power that arrives there
    double drawn;        ///< random number in [0, 1); the particle survives if this is below the survival probability
    Rgb goes_on;         ///< [W] reflected power; black if the path ends here

    /// True if this is the last segment of the path.
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

    RayBlock rays_;                        ///< the next segment of each surviving particle
    std::vector<std::uint32_t> survivors_; ///< indices of the surviving particles in the group
    std::vector<Rgb> power_;               ///< [W] per surviving particle: the power that it carries
    std::vector<ParticleStep> by_depth_;   ///< all first segments, then all second ones, ...
    std::vector<std::uint32_t> particle_;  ///< per element of by_depth_: index of its particle in the group
    /// Scratch of the sort by particles, per particle: index in `steps` where its next step goes, initially its first.
    std::vector<std::size_t> first_step_;
};

/// The particles of a run, numbered from 0 in the order of the shots that send them. The path of a particle is a
/// function of its number, the item of its first segment, and the seed.
class Particles
{
public:
    /// `seed`: of the random numbers after the first segments. The scene must outlive this object.
    Particles(const Scene& scene, std::vector<Shot> shots, std::uint64_t seed);

    std::uint64_t count() const { return particles_.rays(); }
    const std::vector<Shot>& shots() const { return shots_; }

    /// Follows the particles first ... first + count - 1, and replaces the contents of `paths` by their paths, in the
    /// order of the particles. The first segment of particle n is made by the item first_item + n of the sequence;
    /// everything after the first segment is random.
    void follow(const Sequence& sequence, std::uint64_t first_item, std::uint64_t first, std::size_t count,
                ParticlePaths& paths) const;

private:
    ParticleStep step(std::uint64_t particle, std::uint32_t depth, std::uint32_t from, const Item& item,
                      std::uint32_t where, Rgb power) const;
    Item next_item(std::uint64_t particle, std::uint32_t depth) const;

    const Scene& scene_;
    std::vector<Shot> shots_;
    Allotment particles_; ///< of each shot
    std::uint64_t key_;   ///< key of the random numbers
};

/// Number of particles to follow together, 1 ... 1024. It is smaller in bright scenes, where paths are long, so that
/// all paths fit into memory.
std::uint64_t particles_together(const Scene& scene);

/// Particles whose paths have about `lines` segments in total, to 1 %; at least one particle. A pilot run, which is not
/// counted, estimates the mean number of segments of a path. `shots` returns the shots of a given number of particles.
Particles plan_particles(const Scene& scene, const std::function<std::vector<Shot>(std::uint64_t particles)>& shots,
                         std::uint64_t lines, std::uint64_t seed, int threads);

/// The same for particles of about equal power (see plan_shots) that carry all unshot power of `state`.
Particles plan_particles(const Scene& scene, const PowerState& state, std::uint64_t lines, std::uint64_t seed,
                         int threads);

/// [W] Power that the estimator scores as incident at step.where, which must be a patch. At a patch that absorbs
/// nothing no path ends; there the absorption estimator scores like the collision estimator.
Rgb scored_power(const Scene& scene, const ParticleStep& step, Estimator estimator);

/// Phi_T local Monte Carlo ((L1) in docs/equations.md): particles of about equal power carry away all unshot power of
/// the run. They are reflected with the probability mean(rho) over the channels, with rho / mean(rho) times their
/// power, and continue from a uniform point of the patch that they hit. Uses the remaining lines, to about 1 %, since
/// the lengths of paths are random. The noise of Russian roulette goes into PowerState::surplus. If the run is stopped,
/// the power of particles that did not start stays unshot.
void cast_particles(Run& run);

} // namespace multipath

#pragma once

#include "radiosity/first_shot.h"
#include "sampling/sequence.h"

#include <cstdint>
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
};

/// The particles of a run (L1): which source sends which, counted through, and the path of each, a function of its
/// number and its first item.
class Particles
{
public:
    Particles(const Scene& scene, std::vector<Shot> shots, std::uint64_t seed);

    std::uint64_t count() const { return before_.back(); }
    const std::vector<Shot>& shots() const { return shots_; }

    /// Appends the path of one particle; `item` is for its first segment, all that follows is random.
    void follow(std::uint64_t particle, const Item& item, std::vector<ParticleStep>& steps) const;

private:
    const Scene& scene_;
    std::vector<Shot> shots_;
    std::vector<std::uint64_t> before_ = {0};
    std::uint64_t key_;
};

/// As many particles as make `lines` segments, to about 1 %: a pilot tells how long their paths are.
Particles plan_particles(const Scene& scene, const PowerState& state, std::uint64_t lines, std::uint64_t seed);

/// [W] What the estimator counts as incident where a step ends on a patch.
Rgb counted_power(const Scene& scene, const ParticleStep& step, Estimator estimator);

} // namespace multipath

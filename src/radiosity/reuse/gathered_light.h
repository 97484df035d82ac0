#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Where the light of the sources arrives first. If all of it was found, source power = sum of incident + escaped +
/// behind.
struct GatheredLight
{
    std::vector<Rgb> incident; ///< [W] per patch
    std::uint64_t lines = 0;   ///< rays cast
    Rgb escaped;               ///< [W] left the scene
    Rgb behind;                ///< [W] met a surface on a side that has no patch
};

/// The sources have sent their light, and the patches have it. What was not found, as the work was stopped, the sources
/// keep.
void receive(const GatheredLight& light, const Scene& scene, PowerState& state);

/// [1] Share of the source power that gathering with up to so many rays would gather; the rest it would shoot.
double gathered_share(const Scene& scene, std::uint64_t rays);

/// Direct light found from the receiver's end: exact but for the share of each light that each patch sees, which shadow
/// rays tell. Takes the items from first_item on, one for each of up to `rays` rays. Lights for which there is less
/// than a ray for every other patch are shot (S1). A sixteenth of the rays, or 32 if that is more, leave the other
/// lights to tell what is lost: if none is, the patches together get just what is emitted. The sequence is the only
/// source of chance: the result is right on the average over its randomisations, but for the bias of a ratio of two
/// sums of a pair's few rays.
GatheredLight gather_direct_light(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                  std::uint64_t rays, const RunControl& run);

/// [W/m^2] Radiosity of every patch if light were reflected only once: what the patch emits, and what it reflects of
/// the light that comes straight from the sources. Found by gathering, for any method, without chance: always the same.
std::vector<Rgb> direct_radiosity(const Scene& scene, int threads);

} // namespace multipath

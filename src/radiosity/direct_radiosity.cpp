#include "radiosity/direct_radiosity.h"

#include "radiosity/gathered_light.h"
#include "sampling/sequence.h"

#include <algorithm>
#include <cstdint>
#include <memory>

namespace multipath {

std::vector<Rgb> direct_radiosity(const Scene& scene, int threads)
{
    // Enough for shadows that are smooth to the eye, in a part of the time that a solution takes. Of very many patches
    // each needs less, since the eye sees several as one.
    const std::uint64_t rays = std::clamp<std::uint64_t>(std::uint64_t{64} * scene.patch_count(), 1u << 18, 1u << 22);
    const std::unique_ptr<Sequence> sequence = make_sequence("sobol", 0);
    PowerState state(scene);
    receive(gather_direct_light(scene, *sequence, 0, rays, {threads}), scene, state);
    return radiosity(scene, state);
}

} // namespace multipath

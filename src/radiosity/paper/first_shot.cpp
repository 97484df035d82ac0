// plan_shots() divides the excess of the patches into rays of nearly equal power, spend() subtracts it from the
// patches, and shoot() lets the rays carry it to their receivers.

#include "radiosity/paper/first_shot.h"

#include "parallel/stage.h"
#include "radiosity/paper/shot_rays.h"

namespace multipath {

void shoot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const std::vector<Shot>& shots,
           const RunControl& run, PowerState& state)
{
    ShotRays rays(scene, sequence, first_item, shots, state);
    const std::uint64_t sent = run_stage("shots", rays, run); // (S1)
    rays.finish();
    keep_unsent(shots, sent, state);
}

} // namespace multipath

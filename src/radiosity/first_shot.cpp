#include "radiosity/first_shot.h"

#include <cmath>

namespace multipath {

namespace {

/// [1] Share of a patch's unshot power that lies above the threshold; in colour, the mean of the channels decides.
double share_above(const Scene& scene, const PowerState& state, double threshold, std::uint32_t patch)
{
    const double unshot_radiosity = mean(state.unshot[patch]) / scene.area(patch);
    return unshot_radiosity > threshold ? 1.0 - threshold / unshot_radiosity : 0.0;
}

} // namespace

std::vector<Shot> plan_first_shot(const Scene& scene, const PowerState& state, double threshold, std::uint64_t rays)
{
    double excess = 0.0; // [W]
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        excess += share_above(scene, state, threshold, i) * mean(state.unshot[i]);
    std::vector<Shot> shots;
    if (rays == 0 || !(excess > 0.0))
        return shots;

    const double power_by_line = excess / static_cast<double>(rays);
    double wanted = 0.0; // rays up to and including this patch, before rounding
    std::uint64_t given = 0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double share = share_above(scene, state, threshold, i);
        wanted += share * mean(state.unshot[i]) / power_by_line;
        const auto up_to_here = static_cast<std::uint64_t>(std::llround(wanted));
        // A patch that rounding leaves without a ray keeps its power for the global pass: nothing is lost or biased.
        if (share > 0.0 && up_to_here > given)
            shots.push_back(
                {i, up_to_here - given, (share / static_cast<double>(up_to_here - given)) * state.unshot[i]});
        given = up_to_here;
    }
    return shots;
}

} // namespace multipath

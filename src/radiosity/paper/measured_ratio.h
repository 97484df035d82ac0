#pragma once

#include "radiosity/paper/extended_first_shot.h"
#include "radiosity/paper/power_state.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/lines/global_lines.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// A first shot, plain or extended, with few rays of about equal power.
struct PilotShot
{
    PowerState after;             ///< the state when its passes were done
    std::vector<ShotPass> passes; ///< as shoot_extended() returned them
};

/// How the lines of a global pass cross a scene.
struct WalkDensity
{
    double departures_per_area = 0.0; ///< [1/m^2] packets that a square metre sends per global line, in expectation
    double arriving_share = 1.0;      ///< [1] fraction of all packets that arrive at a patch
    bool bidirectional = true;        ///< every crossing sends and receives (M2); otherwise half send, half receive
};

/// The densities of a global pass; the arriving share is estimated with 2^10 lines of the sequence from item
/// `first_item` on.
WalkDensity walk_density(const Scene& scene, const GlobalLines& global_lines, const Sequence& sequence,
                         std::uint64_t first_item, bool bidirectional);

/// Variances of the radiosity, summed over the area, that one line of each kind would leave: N_l local and N_g global
/// lines leave local / N_l + global / N_g ((V1) (V2) in docs/equations.md). [W^2/m^2]
struct LineVariances
{
    double local = 0.0;
    double global = 0.0;
};

/// The variances as a pilot shows them, for independent lines. Colours enter as the mean of their channels.
LineVariances line_variances(const Scene& scene, const PilotShot& pilot, const WalkDensity& walk);

/// N_l / N_g for which the sum of the variances is smallest at given N_l + N_g, at most 10^12; std::nullopt if no local
/// line arrives at a patch that reflects.
std::optional<double> best_ratio(const LineVariances& variances);

} // namespace multipath

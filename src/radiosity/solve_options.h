#pragma once

#include "radiosity/local_monte_carlo.h"
#include "sampling/sequence.h"

#include <cstdint>
#include <optional>
#include <string>

namespace multipath {

/// The methods of the paper: particles from the sources (L1); multi-path alone; multi-path after a first shot from the
/// sources (S1); multi-path after the extended first shot (S2).
enum class Method { local, global, first_shot, extended };

struct SolveOptions
{
    Method method = Method::first_shot;
    std::string sequence = "sobol"; ///< a name that make_sequence knows
    Pairing pairing = Pairing::four_dimensional;
    std::uint64_t seed = 1;         ///< of what is random
    std::uint64_t skip = 0;         ///< items of the sequence to leave out at its beginning
    std::uint64_t lines = 1u << 20; ///< N_l + N_g
    std::optional<double> ratio;    ///< N_l / N_g; empty: (3) with figures measured on the scene
    std::optional<double>
        power_by_line;               ///< [W] instead of the ratio: what one ray of the (extended) first shot carries
    std::optional<double> threshold; ///< [W/m^2] unshot radiosity kept by every patch; empty: (4)
    int most_steps = 1000;           ///< passes of the extended first shot
    bool bidirectional = true;       ///< (M2)
    Estimator estimator = Estimator::collision; ///< of the local method
    int threads = 1;
};

} // namespace multipath

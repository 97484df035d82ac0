#pragma once

#include "radiosity/item_plan.h"
#include "radiosity/local_monte_carlo.h"
#include "sampling/sequence.h"
#include "transport/line_sampling.h"

#include <cstdint>
#include <optional>
#include <string>

namespace multipath {

/// The methods of the paper: particles from the sources (L1); multi-path alone; multi-path after a first shot from the
/// sources (S1); multi-path after the extended first shot (S2). And ours: lines that are counted and solved for (R1).
enum class Method { local, global, first_shot, extended, reuse };

/// How `reuse` finds the light that comes straight from the sources: by rays of the extended first shot, or by rays
/// between pairs of patches, sources among them.
enum class Direct { shoot, gather };

struct SolveOptions
{
    Method method = Method::first_shot;
    std::string sequence = "sobol"; ///< a name that make_sequence knows
    Pairing pairing = Pairing::four_dimensional;
    LineOrder line_order = LineOrder::shuffled; ///< of the methods that walk along global lines
    std::optional<Chords> chords;               ///< empty: the method's own
    std::uint64_t seed = 1;                     ///< of what is random
    std::uint64_t skip = 0;                     ///< items of the sequence to leave out at its beginning
    std::uint64_t lines = 1u << 20;             ///< N_l + N_g
    std::optional<double> ratio;                ///< N_l / N_g; empty: (3) with figures measured on the scene
    std::optional<double> power_by_line;        ///< [W] of one ray of the (extended) first shot, instead of the ratio
    std::optional<double> threshold;            ///< [W/m^2] unshot radiosity kept by every patch; empty: (4)
    int most_steps = 1000;                      ///< passes of the extended first shot
    bool bidirectional = true;                  ///< (M2)
    Estimator estimator = Estimator::collision; ///< of the local method
    Direct direct = Direct::gather;             ///< of the method `reuse`
    double memory = 2e9;                        ///< [bytes] that the run may take; `reuse` keeps its pairs within
    int threads = 1;
};

/// How the run draws its global lines; the methods of the paper draw them from the sphere.
inline Chords chords_of(const SolveOptions& options)
{
    return options.chords.value_or(options.method == Method::reuse ? Chords::box : Chords::sphere);
}

} // namespace multipath

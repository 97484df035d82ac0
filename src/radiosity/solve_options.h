#pragma once

#include "radiosity/family/importance.h"
#include "radiosity/local_monte_carlo.h"
#include "radiosity/methods.h"
#include "sampling/sequence.h"
#include "sampling/shuffled_order.h"
#include "transport/lines/global_lines.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace multipath {

/// Which items of the sequence serve which stage: one running number through the whole sequence, so that no item serves
/// twice. The first `skip` items are left out; then come the rays of the first shot, one item each, in the order of the
/// patches; then the global lines, one item each. Two stages of a quasi-random sequence together are then as evenly
/// spread as one.
struct ItemPlan
{
    std::uint64_t first_shot = 0;  ///< first item of the first shot
    std::uint64_t global_pass = 0; ///< first item of the global pass
    std::uint64_t end = 0;         ///< one after the last item used
};

/// Throws SettingsError when the sequence has too few items.
ItemPlan plan_items(const Sequence& sequence, std::uint64_t skip, std::uint64_t local_lines,
                    std::uint64_t global_lines_cast);

/// In which order a walk follows its global lines: that of the sequence, as the paper does, or shuffled in blocks.
/// What a line carries depends on those before it, and successive items of a quasi-random sequence are not independent:
/// in their own order they make the walk converge to something slightly wrong.
enum class LineOrder { sequence, shuffled };

/// The items first_item ... first_item + lines - 1 of the sequence in the order of the walk.
inline ShuffledOrder walking_order(const Sequence& sequence, LineOrder order, std::uint64_t first_item,
                                   std::uint64_t lines)
{
    return {sequence, first_item, order == LineOrder::shuffled ? lines : 0};
}

/// How `reuse` finds the light that comes straight from the sources: by rays of the extended first shot, or by rays
/// between pairs of patches, sources among them.
enum class Direct { shoot, gather };

struct SolveOptions
{
    Method method = Method::first_shot;
    std::string sequence = "sobol"; ///< a name that make_sequence knows
    Pairing pairing = Pairing::four_dimensional;
    LineOrder line_order = LineOrder::shuffled;   ///< of the methods that walk along global lines
    std::optional<Chords> chords;                 ///< empty: the method's own
    std::uint64_t seed = 1;                       ///< of what is random
    std::uint64_t skip = 0;                       ///< items of the sequence to leave out at its beginning
    std::uint64_t lines = 1u << 20;               ///< N_l + N_g
    std::optional<double> ratio;                  ///< N_l / N_g; empty: (3) with figures measured on the scene
    std::optional<double> power_by_line;          ///< [W] of one ray of the (extended) first shot, instead of the ratio
    std::optional<double> threshold;              ///< [W/m^2] unshot radiosity kept by every patch; empty: (4)
    int most_steps = 1000;                        ///< passes of the extended first shot
    bool bidirectional = true;                    ///< (M2)
    Estimator estimator = Estimator::collision;   ///< of the local method
    std::uint64_t bundle = 256;                   ///< parallel lines of each direction, of the method transillumination
    std::shared_ptr<const Importance> importance; ///< of the method jacobi; empty: all patches are equal
    Direct direct = Direct::gather;               ///< of the method `reuse`
    bool denoise = true;                          ///< of the method `reuse`
    bool all_pairs = true;                        ///< may `reuse` make a table of all pairs where it pays?
    double memory = 2e9;                          ///< [bytes] that the run may take; `reuse` keeps its pairs within
    int threads = 1;
};

/// How the run draws its global lines.
inline Chords chords_of(const SolveOptions& options)
{
    return options.chords.value_or(options.method->chords);
}

} // namespace multipath

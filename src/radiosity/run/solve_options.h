#pragma once

#include "radiosity/family/importance.h"
#include "radiosity/paper/local_monte_carlo.h"
#include "radiosity/run/methods.h"
#include "sampling/sequence.h"
#include "sampling/shuffled_order.h"
#include "transport/lines/global_lines.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace multipath {

/// The order in which a walk follows its global lines: that of the sequence, as in the paper, or shuffled in blocks. A
/// line carries what the lines before it have left, and successive items of a quasi-random sequence are not
/// independent. In the order of such a sequence the walk converges to a slightly wrong result.
enum class LineOrder { sequence, shuffled };

/// The sequence with its items first_item ... first_item + lines - 1 in the order of the walk. `sequence` must outlive
/// the result.
inline ShuffledOrder walking_order(const Sequence& sequence, LineOrder order, std::uint64_t first_item,
                                   std::uint64_t lines)
{
    return {sequence, first_item, order == LineOrder::shuffled ? lines : 0};
}

/// How the method `reuse` finds the direct light. shoot: by rays of the extended first shot. gather: by rays between
/// pairs of patches if it makes a table of all pairs, else by shadow rays from the patches to the lights.
enum class Direct { shoot, gather };

/// Options of a run. Those that a method does not use (MethodInfo::options) have no effect.
struct SolveOptions
{
    Method method = Method::first_shot;
    std::string sequence = "sobol"; ///< a name known to make_sequence
    Pairing pairing = Pairing::four_dimensional;
    LineOrder line_order = LineOrder::shuffled;   ///< for methods whose power walks along global lines
    std::optional<Chords> chords;                 ///< empty: default of the method
    std::uint64_t seed = 1;                       ///< seed of all random numbers
    std::uint64_t skip = 0;                       ///< number of items to omit at the beginning of the sequence
    std::uint64_t lines = 1u << 20;               ///< number of local and global lines together
    std::optional<double> ratio;                  ///< local lines per global line; empty: see ratio_for()
    bool measured_ratio = false;                  ///< `ratio` is empty: the best by a pilot (measured_ratio.h), not (3)
    std::optional<double> power_by_line;          ///< [W] power of one ray of a first shot; replaces the ratio
    std::optional<double> threshold;              ///< [W/m^2] unshot radiosity kept by every patch in a first shot;
                                                  ///< empty: threshold_radiosity()
    int most_steps = 1000;                        ///< maximum number of passes of the extended first shot
    bool bidirectional = true;                    ///< power flows both ways along a line (M2); if false, one way only
    Estimator estimator = Estimator::collision;   ///< for the methods local and gathering
    std::optional<std::uint64_t> bundle;          ///< parallel lines per direction, for transillumination; empty:
                                                  ///< about as many as directions
    std::shared_ptr<const Importance> importance; ///< for the method reuse, which then makes no table of all pairs;
                                                  ///< null: all patches are equally important
    Direct direct = Direct::gather;               ///< for the method reuse
    bool denoise = true;                          ///< for the method reuse without a table of all pairs
    bool all_pairs = true;                        ///< allows reuse to make a table of all pairs where that pays
    double memory = 2e9; ///< [bytes] for the whole run; limits the table and the counts of reuse
    int threads = 1;
};

/// Distribution of the global lines of the run: options.chords, or the default of the method.
inline Chords chords_of(const SolveOptions& options)
{
    return options.chords.value_or(options.method->chords);
}

} // namespace multipath

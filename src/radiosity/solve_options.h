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

/// Which stage uses which items of the sequence. One running number through the whole sequence ensures that no item is
/// used twice: after `skip` omitted items come the rays of the first shot, one item each in the order of the patches,
/// then the global lines, one item each. Two stages of a quasi-random sequence together are then as evenly spread as
/// one.
struct ItemPlan
{
    std::uint64_t first_shot = 0;  ///< first item of the first shot
    std::uint64_t global_pass = 0; ///< first item of the global pass
    std::uint64_t end = 0;         ///< one past the last item used
};

/// Throws SettingsError if the sequence has too few items.
ItemPlan plan_items(const Sequence& sequence, std::uint64_t skip, std::uint64_t local_lines,
                    std::uint64_t global_lines_cast);

/// The order in which a walk follows its global lines: that of the sequence, as in the paper, or shuffled in blocks.
/// What a line carries depends on the lines before it, and successive items of a quasi-random sequence are not
/// independent. In their own order they make the walk converge to a slightly wrong result.
enum class LineOrder { sequence, shuffled };

/// The items first_item ... first_item + lines - 1 of the sequence, in the order of the walk.
inline ShuffledOrder walking_order(const Sequence& sequence, LineOrder order, std::uint64_t first_item,
                                   std::uint64_t lines)
{
    return {sequence, first_item, order == LineOrder::shuffled ? lines : 0};
}

/// How `reuse` finds the direct light: by rays of the extended first shot, or by rays between pairs of patches, or
/// patches and lights.
enum class Direct { shoot, gather };

struct SolveOptions
{
    Method method = Method::first_shot;
    std::string sequence = "sobol"; ///< a name known to make_sequence
    Pairing pairing = Pairing::four_dimensional;
    LineOrder line_order = LineOrder::shuffled;   ///< for methods whose power walks along global lines
    std::optional<Chords> chords;                 ///< empty: default of the method
    std::uint64_t seed = 1;                       ///< of all random numbers
    std::uint64_t skip = 0;                       ///< number of items to omit at the beginning of the sequence
    std::uint64_t lines = 1u << 20;               ///< N_l + N_g
    std::optional<double> ratio;                  ///< N_l / N_g; empty: (3), with figures measured in the scene
    std::optional<double> power_by_line;          ///< [W] of one ray of the (extended) first shot; replaces the ratio
    std::optional<double> threshold;              ///< [W/m^2] unshot radiosity kept by every patch; empty: (4)
    int most_steps = 1000;                        ///< maximum number of passes of the extended first shot
    bool bidirectional = true;                    ///< (M2)
    Estimator estimator = Estimator::collision;   ///< for the methods local and gathering
    std::optional<std::uint64_t> bundle;          ///< parallel lines per direction, for transillumination; empty: auto
    std::shared_ptr<const Importance> importance; ///< for the method jacobi; empty: all patches are equally important
    Direct direct = Direct::gather;               ///< for the method reuse
    bool denoise = true;                          ///< for the method reuse
    bool all_pairs = true;                        ///< allows reuse to make a table of all pairs if that pays
    double memory = 2e9;                          ///< [bytes] for the whole run; reuse limits its pairs accordingly
    int threads = 1;
};

/// Distribution of the global lines of the run.
inline Chords chords_of(const SolveOptions& options)
{
    return options.chords.value_or(options.method->chords);
}

} // namespace multipath

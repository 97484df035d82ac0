#pragma once

#include "sampling/sequence.h"
#include "sampling/shuffled_order.h"

#include <cstdint>

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

} // namespace multipath

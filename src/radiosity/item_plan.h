#pragma once

#include "sampling/sequence.h"

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

/// Throws InputError when the sequence has too few items.
ItemPlan plan_items(const Sequence& sequence, std::uint64_t skip, std::uint64_t local_lines,
                    std::uint64_t global_lines_cast);

} // namespace multipath

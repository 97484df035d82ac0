#pragma once

#include "sampling/sequence.h"

#include <cstdint>

namespace multipath {

/// Which stage uses which items of the sequence. Each stage takes the items after those of the stage before it, so no
/// item is used twice: after the omitted items come those of the rays of the first shot, one per ray in the order of
/// the patches, then those of the global lines, one per line. In a quasi-random sequence, the items of both stages
/// together are then as evenly spread as those of one stage.
struct ItemPlan
{
    std::uint64_t first_shot = 0;  ///< index of the first item of the first shot
    std::uint64_t global_pass = 0; ///< index of the first item of the global pass
    std::uint64_t end = 0;         ///< one past the last item used
};

/// Plans the items of a run that omits `skip` items, and then casts `local_lines` local lines and `global_lines_cast`
/// global lines. Throws SettingsError if the sequence has too few items.
ItemPlan plan_items(const Sequence& sequence, std::uint64_t skip, std::uint64_t local_lines,
                    std::uint64_t global_lines_cast);

} // namespace multipath

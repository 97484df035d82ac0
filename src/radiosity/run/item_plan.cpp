#include "radiosity/run/item_plan.h"

#include "base/errors.h"

#include <string>

namespace multipath {

ItemPlan plan_items(const Sequence& sequence, std::uint64_t skip, std::uint64_t local_lines,
                    std::uint64_t global_lines_cast)
{
    const std::uint64_t limit = sequence.item_limit();
    const std::uint64_t needed = local_lines + global_lines_cast;
    if (skip > limit || needed > limit - skip)
        throw SettingsError("the sequence " + sequence.name() + " ends after " + std::to_string(limit) +
                            " items, but these lines need " + std::to_string(needed) +
                            (skip > 0 ? " after those skipped" : ""));
    return {skip, skip + local_lines, skip + needed};
}

} // namespace multipath

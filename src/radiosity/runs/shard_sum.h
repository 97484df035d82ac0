#pragma once

#include "parallel/archive.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Adds up the results of all shards of a run of `reuse`: counts of lines or rays, shadow rays, or refined rows of the
/// table of pairs. `parts`: names of the parts under way in each shard, the outermost first. Writes to `sum` the data
/// that differ between the shards; the state is then that of a run that did all the work alone. Throws ArchiveError
/// unless the shards are complete, finished, and of the same stage.
void add_up_shards(const std::vector<Archive*>& shards, const std::vector<std::string>& parts, std::uint32_t patches,
                   int threads, Archive& sum);

} // namespace multipath

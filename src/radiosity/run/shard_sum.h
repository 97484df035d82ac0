#pragma once

#include "base/archive.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Adds up the results of all shards of a run of the method `reuse`. The shards are partial runs that share the lines
/// of the whole run, usually on several computers. Their results are counts of global lines, counts of rays and sums
/// over shadow rays, or refined rows of the table of pairs. `shards` holds the saved state of each shard, in any order;
/// `parts` the names of the parts (Checkpoint) under way, the same in all shards, the outermost first; `patches` is the
/// number of patches of the scene. Writes to `sum` the data that differ between the shards; all other data of a saved
/// shard are the same as in a run that did all the work alone. Throws ArchiveError if a shard is missing, occurs twice
/// or is not finished, or if the shards do not fit together.
void add_up_shards(const std::vector<Archive*>& shards, const std::vector<std::string>& parts, std::uint32_t patches,
                   int threads, Archive& sum);

} // namespace multipath

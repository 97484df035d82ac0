#pragma once

#include "parallel/archive.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Adds up what the shares of a run of `reuse` handed in: counts of lines or rays, rays to the lights, or the rows of
/// pairs at which each of them looked closer. `parts`: those under way in each of them, the outermost first. Writes
/// what is not the same in all shares; the whole is then the state of a run that did all of it alone. Throws
/// ArchiveError for shares that are not all, once, or of different stages.
void add_up_shares(const std::vector<Archive*>& shares, const std::vector<std::string>& parts, std::uint32_t patches,
                   int threads, Archive& sum);

} // namespace multipath

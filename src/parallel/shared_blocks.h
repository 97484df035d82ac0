#pragma once

#include "parallel/run_control.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// Which pieces of work, of all that are shared, a run does, and how far it is.
struct SharedRange
{
    std::uint64_t all = 0; ///< pieces of all shares together
    std::uint64_t first = 0;
    std::uint64_t next = 0; ///< first ... next - 1 are done
    std::uint64_t end = 0;
    std::uint64_t shares = 1; ///< into which the work is cut; 1 also after they were united

    static SharedRange of(std::uint64_t all, Share share)
    {
        return {all, share.begin(all), share.begin(all), share.end(all), share.of};
    }
    /// Has others' work to be added? A share may have all pieces, if there are few.
    bool is_share() const { return shares > 1; }

    void visit(Archive& archive); ///< for a checkpoint; throws ArchiveError for what cannot be
};

/// What several shares have done together, in any order. Throws ArchiveError unless it is everything, once.
SharedRange united(std::vector<SharedRange> ranges);

/// The blocks `range` of a stage whose result is a sum of what they find, as resumable_blocks. If other runs do the
/// rest, this one hands in what it has when it is done, and ends.
void shared_blocks(SharedRange& range, const RunControl& run,
                   const std::function<void(std::uint64_t block, int slot)>& produce,
                   const std::function<void(std::uint64_t block, int slot)>& consume);

} // namespace multipath

#include "parallel/shared_blocks.h"

#include "parallel/ordered_blocks.h"

#include <algorithm>

namespace multipath {

void SharedRange::visit(Archive& archive)
{
    archive.value<std::uint64_t>("pieces of all", all);
    archive.value<std::uint64_t>("first piece", first);
    archive.value<std::uint64_t>("next piece", next);
    archive.value<std::uint64_t>("end piece", end);
    archive.value<std::uint64_t>("shares", shares);
    if (first > next || next > end || end > all)
        throw ArchiveError("the state is damaged: no such pieces of work");
}

SharedRange united(std::vector<SharedRange> ranges)
{
    std::sort(ranges.begin(), ranges.end(), [](const SharedRange& a, const SharedRange& b) {
        return a.first < b.first || (a.first == b.first && a.end < b.end);
    });
    std::uint64_t done = 0;
    for (const SharedRange& range : ranges) {
        if (range.first != done || range.next != range.end || range.all != ranges[0].all)
            throw ArchiveError("the shares do not fit together; expected all shares of one run, each of them finished");
        done = range.end;
    }
    if (done != ranges[0].all)
        throw ArchiveError("the shares are not all there; expected each share of the run");
    return {done, 0, done, done, 1};
}

void shared_blocks(SharedRange& range, const RunControl& run, const std::function<void(std::uint64_t, int)>& produce,
                   const std::function<void(std::uint64_t, int)>& consume)
{
    resumable_blocks(range.next, range.end, run, produce, consume);
    if (range.is_share() && !run.stopped())
        run.checkpoint->hand_in();
}

} // namespace multipath

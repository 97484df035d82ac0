#include "parallel/shared_blocks.h"

#include "parallel/ordered_blocks.h"

namespace multipath {

void SharedBlocks::visit(Archive& archive)
{
    archive.value<std::uint64_t>("first block", first_);
    archive.value<std::uint64_t>("next block", next_);
    archive.value<std::uint64_t>("end block", end_);
    if (first_ > next_ || next_ > end_ || end_ > blocks_)
        throw ArchiveError("the state is damaged: no such blocks");
}

void SharedBlocks::run(const RunControl& control, const std::function<void(std::uint64_t, int)>& produce,
                       const std::function<void(std::uint64_t, int)>& consume)
{
    resumable_blocks(next_, end_, control, produce, consume);
    if (end_ - first_ < blocks_ && !control.stopped())
        control.checkpoint->hand_in();
}

} // namespace multipath

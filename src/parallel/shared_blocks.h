#pragma once

#include "parallel/run_control.h"

#include <cstdint>
#include <functional>

namespace multipath {

/// The blocks of a stage whose result is a sum of what they find, so that several runs can share them: this one does
/// its part and hands it in.
class SharedBlocks
{
public:
    SharedBlocks(std::uint64_t blocks, Share share) : SharedBlocks(blocks, share.begin(blocks), share.end(blocks)) {}
    /// This run does first ... end - 1 of them.
    SharedBlocks(std::uint64_t blocks, std::uint64_t first, std::uint64_t end)
        : blocks_(blocks), first_(first), next_(first), end_(end)
    {
    }

    /// What a part of a checkpoint needs to hold of them.
    void visit(Archive& archive);

    /// The blocks of this run that are still to be done, as resumable_blocks. If others do the rest, the run then ends.
    void run(const RunControl& control, const std::function<void(std::uint64_t block, int slot)>& produce,
             const std::function<void(std::uint64_t block, int slot)>& consume);

    std::uint64_t first() const { return first_; }
    std::uint64_t next() const { return next_; } ///< first ... next - 1 are done

private:
    std::uint64_t blocks_;
    std::uint64_t first_;
    std::uint64_t next_;
    std::uint64_t end_;
};

} // namespace multipath

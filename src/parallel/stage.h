#pragma once

#include "parallel/blocks.h"
#include "parallel/run_control.h"

namespace multipath {

/// Carries out a stage of a run: threads trace blocks of its lines, one thread at a time takes them in order, so that
/// the result does not depend on the number of threads. A checkpoint may pause the stage between two blocks; a shard
/// does its part of the blocks. Returns the number of lines before the first block that is not done: all lines, unless
/// the checkpoint has stopped the run. `name`: that of its part in the checkpoint. A Stage has
///
///   using Block = ...;                                      // what one thread traces at a time
///   Blocks lines() const;                                   // all lines of the stage
///   void trace(std::uint64_t number, Block& block) const;   // on any thread
///   std::uint64_t take(std::uint64_t number, const Block&); // adds the block to the results; returns lines to count
///   void visit(Archive& archive);                           // saves or restores the results so far
///
/// Throws ArchiveError if the checkpoint holds the state of another stage.
template <class Stage>
std::uint64_t run_stage(const char* name, Stage& stage, const RunControl& run)
{
    using Block = typename Stage::Block;
    const Blocks lines = stage.lines();
    ShardRange range = ShardRange::of(lines.count(), run.shard);
    const Checkpoint::Part part(run.checkpoint, name, [&](Archive& archive) {
        range.visit(archive);
        stage.visit(archive);
    });
    if (range.all != lines.count())
        throw ArchiveError("the state is damaged: no such lines");
    BlockBuffers<Block> blocks(run.threads);
    shard_blocks(
        range, run, [&](std::uint64_t number, int slot) { stage.trace(number, blocks[slot]); },
        [&](std::uint64_t number, int slot) { run.count_lines(stage.take(number, blocks[slot])); });
    return lines.first(range.next);
}

} // namespace multipath

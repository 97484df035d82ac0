#pragma once

#include "base/errors.h"
#include "parallel/blocks.h"
#include "parallel/run_control.h"

namespace multipath {

/// Carries out a stage of a run: threads trace blocks of its lines (or rays, walks, directions), and take them in
/// order, so that the result does not depend on the number of threads. A checkpoint may pause the stage between two
/// blocks; a shard does its part of the blocks. `name`: that of its part in the checkpoint. Returns the number of lines
/// before the first block that is not done: all lines, unless the checkpoint has stopped the run. A Stage has
///
///   using Block = ...;
///   Blocks lines() const;
///   void trace(std::uint64_t number, Block& block) const;
///   std::uint64_t take(std::uint64_t number, const Block& block);
///   void visit(Archive& archive);
///
/// Block: what one thread traces at a time. lines(): all lines of the stage, the same with any number of threads.
/// trace() traces block `number`, take() adds it to the results and returns the number of lines that it counts, visit()
/// saves or restores the results.
///
/// trace() runs on any thread, several at once, and while take() runs: it reads nothing that take() changes. take()
/// runs once at a time, in the order of the numbers, on changing threads. A block is used again as it was left. visit()
/// names all that take() changes, also outside the stage. A run that is resumed must make an equal stage again.
/// Exceptions as in parallel_blocks. Throws ArchiveError if the checkpoint holds the state of another stage. A short
/// example is GlobalStage in radiosity/paper/multipath.cpp.
template <class Stage>
std::uint64_t run_stage(const char* name, Stage& stage, const RunControl& run)
{
    const Blocks lines = stage.lines();
    ShardRange range = ShardRange::of(lines.count(), run.shard);
    const Checkpoint::Part part(run.checkpoint, name, [&](Archive& archive) {
        range.visit(archive);
        stage.visit(archive);
    });
    if (range.all != lines.count())
        throw ArchiveError("the state is damaged: no such lines");
    BlockBuffers<typename Stage::Block> blocks(run.threads);
    shard_blocks(
        range, run, [&](std::uint64_t number, int slot) { stage.trace(number, blocks[slot]); },
        [&](std::uint64_t number, int slot) { run.count_lines(stage.take(number, blocks[slot])); });
    return lines.first(range.next);
}

} // namespace multipath

#pragma once

#include "parallel/run_control.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/exchange/pair_matrix.h"
#include "transport/lines/global_lines.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Numbers of lines through a pair of patches that face each other along the line.
struct PairCount
{
    std::uint32_t joined = 0;  ///< lines with no surface in between
    std::uint32_t through = 0; ///< all lines, occluded ones included
};

/// Counts of global lines for every pair of patches. Sums of integers are exact: however the lines are split and in
/// whatever order the counts are added, the bits are the same.
struct PairCounts
{
    explicit PairCounts(std::uint32_t patches) : pairs(patches), escaped(patches, 0), behind(patches, 0) {}

    PairCounts& operator+=(const PairCounts& others); ///< of the same scene
    void visit(Archive& archive);                     ///< saves to or restores from a checkpoint

    std::uint64_t lines = 0;            ///< global lines cast
    PairMatrix<PairCount> pairs;        ///< lines through each pair of patches
    std::vector<std::uint64_t> escaped; ///< per patch: lines that left its front and met nothing more
    std::vector<std::uint64_t> behind;  ///< per patch: lines that left its front and met a surface from behind
};

/// Casts global lines from the items first_item, first_item + 1, ... and counts what they join. Casts all `lines_cast`
/// of them, those of the run's shard, or fewer if the run is stopped; PairCounts::lines says how many. Needs lines_cast
/// < 2^32, so that no count can overflow.
PairCounts count_pairs(const Scene& scene, const GlobalLines& lines, const Sequence& sequence, std::uint64_t first_item,
                       std::uint64_t lines_cast, const RunControl& run);

} // namespace multipath

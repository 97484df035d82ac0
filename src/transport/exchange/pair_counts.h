#pragma once

#include "parallel/run_control.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/exchange/pair_matrix.h"
#include "transport/lines/global_lines.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Numbers of lines that cross both patches of a pair, front facing front along the line.
struct PairCount
{
    std::uint32_t joined = 0;  ///< lines with no surface in between
    std::uint32_t through = 0; ///< all lines, with or without surfaces in between
};

/// Counts of global lines for every pair of patches. Sums of integers are exact, so the bits do not depend on how the
/// lines are divided, or in which order the counts are added.
struct PairCounts
{
    explicit PairCounts(std::uint32_t patches) : pairs(patches), escaped(patches, 0), behind(patches, 0) {}

    PairCounts& operator+=(const PairCounts& others); ///< needs counts of the same scene
    void visit(Archive& archive);                     ///< saves the counts to a checkpoint or restores them

    std::uint64_t lines = 0;            ///< global lines cast
    PairMatrix<PairCount> pairs;        ///< lines through each pair of patches
    std::vector<std::uint64_t> escaped; ///< per patch: lines that left its front, in either direction, and met nothing
    std::vector<std::uint64_t> behind;  ///< per patch: lines that left its front and next met a side without a patch
};

/// Casts global lines, line k with the item first_item + k for k = 0 ... lines_cast - 1, and counts the pairs of
/// patches along them. A shard (one of several runs that divide the work) casts only its part of the lines, a run that
/// is stopped casts fewer; PairCounts::lines is the number of lines that were cast. Needs lines_cast < 2^32, so that no
/// count can overflow.
PairCounts count_pairs(const Scene& scene, const GlobalLines& lines, const Sequence& sequence, std::uint64_t first_item,
                       std::uint64_t lines_cast, const RunControl& run);

} // namespace multipath

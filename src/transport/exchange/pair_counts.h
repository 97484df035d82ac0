#pragma once

#include "parallel/run_control.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/exchange/pair_matrix.h"
#include "transport/lines/global_lines.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Lines that leave the front of one patch and reach the front of another one, in either direction.
struct PairCount
{
    std::uint32_t joined = 0;  ///< those with nothing in between
    std::uint32_t through = 0; ///< all
};

/// What global lines tell of every pair of patches. Integers: the counts of any parts of the lines can be added, in any
/// order, and give the same bits.
struct PairCounts
{
    explicit PairCounts(std::uint32_t patches) : pairs(patches), escaped(patches, 0), behind(patches, 0) {}

    PairCounts& operator+=(const PairCounts& others);
    void visit(Archive& archive); ///< for a checkpoint

    std::uint64_t lines = 0; ///< global lines cast
    PairMatrix<PairCount> pairs;
    std::vector<std::uint64_t> escaped; ///< per patch: lines that left its front and met nothing more
    std::vector<std::uint64_t> behind;  ///< per patch: lines that left its front and met a surface from behind
};

/// Casts global lines, which take the items from first_item on, and counts: all of them, the share of the run, or fewer
/// if it is stopped. Needs lines_cast < 2^32, so that no count can overflow.
PairCounts count_pairs(const Scene& scene, const GlobalLines& lines, const Sequence& sequence, std::uint64_t first_item,
                       std::uint64_t lines_cast, const RunControl& run);

} // namespace multipath

#pragma once

#include "radiosity/solution.h"

#include <cstdint>

namespace multipath {

/// The outermost part of every run that can be left and taken up again: what its finished pieces found.
struct RunRecord
{
    static constexpr const char* part = "work";

    /// Finished ones: stretches of lines that are averaged, or rounds of which the last one counts.
    std::uint64_t pieces = 0;
    std::uint64_t lines = 0; ///< asked for up to the end of the last finished piece; of rounds, in the last one
    std::uint64_t goal = 0;  ///< what `lines` will be after the piece under way; 0 without one: the run is finished
    Solution solution;       ///< of the finished pieces; empty without any

    /// The piece under way is done; `found` is what all pieces together tell now.
    void finish_piece(Solution found);

    void visit(Archive& archive, std::uint32_t patches); ///< for a checkpoint
};

} // namespace multipath

#pragma once

#include "parallel/archive.h"
#include "radiosity/extended_first_shot.h"
#include "radiosity/power_state.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// What a run has found.
struct Solution
{
    std::vector<Rgb> radiosity; ///< [W/m^2] per patch
    /// [W/m^2] per patch: received or emitted, not yet sent on when the work ended. Of the method `reuse` what the
    /// solution lacks or has too much.
    std::vector<Rgb> unshot;
    PowerBalance balance;
    std::uint64_t local_lines = 0;  ///< N_l
    std::uint64_t global_lines = 0; ///< N_g, charged by (N1)
    std::uint64_t global_lines_cast = 0;
    std::vector<ShotPass> shot_passes; ///< of the (extended) first shot; with replicates of the first one
    std::uint64_t all_lines = 0;       ///< charged, rounds before included that led to this result

    int replicates = 1;
    std::vector<Rgb> standard_error;               ///< [W/m^2] per patch; empty without replicates
    std::optional<double> relative_standard_error; ///< [1] root of the relative MSE (1) to be expected

    void visit(Archive& archive, std::uint32_t patches); ///< for a checkpoint
};

/// What independent runs of the same scene tell together: their mean, weighted by their lines. Needs at least one.
Solution combined(const Scene& scene, const std::vector<Solution>& parts);

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

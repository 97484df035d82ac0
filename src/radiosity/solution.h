#pragma once

#include "parallel/archive.h"
#include "radiosity/extended_first_shot.h"
#include "radiosity/power_state.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// The result of a run.
struct Solution
{
    std::vector<Rgb> radiosity; ///< [W/m^2] per patch
    /// [W/m^2] per patch: received or emitted, but not sent on when the work ended. For `reuse` the residual of the
    /// solution, of either sign.
    std::vector<Rgb> unshot;
    PowerBalance balance;
    std::uint64_t local_lines = 0;  ///< N_l
    std::uint64_t global_lines = 0; ///< N_g, charged by (N1)
    std::uint64_t global_lines_cast = 0;
    std::vector<ShotPass> shot_passes; ///< of the (extended) first shot; of the first replicate
    std::uint64_t all_lines = 0;       ///< charged in total, including earlier rounds that led to this result

    int replicates = 1;
    std::vector<Rgb> standard_error;               ///< [W/m^2] per patch; empty without replicates
    std::optional<double> relative_standard_error; ///< [1] square root of the expected relative MSE (1)

    void visit(Archive& archive, std::uint32_t patches); ///< for a checkpoint
};

/// The mean of independent runs of one scene, weighted by their lines. It has standard errors if all parts have them.
/// `parts` must not be empty.
Solution combined(const Scene& scene, const std::vector<Solution>& parts);

/// The outermost part of every run that can be interrupted and resumed: the result of its finished pieces.
struct RunRecord
{
    static constexpr const char* part = "work";

    /// Number of finished pieces: runs over successive lines, which are averaged, or rounds, of which the last one
    /// counts.
    std::uint64_t pieces = 0;
    std::uint64_t lines = 0; ///< requested up to the end of the last finished piece; of rounds, by the last one
    std::uint64_t goal = 0;  ///< value of `lines` after the current piece; 0 if there is none: the run is finished
    Solution solution;       ///< of the finished pieces; empty if there are none

    /// Ends the current piece; `found` is the result of all pieces together.
    void finish_piece(Solution found);

    void visit(Archive& archive, std::uint32_t patches); ///< for a checkpoint
};

} // namespace multipath

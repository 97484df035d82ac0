#pragma once

#include "base/archive.h"
#include "base/errors.h"
#include "radiosity/paper/extended_first_shot.h"
#include "radiosity/paper/power_state.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// A method has found no sound solution with its lines. Particles find one (Solution::by_particles).
struct NoSolution : InputError
{
    using InputError::InputError;
};

/// The result of a run.
struct Solution
{
    std::vector<Rgb> radiosity; ///< [W/m^2] per patch
    /// [W/m^2] per patch: emitted or reflected power per area that was not sent on when the work ended. For the method
    /// `reuse`, the residual of the linear system, of either sign.
    std::vector<Rgb> unshot;
    PowerBalance balance;
    std::uint64_t local_lines = 0;       ///< N_l, number of rays from patches
    std::uint64_t global_lines = 0;      ///< N_g, number of lines charged: those expected to meet the scene's box (N1)
    std::uint64_t global_lines_cast = 0; ///< number of global lines cast, including those that miss the box
    std::vector<ShotPass> shot_passes;   ///< passes of the first shot; with replicates, those of the first one
    std::uint64_t all_lines = 0; ///< lines charged in total, including those of earlier rounds that led to this result

    bool by_particles = false; ///< the method of the run found no solution, and particles carried the light instead
    int replicates = 1;        ///< number of independent runs of which this is the mean
    std::vector<Rgb> standard_error; ///< [W/m^2] per patch; empty with a single replicate
    /// [1] Square root of the expected relative mean square error (expected_relative_square); empty with a single
    /// replicate.
    std::optional<double> relative_standard_error;

    /// Saves the solution to a checkpoint or restores it. Throws ArchiveError if its lists do not have `patches`
    /// elements.
    void visit(Archive& archive, std::uint32_t patches);
};

/// Adds a part of a mean: `share` [1] times its powers per patch and its balance, and its numbers of lines. The lists
/// of `sum` must have an element per patch.
void add(const Solution& part, double share, Solution& sum);

/// The mean of independent solutions of one scene, weighted by their lines (all_lines); its numbers of lines are the
/// sums of theirs. It has standard errors if all parts have them; shot_passes and replicates are those of the first
/// part. `parts` must not be empty.
Solution combined(const Scene& scene, const std::vector<Solution>& parts);

/// The outermost part (Checkpoint::Part) of every run that can be interrupted and resumed. The run consists of pieces:
/// either runs over successive lines, whose results are averaged, or rounds, of which only the last one counts. The
/// record holds the result of the finished pieces.
struct RunRecord
{
    static constexpr const char* part = "work"; ///< name of the part

    std::uint64_t pieces = 0; ///< number of finished pieces
    /// Number of lines requested for all finished pieces together; with rounds, for the last finished round.
    std::uint64_t lines = 0;
    std::uint64_t goal = 0; ///< value of `lines` after the current piece; 0 if there is no current piece
    Solution solution;      ///< result of the finished pieces; empty if there are none

    /// Ends the current piece; `found` is the result of all finished pieces, including this one.
    void finish_piece(Solution found);

    /// Saves the record to a checkpoint or restores it. Throws ArchiveError like Solution::visit.
    void visit(Archive& archive, std::uint32_t patches);
};

} // namespace multipath

#pragma once

#include "parallel/run_control.h"
#include "radiosity/paper/power_state.h"
#include "radiosity/run/solve.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace multipath {

/// One run of a method: its inputs and its results so far. The stages of the method (methods.h) advance it.
class Run
{
public:
    /// Keeps references to scene and options. `progress` may be empty. Throws SettingsError if the sequence has too few
    /// items or the method cannot take so many lines, std::invalid_argument for a sequence that cannot be made.
    Run(const Scene& scene, const SolveOptions& options, const Preparation& preparation = {},
        const ProgressCallback& progress = {}, Checkpoint* checkpoint = nullptr, Shard shard = {});

    /// Carries out all stages, from the first one that the checkpoint does not contain as finished. If the checkpoint
    /// stops the run, the result is that of the work so far. If no stage has found a solution or cast a global line by
    /// then, up to 2^18 random global lines distribute the unshot power (not in a shard). Throws NoSolution if the
    /// result of a run that was not stopped is not sound: not finite, darker than the emission or, if no forecast was
    /// sent, with an emitted power other than that of the sources.
    Solution solve();

    const Scene& scene;
    const SolveOptions& options;
    const Preparation preparation;
    const Shard shard;
    const std::unique_ptr<const Sequence> sequence;
    const GlobalLines lines;
    const std::uint64_t first_item; ///< index in the sequence of the first item of the run, after the skipped ones

    PowerState state;
    Solution solution;
    /// True once a stage has found a complete solution, so that no power is left to send. A stage may do so even in a
    /// run that was stopped.
    bool solved = false;
    std::vector<Rgb> variance; ///< [(W/m^2)^2] per patch: variance of its radiosity; empty if no stage estimates it

    bool stopped() const { return checkpoint_ && checkpoint_->stopped(); }

    /// Number of local lines in options.lines, for the user's ratio of local to global lines, or for `usual_ratio` if
    /// the user has set none.
    std::uint64_t local_share(double usual_ratio) const;

    /// Number of lines of the budget that are not yet used as local lines.
    std::uint64_t lines_left() const;
    /// Number of the item (point of the sequence) that the next line takes. Each stage takes the items after those of
    /// the stage before it, so no item is used twice. In a quasi-random sequence, the items of all stages together are
    /// then as evenly spread as those of one stage.
    std::uint64_t next_item() const { return first_item + solution.local_lines; }

    /// Plans all remaining lines as global lines, including those that a first shot did not need. Throws SettingsError
    /// if the sequence is too short.
    void plan_global_lines();

    /// Records how many of the planned global lines were cast; fewer than planned if the run was stopped.
    void note_cast(std::uint64_t cast);

    /// Settings of a stage that will cast `lines_to_come` lines, which count as `charged` lines of the budget (N1).
    /// `of_shards`: the shard, for a stage whose work the shards divide.
    RunControl control(std::uint64_t lines_to_come, std::uint64_t charged, Shard of_shards = {});

private:
    void visit(Archive& archive);
    void send_the_rest();
    Solution finish();

    const ProgressCallback progress_;
    Checkpoint* checkpoint_;
    std::uint64_t stages_done_ = 0;
    std::uint64_t local_lines_before_ = 0; ///< number of local lines when the present stage began
    double done_ = 0.0;                    ///< number of lines charged so far
};

} // namespace multipath

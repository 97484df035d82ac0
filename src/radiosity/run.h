#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "radiosity/solve.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace multipath {

/// One run of a method: its inputs and its results so far. The stages of the method (methods.h) advance it.
class Run
{
public:
    /// Throws SettingsError if the sequence has too few items or the method cannot take so many lines,
    /// std::invalid_argument for an unknown sequence.
    Run(const Scene& scene, const SolveOptions& options, const Preparation& preparation,
        const ProgressCallback& progress, Checkpoint* checkpoint, Shard shard);

    /// Carries out all stages, from the first one that the checkpoint does not contain. Throws InputError if the result
    /// is not sound.
    Solution solve();

    const Scene& scene;
    const SolveOptions& options;
    const Preparation& preparation;
    const Shard shard;
    const std::unique_ptr<const Sequence> sequence;
    const GlobalLines lines;
    const std::uint64_t first_item; ///< of the sequence, after those skipped

    PowerState state;
    Solution solution;
    bool solved = false; ///< True once a stage has found a complete solution, also of a run that was stopped: no power
                         ///< is left to send.
    std::vector<Rgb> variance; ///< [(W/m^2)^2] of each patch's radiosity; empty if no stage estimates it

    /// Number of local lines for the user's ratio of local to global lines, or else for `usual_ratio`.
    std::uint64_t local_share(double usual_ratio) const;

    std::uint64_t lines_left() const;
    std::uint64_t first_local_item() const { return first_item + solution.local_lines; }

    /// Plans all remaining lines as global lines, including those that a first shot did not need.
    void plan_global_lines();
    std::uint64_t first_global_item() const;

    /// Adds the rays of these passes to the local lines.
    void add_shots(std::vector<ShotPass> passes);

    /// Records the number of planned global lines that were cast; fewer than planned if the run was stopped.
    void note_cast(std::uint64_t cast);

    /// Controls for a stage of `lines_to_come` lines, which count as `charged` lines of the budget (N1).
    RunControl control(std::uint64_t lines_to_come, std::uint64_t charged, Shard of_shards = {});

private:
    void visit(Archive& archive);
    bool stopped() const { return checkpoint_ && checkpoint_->stopped(); }
    void send_the_rest();
    Solution finish();

    const ProgressCallback& progress_;
    Checkpoint* checkpoint_;
    std::uint64_t stages_done_ = 0;
    std::uint64_t local_lines_before_ = 0; ///< N_l when the present stage began
    double done_ = 0.0;                    ///< lines charged so far
};

} // namespace multipath

#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "radiosity/solve.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace multipath {

/// One run: what it works with and what it has found so far. The stages of its method (methods.h) move it forward.
class Run
{
public:
    /// Throws SettingsError for a sequence with too few items or more lines than the method can take.
    Run(const Scene& scene, const SolveOptions& options, const Preparation& preparation,
        const ProgressCallback& progress, Checkpoint* checkpoint, Shard shard);

    /// All stages, from the first that the checkpoint does not hold. Throws InputError for a result that is not sound.
    Solution solve();

    const Scene& scene;
    const SolveOptions& options;
    const Preparation& preparation;
    const Shard shard;
    const std::unique_ptr<const Sequence> sequence;
    const GlobalLines lines;
    const std::uint64_t first_item; ///< of the sequence that is not skipped

    PowerState state;
    Solution solution;
    bool solved = false;       ///< a stage has sent all light by solving for it, also if the run was stopped
    std::vector<Rgb> variance; ///< [(W/m^2)^2] per patch, of its radiosity; empty where no stage tells it

    /// Number of local lines by the user's ratio of local to global lines, or by the usual one.
    std::uint64_t local_share(double usual_ratio) const;

    std::uint64_t lines_left() const;
    std::uint64_t first_local_item() const { return first_item + solution.local_lines; }

    /// Gives the global lines all lines that are left, those for which a first shot had no use among them.
    void plan_global_lines();
    std::uint64_t first_global_item() const;

    /// Counts the rays of these passes.
    void add_shots(std::vector<ShotPass> passes);

    /// `cast` of the planned global lines were cast; fewer than planned where the run was stopped.
    void note_cast(std::uint64_t cast);

    /// For `lines` lines to come, which are charged as so many of the budget (N1).
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
    double done_ = 0.0;                    ///< lines, charged
};

} // namespace multipath

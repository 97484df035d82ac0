#pragma once

#include "commands/run_description.h"
#include "export/state_file.h"
#include "parallel/checkpoint.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// A state file that has been read: the run that it is of, and where that was left.
struct SavedRun
{
    std::unique_ptr<StateReader> arrays;
    RunDescription description;
    std::vector<std::string> parts; ///< under way, the outermost first

    const std::string& name() const { return arrays->name(); }
};

/// Throws ArchiveError.
SavedRun read_saved_run(const std::string& path);
SavedRun read_saved_run(std::unique_ptr<StateReader> arrays);

/// Where the state of a run goes.
struct StatePlan
{
    std::string path;         ///< empty: nowhere
    double save_every = 60.0; ///< [s]
    bool keep_last = false;   ///< in memory, for an output
};

/// Saves the state of a run now and then, at its end, and where the user interrupts it, which ends the work.
class StateKeeper : public Checkpoint
{
public:
    StateKeeper(StatePlan plan, RunDescription description);

    /// The run goes on from there.
    void resume(SavedRun saved);

    bool wants_pause() const override;

    const std::string& path() const { return plan_.path; }
    /// Of the last time it was saved, if that is kept.
    const std::string& last_bytes() const { return last_bytes_; }
    bool handed_in() const { return handed_in_; }
    bool worked() const { return worked_; } ///< or was everything done already?

protected:
    bool pause_now() override;
    void hand_in_now() override;
    void finish_now() override;

private:
    using Clock = std::chrono::steady_clock;

    void write(const StateWriter::Sink& sink);
    void keep_in_memory();
    void keep();

    StatePlan plan_;
    RunDescription description_;
    std::optional<SavedRun> resumed_;
    Clock::time_point next_save_;
    std::string last_bytes_;
    bool handed_in_ = false;
    mutable std::atomic<bool> worked_{false};
};

} // namespace multipath

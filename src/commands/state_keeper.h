#pragma once

#include "commands/saved_run.h"
#include "parallel/checkpoint.h"

#include <atomic>
#include <chrono>
#include <optional>
#include <string>

namespace multipath {

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
    bool resumed() const { return resumed_.has_value(); }
    bool handed_in() const { return handed_in_; }

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
    mutable std::atomic<bool> worked_{false}; ///< or was everything done already?
};

} // namespace multipath

#pragma once

#include "cli/options/command_line.h"
#include "export/state_file.h"
#include "parallel/checkpoint.h"
#include "parallel/run_control.h"
#include "radiosity/solution.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// The state options of a command line.
struct StateOptions
{
    std::string path;         ///< file in which the state is kept; empty: it is not kept
    std::string from;         ///< state to resume from; empty: the run begins anew
    double save_every = 60.0; ///< [s]
    Shard shard;
};

/// --state, --resume, --shard, ...
OptionGroup state_option_group();

/// Reads these options. Throws UsageError; InputError if the --state file exists and --resume is not given: the state
/// would be lost.
StateOptions read_state_options(const CommandLine& line);

/// Scene, options and shard of a run, as stored at the head of its state file.
struct RunDescription
{
    std::vector<std::string> arguments; ///< words of the `solve` command: options that change the result, and the scene
    ArchivedScene scene;
    Shard shard;

    void visit(Archive& archive);
};

/// The description of the run that a command line of `solve` asks for.
RunDescription description_of(const CommandLine& line, const Scene& scene, Shard shard);

/// The command line of `solve` that a state was made with, with more words of the user, such as outputs.
CommandLine command_line_of(const RunDescription& description, const std::vector<std::string>& more_words);

/// The options given on a command line, as words for another command that has the same options.
std::vector<std::string> forwarded_options(const CommandTable& table, const CommandLine& line);

/// Throws InputError "run.state: the state of another run: made with --sequence sobol, not with --sequence halton; ..."
/// if the state belongs to another run than the wanted one. The wanted run may have other lines, tolerance and time,
/// unless the state is of a shard.
void require_same_run(const RunDescription& saved, const std::string& path, const RunDescription& wanted);

/// A state file that has been read: the description of its run, and the state in which the run was saved.
struct SavedRun
{
    std::unique_ptr<StateReader> arrays;
    RunDescription description;
    std::vector<std::string> parts; ///< parts of the run that were in progress, the outermost first

    const std::string& name() const { return arrays->name(); }
};

/// Reads a state file. Throws ArchiveError.
SavedRun read_saved_run(const std::string& path);
SavedRun read_saved_run(std::unique_ptr<StateReader> arrays);

/// True if the run has cast all lines that it was asked for.
bool is_finished(const SavedRun& saved);

/// The solution from the finished pieces of the run. Throws InputError if there are none.
Solution finished_solution(const SavedRun& saved, const Scene& scene);

/// Saves the state of a run at intervals, at its end, and when the user interrupts it, which stops the run.
class StateKeeper : public Checkpoint
{
public:
    /// `keep_last`: also keeps the last saved state in memory, for an output.
    StateKeeper(StateOptions options, bool keep_last, RunDescription description);

    /// Lets the run resume from this state.
    void resume(SavedRun saved);

    bool wants_pause() const override;

    const std::string& path() const { return options_.path; }
    /// The last saved state, if it is kept in memory.
    const std::string& last_bytes() const { return last_bytes_; }
    bool resumed() const { return resumed_.has_value(); }
    /// True if the shard is finished and its state saved for `merge`.
    bool published() const { return published_; }

protected:
    bool pause_now() override;
    void publish_shard_now() override;
    void finish_now() override;

private:
    using Clock = std::chrono::steady_clock;

    void write(const StateWriter::Sink& sink);
    void keep_in_memory();
    void keep();

    StateOptions options_;
    bool keep_last_;
    RunDescription description_;
    std::optional<SavedRun> resumed_;
    Clock::time_point next_save_;
    std::string last_bytes_;
    bool published_ = false;
    mutable std::atomic<bool> worked_{false}; ///< false: the resumed state was complete already
};

} // namespace multipath

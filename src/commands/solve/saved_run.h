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

/// Whether and where the state of a run is kept, what it goes on from, and which share of the work it does.
struct StateOptions
{
    std::string path;         ///< file; empty: not kept
    std::string from;         ///< state to go on from; empty: it begins anew
    double save_every = 60.0; ///< [s]
    Shard shard;
};

/// --state, --resume, --shard and the like.
OptionGroup state_option_group();

/// Throws UsageError; InputError for a state that exists where none is to be resumed: it would be lost.
StateOptions read_state_options(const CommandLine& line);

/// Scene, options and share of a run, as its state file has them.
struct RunDescription
{
    std::vector<std::string> arguments; ///< of `solve`, as words: those that its result depends on, and the scene
    ArchivedScene scene;
    Shard shard;

    void visit(Archive& archive);
};

/// Of the run that the user asks for; its options are those of `solve`.
RunDescription description_of(const CommandLine& line, const Scene& scene, Shard shard);

/// The command line of the run that a state is of, with more words of the user, such as where to write pictures.
CommandLine command_line_of(const RunDescription& description, const std::vector<std::string>& more_words);

/// The options that were given on a command line, as words for that of another command that has them, too.
std::vector<std::string> forwarded_options(const CommandTable& table, const CommandLine& line);

/// Throws InputError "run.state: made with --sequence sobol, not halton; ..." where the user asks for another run than
/// the state is of. Of a longer run of the same kind it may be the beginning, unless it is a share.
void require_same_run(const RunDescription& saved, const std::string& path, const RunDescription& wanted);

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

/// True if the run has reached the number of lines that it was asked for.
bool is_finished(const SavedRun& saved);

/// Of the pieces of the run that are finished. Throws InputError without any.
Solution finished_solution(const SavedRun& saved, const Scene& scene);

/// Saves the state of a run now and then, at its end, and where the user interrupts it, which ends the work.
class StateKeeper : public Checkpoint
{
public:
    /// `keep_last`: what was saved last stays in the memory, for an output.
    StateKeeper(StateOptions options, bool keep_last, RunDescription description);

    /// The run goes on from there.
    void resume(SavedRun saved);

    bool wants_pause() const override;

    const std::string& path() const { return options_.path; }
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

    StateOptions options_;
    bool keep_last_;
    RunDescription description_;
    std::optional<SavedRun> resumed_;
    Clock::time_point next_save_;
    std::string last_bytes_;
    bool handed_in_ = false;
    mutable std::atomic<bool> worked_{false}; ///< or was everything done already?
};

} // namespace multipath

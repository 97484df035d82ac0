#pragma once

#include "cli/options/command_line.h"
#include "export/patch_table.h"
#include "export/state_file.h"
#include "parallel/run_control.h"
#include "radiosity/run/solution.h"
#include "scene/scene.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// The state options of a command line. A state is a file from which a run can resume.
struct StateOptions
{
    std::string path;         ///< file in which the state is kept; empty: no state is kept
    std::string from;         ///< state file to resume from; empty: the run begins anew
    double save_every = 60.0; ///< [s] interval between saves
    Shard shard;              ///< part of the work to do; by default all of it
};

/// The options --state, --resume, --shard, ...
OptionGroup state_option_group();

/// Reads these options. Throws UsageError. Throws InputError if the --state file exists and --resume is not given,
/// since the state would be lost.
StateOptions read_state_options(const CommandLine& line);

/// Scene, options and shard of a run, as stored at the head of its state file.
struct RunDescription
{
    /// "name=value" of each given option of `solve` that changes the result, "name" of a flag, and last "scene=FILE".
    std::vector<std::string> settings;
    ArchivedScene scene;
    Shard shard;

    /// Writes or reads all members. Throws ArchiveError for values that no run has.
    void visit(Archive& archive);
};

/// The description of the run that a command line of `solve` asks for.
RunDescription description_of(const CommandLine& line, const Scene& scene, Shard shard);

/// The command line of `solve` that the description records. `more_words`: further options, such as outputs, that are
/// put in front.
CommandLine command_line_of(const RunDescription& description, const std::vector<std::string>& more_words);

/// Throws InputError if the saved state belongs to another run than the wanted one: "run.state: the state of another
/// run: made with --sequence sobol, not with --sequence halton; ...". The wanted run may have other values of --lines,
/// --tolerance and --time, unless the state is of a shard. `path`: name of the state in the message.
void require_same_run(const RunDescription& saved, const std::string& path, const RunDescription& wanted);

/// A state file that has been read: the description of its run, and the state in which the run was saved.
struct SavedRun
{
    std::unique_ptr<StateReader> arrays;
    RunDescription description;
    /// Names of the parts of the run that were in progress (run_control.h), outermost first.
    std::vector<std::string> parts;

    const std::string& name() const { return arrays->name(); }
};

/// Reads a state file. Throws ArchiveError for a file that cannot be read, is no state file, was written by a newer
/// version, or is damaged.
SavedRun read_saved_run(const std::string& path);
SavedRun read_saved_run(std::unique_ptr<StateReader> arrays);

/// The solution of a saved run so far: the average of its finished pieces (runs over successive lines), or the last
/// finished round of a run in rounds (see RunRecord). Throws InputError if no piece or round is finished.
Solution finished_solution(const SavedRun& saved, const Scene& scene);

/// Saves the state of a run in its file: at intervals, at the end of the run, and when the user interrupts it, which
/// stops the run. A large state is saved less often, so that saving takes at most about a tenth of the time.
class StateKeeper : public Checkpoint
{
public:
    /// `keep_last`: also keep the last saved state in memory, for an output.
    StateKeeper(StateOptions options, bool keep_last, RunDescription description);

    /// Lets the run resume from this state.
    void resume(SavedRun saved);

    bool wants_pause() const override;
    void finish() override { keep(); }

    const std::string& path() const { return options_.path; }
    /// The last saved state; empty unless it is kept in memory.
    const std::string& last_bytes() const { return last_bytes_; }
    /// True if resume() was called.
    bool resumed() const { return resumed_.has_value(); }
    /// True if the shard is finished and its state was saved for `merge`.
    bool published() const { return published_; }

protected:
    bool pause_now() override;
    void publish_shard_now() override;

private:
    using Clock = std::chrono::steady_clock;

    /// Saves the state in its file, unless the path is empty, and in memory if the last state is kept there.
    void keep();

    StateOptions options_;
    bool keep_last_;
    RunDescription description_;
    std::optional<SavedRun> resumed_;
    Clock::duration interval_; ///< between saves
    Clock::time_point next_save_;
    std::string last_bytes_;
    bool published_ = false;
};

/// A result read from a table of patches (.csv) or from the state of a run. The content of the file decides which, not
/// its extension.
struct ResultFile
{
    PatchTable table;
    std::unique_ptr<const Scene> scene; ///< for a state; otherwise null

    /// `beside`: see read_patch_table(). Throws InputError or ArchiveError for a faulty file, and InputError for a run
    /// of which no piece or round is finished (see finished_solution).
    explicit ResultFile(const std::string& path, const PatchTable* beside = nullptr);

    /// True for a state of the same surfaces, with the same sides, but with other patches than `other`.
    bool has_other_patches(const Scene& other) const
    {
        return scene && table.areas != other.weights() && scene->two_sided() == other.two_sided() &&
               scene->surfaces() == other.surfaces();
    }
};

/// Throws InputError if the patches of the table differ from those of these areas [m^2] in number or area. `owner`:
/// what has the areas, for the message.
void require_same_patches(const PatchTable& table, const std::vector<double>& areas, const std::string& owner);

} // namespace multipath

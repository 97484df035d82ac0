#pragma once

#include "cli/files/output_file.h"
#include "cli/options/command_line.h"
#include "commands/options/picture_options.h"
#include "commands/solve/accuracy.h"
#include "commands/solve/saved_run.h"
#include "radiosity/run/solve_options.h"

#include <chrono>
#include <string>
#include <vector>

namespace multipath {

/// A command line of `solve` and the options read from it.
struct SolveJob
{
    using Clock = std::chrono::steady_clock;

    CommandLine line;
    SolveOptions options;
    Accuracy accuracy;
    PictureOptions pictures;
    std::string sequence; ///< full name of the sequence
    bool quiet = false;   ///< true: print only errors
    Clock::time_point start = Clock::now();

    double seconds_since_start() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
};

/// Reads the options. Throws UsageError, and InputError for a faulty file of --camera.
SolveJob read_solve_job(const CommandLine& line);

/// Checks before the work that the outputs can be made. Throws SettingsError for an invalid camera, InputError for a
/// page that does not fit into the memory.
void require_results_possible(const SolveJob& job, const Scene& scene, const std::vector<PlannedOutput>& outputs);

/// A job on the saved state of a run: the scene of the state, and the outputs that were asked for, open.
struct SavedJob
{
    SolveJob job;
    Scene scene;
    std::vector<PlannedOutput> outputs;
};

/// The job of a command that makes outputs from states, with the options of the saved run and those of the command.
/// `name`: the outputs that are written by default are named after this file. Throws as the functions above do.
SavedJob open_saved_job(const CommandLine& line, const RunDescription& saved, const std::string& name);

/// Solves, or resumes the run of the keeper; writes the outputs and prints the summary. Returns the exit code. A run
/// that the user interrupts writes its partial results. Throws InputError if no light reaches any surface in a complete
/// run, and for a shard of `reuse` if no work is left for it.
int carry_out(const SolveJob& job, const Scene& scene, std::vector<PlannedOutput>& outputs, StateKeeper& keeper,
              Shard shard);

} // namespace multipath

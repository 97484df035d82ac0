#pragma once

#include "cli/files/output_file.h"
#include "cli/options/command_line.h"
#include "commands/options/picture_options.h"
#include "commands/solve/accuracy.h"
#include "commands/solve/saved_run.h"
#include "export/json.h"
#include "radiosity/run/solve_options.h"

#include <chrono>
#include <optional>
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
};

/// Reads the options. Throws UsageError. Throws InputError for a faulty file of --camera, or if the memory cannot hold
/// the pictures.
SolveJob read_solve_job(const CommandLine& line);

/// Checks before the work that the outputs can be made. Throws SettingsError for an invalid camera, InputError for a
/// page that does not fit into the memory.
void require_results_possible(const SolveJob& job, const Scene& scene, const std::vector<PlannedOutput>& outputs);

/// Solves, or resumes the run of the keeper; writes the outputs and prints the summary. Returns the exit code. A run
/// that the user interrupts writes its partial results. Throws InputError if no light reaches any surface in a complete
/// run, and for a shard of `reuse` if no work is left for it.
int carry_out(const SolveJob& job, const Scene& scene, std::vector<PlannedOutput>& outputs, StateKeeper& keeper,
              Shard shard);

/// Writes the outputs of a solution. `state`: the bytes of the state files among the outputs; may be empty if there are
/// no such files.
void write_results(const SolveJob& job, const Scene& scene, const Solution& solution,
                   std::vector<PlannedOutput>& outputs, const std::string& state);

/// Figures of a finished `solve`.
struct SolveSummary
{
    const Scene& scene;
    const SolveOptions& options;
    const Solution& solution;
    std::string sequence; ///< full name
    Accuracy accuracy{};
    double seconds = 0.0;                ///< [s] from start to end, outputs included
    double seconds_trace = 0.0;          ///< [s] time of the solver alone
    double seconds_outputs = 0.0;        ///< [s] time of making and writing the outputs
    double seconds_to_first_lines = 0.0; ///< [s] from start to the end of the first block of lines
    bool complete = true;                ///< false: the run was interrupted
    bool all_at_once = true;             ///< false: an earlier run cast some of the lines

    /// [1] Root of the relative mean square error (MSE), which is the MSE caused by the patches plus the MSE by noise.
    /// Empty unless both are known.
    std::optional<double> error() const;

    /// [1] Root of the MSE by noise of the important patches, relative to their mean radiosity; both are weighted by
    /// options.importance and area. Empty without importance or standard errors.
    std::optional<double> error_of_important() const;
};

/// The summary as text of several lines, with warnings of results that are wrong or noisy.
std::string summary_text(const SolveSummary& summary);

/// A table of the power balance [W] after every stage: a row for each pass of the (extended) first shot, then one for
/// the whole run.
std::string stages_text(const Solution& solution);

/// The summary as the JSON object of `solve --json`.
JsonObject summary_json(const SolveSummary& summary);

} // namespace multipath

#pragma once

#include "cli/files/output_file.h"
#include "cli/options/command_line.h"
#include "commands/options/picture_options.h"
#include "commands/solve/accuracy.h"
#include "commands/solve/saved_run.h"
#include "export/json.h"
#include "radiosity/solve_options.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// The request to `solve`, read from its command line.
struct SolveJob
{
    using Clock = std::chrono::steady_clock;

    CommandLine line;
    SolveOptions options;
    Accuracy accuracy;
    PictureOptions pictures;
    std::string sequence; ///< full name
    bool quiet = false;
    Clock::time_point start = Clock::now();
};

/// Throws UsageError.
SolveJob read_solve_job(const CommandLine& line);

/// Refuses, before the work, a view in which nothing can be seen and a page that does not fit into the memory. Throws
/// SettingsError and InputError.
void require_results_possible(const SolveJob& job, const Scene& scene, const std::vector<PlannedOutput>& outputs);

/// Solves, or goes on with what the keeper resumes, fills the outputs and tells the user. Returns the exit code.
int carry_out(const SolveJob& job, const Scene& scene, std::vector<PlannedOutput>& outputs, StateKeeper& keeper,
              Shard shard);

/// Fills the outputs from a solution; `state` are the bytes of those that are one.
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
    double seconds = 0.0;                ///< from start to end, pictures included
    double seconds_trace = 0.0;          ///< of the solver alone
    double seconds_outputs = 0.0;        ///< of making and writing the outputs
    double seconds_to_first_lines = 0.0; ///< from start to when the first block of lines was done
    bool complete = true;                ///< or was it interrupted?
    bool all_at_once = true;             ///< or were some of the lines traced by an earlier run?

    /// [1] Root of the relative total MSE, of patches and noise; nothing where these are not known.
    std::optional<double> error() const;

    /// [1] Root of the relative MSE by noise of the patches that options.importance weights, relative to their mean.
    std::optional<double> error_of_important() const;
};

/// Some lines for a person.
std::string summary_text(const SolveSummary& summary);

/// Where the power is after every stage: each pass of the (extended) first shot, then the whole run.
std::string stages_text(const Solution& solution);

/// The same for a program: the keys of `solve --json`.
JsonObject summary_json(const SolveSummary& summary);

} // namespace multipath

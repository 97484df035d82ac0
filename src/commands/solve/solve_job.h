#pragma once

#include "cli/files/output_file.h"
#include "cli/options/command_line.h"
#include "commands/options/picture_options.h"
#include "commands/solve/accuracy.h"
#include "commands/solve/saved_run.h"
#include "radiosity/solve_options.h"

#include <chrono>
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
              Share share);

/// Fills the outputs from a solution; `state` are the bytes of those that are one.
void write_results(const SolveJob& job, const Scene& scene, const Solution& solution,
                   std::vector<PlannedOutput>& outputs, const std::string& state);

} // namespace multipath

#pragma once

#include "commands/solve/solve_job.h"
#include "export/json.h"
#include "radiosity/run/solution.h"
#include "scene/scene.h"

#include <optional>
#include <string>

namespace multipath {

/// Figures of a finished `solve`.
struct SolveSummary
{
    const SolveJob& job;
    const Scene& scene;
    const Solution& solution;
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
    /// the importance and area. Empty without importance or standard errors.
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

#pragma once

#include "export/json.h"
#include "radiosity/solve.h"
#include "scene/scene.h"

#include <string>

namespace multipath {

/// Figures of a finished `solve`.
struct SolveSummary
{
    const Scene& scene;
    const SolveOptions& options;
    const Solution& solution;
    std::string method;                  ///< as the user names it
    std::string sequence;                ///< full name
    double seconds = 0.0;                ///< from start to end, pictures included
    double seconds_trace = 0.0;          ///< of the solver alone
    double seconds_outputs = 0.0;        ///< of making and writing the outputs
    double seconds_to_first_lines = 0.0; ///< from start to when the first block of lines was done
    bool complete = true;                ///< or was it interrupted?
    bool all_at_once = true;             ///< or were some of the lines traced by an earlier run?
};

/// Some lines for a person.
std::string summary_text(const SolveSummary& summary);

/// Where the power is after every stage: each pass of the (extended) first shot, then the whole run.
std::string stages_text(const Solution& solution);

/// The same for a program: the keys of `solve --json`.
JsonObject summary_json(const SolveSummary& summary);

} // namespace multipath

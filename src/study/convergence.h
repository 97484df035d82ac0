#pragma once

#include "radiosity/error_measure.h"
#include "radiosity/solve.h"
#include "study/curve.h"
#include "study/journal.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace multipath {

/// The solution against which the error of a study is measured.
struct Reference
{
    std::vector<Rgb> radiosity; ///< [W/m^2] per patch
    /// [1] Relative MSE of the reference itself, estimated from its standard errors; nothing if unknown.
    std::optional<double> relative_square;
    /// Measures the error of a solution, given its radiosity [W/m^2] per patch. If empty, the error is the MSE against
    /// `radiosity`, (1) in docs/equations.md. Called by several threads at the same time.
    std::function<ErrorMeasure(const std::vector<Rgb>& radiosity)> measure{};
};

/// A curve to be measured. The options hold for all its runs, except that each run has its own lines, seed and range of
/// items (points of the sequence, one for each line).
struct CurvePlan
{
    CurveKind kind;
    SolveOptions options;
};

struct StudyPlan
{
    std::vector<CurvePlan> curves;
    std::vector<std::uint64_t> line_counts; ///< lines of the points of every curve, increasing
    int executions = 1;                     ///< number of runs for each point
    std::uint64_t seed = 1;
};

/// Runs all executions of a study, measures the error of each against the reference, and averages the executions of a
/// curve that have the same number of lines. The executions of a curve are independent. If the seed randomises the
/// sequence, each of them has a seed of its own. If not, as with Sobol's sequence, executions with the same number of
/// lines take successive ranges of items, the first of which starts where the options say. Executions in the journal
/// are not repeated. `threads` runs go on at the same time; the options of each should ask for one thread, so that the
/// measured seconds are comparable. A point is part of the fit if its error is more than ten times that of the
/// reference, or if the error of the reference is unknown. `progress` is called often during each run and at its end,
/// by one thread at a time. Throws what prepare(), solve(), the journal and `progress` throw.
Study run_study(const Scene& scene, const Reference& reference, const StudyPlan& plan, Journal& journal, int threads,
                const ProgressCallback& progress);

} // namespace multipath

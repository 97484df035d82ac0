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
    std::vector<Rgb> radiosity;            ///< [W/m^2] per patch
    std::optional<double> relative_square; ///< [1] its own relative MSE (1), as its standard errors let expect
    /// How far a radiosity per patch is from it, if not by (1). Called by several threads.
    std::function<ErrorMeasure(const std::vector<Rgb>& radiosity)> measure{};
};

/// One curve to be measured; lines, seed, skip and threads of its options are set run by run.
struct CurvePlan
{
    CurveKind kind;
    SolveOptions options;
};

struct StudyPlan
{
    std::vector<CurvePlan> curves;
    std::vector<std::uint64_t> line_counts; ///< increasing
    int executions = 1;                     ///< of each number of lines
    std::uint64_t seed = 1;
};

/// The executions of a study: how far each is from the reference, and their mean per number of lines. Executions of a
/// sequence that the seed randomises differ by it, also from one number of lines to the next; those of one that it does
/// not, such as Sobol's, take successive stretches of it, the first of them its beginning. Runs that the journal knows
/// are not repeated. Every run has one thread to itself, and `threads` run at a time, so that the seconds measured are
/// comparable. A point belongs to the fit if its error is ten times that of the reference. Throws what solve
/// throws, and what `progress` throws, which is called before each run and often during it, by one thread at a time.
Study run_study(const Scene& scene, const Reference& reference, const StudyPlan& plan, Journal& journal, int threads,
                const ProgressCallback& progress);

} // namespace multipath

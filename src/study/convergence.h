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
    std::optional<double> relative_square; ///< [1] its own relative MSE (1), estimated from its standard errors
    /// Error of a radiosity per patch, if it is not measured by (1). Called by several threads.
    std::function<ErrorMeasure(const std::vector<Rgb>& radiosity)> measure{};
};

/// A curve to be measured. Lines, seed and skip of its options are set for each run.
struct CurvePlan
{
    CurveKind kind;
    SolveOptions options;
};

struct StudyPlan
{
    std::vector<CurvePlan> curves;
    std::vector<std::uint64_t> line_counts; ///< increasing
    int executions = 1;                     ///< for each number of lines
    std::uint64_t seed = 1;
};

/// Runs all executions of a study, measures the error of each against the reference, and averages them for each number
/// of lines. Executions are independent: of a sequence that the seed randomises, each has another seed, also for
/// different numbers of lines; of other sequences, such as Sobol's, successive executions take successive ranges of
/// items, starting with the first. Runs in the journal are not repeated. Each run has one thread and `threads` runs go
/// on at a time, so that the measured seconds are comparable. A point is part of the fit if its error is more than ten
/// times that of the reference. Throws what solve() throws, and what `progress` throws, which is called often during
/// each run and at its end, by one thread at a time.
Study run_study(const Scene& scene, const Reference& reference, const StudyPlan& plan, Journal& journal, int threads,
                const ProgressCallback& progress);

} // namespace multipath

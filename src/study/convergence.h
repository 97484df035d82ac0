#pragma once

#include "radiosity/run/solve.h"
#include "study/curve.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// Name of an execution (run) of a study: that of its curve, its lines, and its number among those with the same curve
/// and lines. The name of the curve, with its setting, has no tabs and line ends.
std::string execution_name(const std::string& curve, std::uint64_t lines, int number);

/// Log of the finished executions of a study in a file, from which an interrupted study resumes. Each execution, a
/// point with the numbers of one run, is one line with a checksum; lines that a crash left incomplete are ignored.
/// Thread-safe.
class Journal
{
public:
    /// A journal without a file, for a study that cannot be resumed.
    Journal() = default;

    /// Reads the file, if it exists, and appends to it from then on. `identity`, one line, describes the study whose
    /// executions the file holds. A file with another identity is overwritten. Throws std::runtime_error with the
    /// reason if the file cannot be written.
    Journal(const std::string& path, const std::string& identity);

    /// Returns the result of an execution; nothing if it is not in the journal.
    std::optional<CurvePoint> find(const std::string& name) const;

    /// Records an execution and writes it into the file at once. Throws std::runtime_error if the file cannot be
    /// written.
    void add(const std::string& name, const CurvePoint& execution);

private:
    void append(const std::string& line);

    mutable std::mutex mutex_;
    std::map<std::string, CurvePoint> executions_; ///< by execution_name(); their `lines` are not set
    std::string path_;                             ///< empty: no file
    std::ofstream file_;
};

/// The solution against which the error of a study is measured.
struct Reference
{
    std::vector<Rgb> radiosity; ///< [W/m^2] per patch
    /// [1] Relative MSE of the reference itself, estimated from its standard errors; nothing if unknown.
    std::optional<double> relative_square;
};

/// A curve to be measured, or a part of one with the same setting. The options hold for all its runs, except that each
/// run has its own lines, seed and range of items (points of the sequence, one for each line).
struct CurvePlan
{
    CurveKind kind;
    SolveOptions options;
    double setting = 0.0;  ///< CurvePoint::setting of its points, for their names; 0: the rule chooses it
    std::string rule = {}; ///< CurvePoint::rule of its points
};

struct StudyPlan
{
    std::vector<CurvePlan> curves;          ///< those of the same kind beside each other
    Abscissa varied = Abscissa::lines;      ///< lines, ratio or threshold: what the settings are
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

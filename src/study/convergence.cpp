#include "study/convergence.h"

#include "base/checksum.h"
#include "base/lists.h"
#include "base/platform/machine.h"
#include "base/text_format.h"
#include "parallel/blocks.h"
#include "radiosity/run/replicates.h"
#include "radiosity/run/statistics.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <cstring>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace multipath {

namespace {

std::string checksum_text(const std::string& text)
{
    return format("\t%08" PRIx32, crc32(text));
}

std::string record_of(const std::string& name, const CurvePoint& e)
{
    const std::string record = name + format("\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g", e.local_lines, e.global_lines,
                                             e.mean_square, e.relative, e.seconds);
    return record + checksum_text(record);
}

/// Parses a record. Nothing if its checksum is wrong or it is malformed.
std::optional<std::pair<std::string, CurvePoint>> parsed(const std::string& line)
{
    const std::size_t end = line.rfind('\t');
    if (end == std::string::npos || checksum_text(line.substr(0, end)) != line.substr(end))
        return {};
    std::istringstream fields(line.substr(0, end));
    fields.imbue(std::locale::classic());
    std::pair<std::string, CurvePoint> record;
    std::getline(fields, record.first, '\t');
    CurvePoint& e = record.second;
    if (!(fields >> e.local_lines >> e.global_lines >> e.mean_square >> e.relative >> e.seconds))
        return {};
    return record;
}

} // namespace

std::string execution_name(const std::string& curve, std::uint64_t lines, int number)
{
    return curve + " " + std::to_string(lines) + " " + std::to_string(number);
}

Journal::Journal(const std::string& path, const std::string& identity) : path_(path)
{
    std::ifstream lines(path, std::ios::binary);
    std::string line;
    if (std::getline(lines, line) && line == identity)
        while (std::getline(lines, line))
            if (const auto record = parsed(line))
                executions_.insert(*record);
    const bool fresh = executions_.empty();
    file_.open(path, std::ios::binary | (fresh ? std::ios::trunc : std::ios::app));
    append(fresh ? identity : ""); // a line feed ends a record that a crash may have cut off
}

void Journal::append(const std::string& line)
{
    if (!(file_ << line << '\n' << std::flush))
        throw std::runtime_error("cannot write " + path_ + ": " + std::strerror(errno));
}

std::optional<CurvePoint> Journal::find(const std::string& name) const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = executions_.find(name);
    return found == executions_.end() ? std::nullopt : std::optional(found->second);
}

void Journal::add(const std::string& name, const CurvePoint& execution)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    executions_[name] = execution;
    if (!path_.empty())
        append(record_of(name, execution));
}

// All executions of all curves are independent tasks. Each execution solves the scene on one thread, with its own seed
// or its own range of items (points of the sequence). Its error against the reference is recorded in the journal, so
// that an interrupted study loses at most the runs in progress. At the end the executions with the same number of lines
// are averaged, and a power law is fitted to each curve.

namespace {

constexpr double clearly_above = 10.0; ///< times the error of the reference, which then moves a point by 10 % at most

std::string curve_name(const StudyPlan& plan, const CurvePlan& curve)
{
    const CurveKind& kind = curve.kind;
    std::string name =
        kind.method + " " + kind.sequence + " " + kind.pairing + " " + kind.chords + " " + kind.line_order;
    if (plan.varied != Abscissa::lines)
        name += (plan.varied == Abscissa::ratio ? " ratio " : " threshold ") +
                (curve.rule.empty() ? format("%.17g", curve.setting) : curve.rule);
    return name;
}

/// Number of items between the first items of two executions: at least as many as a run takes, and a power of two, so
/// that every execution with Sobol's sequence begins with a new net.
std::uint64_t item_stride(const Scene& scene, const SolveOptions& options)
{
    const std::uint64_t most = GlobalLines(scene.bounds(), chords_of(options)).lines_to_cast(options.lines);
    std::uint64_t items = 1;
    while (items < most)
        items *= 2;
    return items;
}

struct PlannedRun
{
    std::size_t curve;
    std::uint64_t lines;
    int number;
    std::string name; ///< in the journal
};

/// Executions that are not in the journal, the longest first, so that all threads finish at about the same time.
std::vector<PlannedRun> runs_to_do(const StudyPlan& plan, const Journal& journal)
{
    std::vector<PlannedRun> runs;
    for (auto lines = plan.line_counts.rbegin(); lines != plan.line_counts.rend(); ++lines)
        for (std::size_t c = 0; c < plan.curves.size(); ++c)
            for (int number = 0; number < plan.executions; ++number) {
                const std::string name = execution_name(curve_name(plan, plan.curves[c]), *lines, number);
                if (!journal.find(name))
                    runs.push_back({c, *lines, number, name});
            }
    return runs;
}

/// Every run prepares itself with the options of its curve: its seconds are those of a single run.
CurvePoint execute(const Scene& scene, const StudyPlan& plan, const PlannedRun& run, const Reference& reference,
                   const ProgressCallback& progress)
{
    SolveOptions options = plan.curves[run.curve].options;
    options.lines = run.lines;
    options = independent_run(options, RandomStream::runs, plan.seed ^ run.lines,
                              static_cast<std::uint64_t>(run.number), item_stride(scene, options));
    const double start = thread_seconds();
    const Solution solution = solve(scene, prepare(scene, options), options, progress);
    CurvePoint point{run.lines};
    point.seconds = thread_seconds() - start;
    const ErrorMeasure error = measure_error(scene.weights(), solution.radiosity, reference.radiosity); // (1)
    point.local_lines = static_cast<double>(solution.local_lines);
    point.global_lines = static_cast<double>(solution.global_lines);
    point.mean_square = error.mean_square;
    point.relative = error.relative_mean_square;
    return point;
}

CurvePoint mean_point(const StudyPlan& plan, const CurvePlan& curve, std::uint64_t lines, const Journal& journal)
{
    CurvePoint point{lines};
    const std::string name = curve_name(plan, curve);
    const auto set_ratio = [&](CurvePoint& p) {
        p.setting = curve.rule.empty() ? curve.setting : p.local_lines / p.global_lines;
        p.rule = curve.rule;
    };
    for (int number = 0; number < plan.executions; ++number) {
        point.executions.push_back(*journal.find(execution_name(name, lines, number)));
        set_ratio(point.executions.back());
    }
    for (double CurvePoint::*value : {&CurvePoint::local_lines, &CurvePoint::global_lines, &CurvePoint::mean_square,
                                      &CurvePoint::relative, &CurvePoint::seconds}) {
        RunningMean mean;
        for (const CurvePoint& execution : point.executions)
            mean.add(execution.*value);
        point.*value = mean.mean();
        if (value == &CurvePoint::relative && plan.executions > 1)
            point.relative_error = mean.standard_error();
    }
    set_ratio(point);
    return point;
}

/// The curves of the plan with their points.
std::vector<Curve> mean_curves(const StudyPlan& plan, const Reference& reference, const Journal& journal)
{
    std::vector<Curve> curves;
    for (const CurvePlan& part : plan.curves) {
        if (curves.empty() || !(curves.back().kind == part.kind))
            curves.push_back({part.kind, {}, {}});
        for (const std::uint64_t count : plan.line_counts) {
            CurvePoint point = mean_point(plan, part, count, journal);
            point.above_reference = point.relative > clearly_above * reference.relative_square.value_or(0.0);
            curves.back().points.push_back(point);
        }
    }
    for (Curve& curve : curves) {
        std::stable_sort(curve.points.begin(), curve.points.end(),
                         [](const CurvePoint& a, const CurvePoint& b) { return a.setting < b.setting; });
        if (plan.varied == Abscissa::lines)
            curve.law = fit(curve.points); // (2)
        if (plan.varied == Abscissa::ratio)
            curve.ratios = ratio_findings(curve.points);
    }
    return curves;
}

} // namespace

Study run_study(const Scene& scene, const Reference& reference, const StudyPlan& plan, Journal& journal, int threads,
                const ProgressCallback& progress)
{
    const std::vector<PlannedRun> runs = runs_to_do(plan, journal);
    const auto all_lines = static_cast<double>(sum_over(runs, &PlannedRun::lines));
    double done_lines = 0.0;
    std::mutex mutex;
    parallel_blocks(runs.size(), threads, [&](std::uint64_t n) {
        const PlannedRun& run = runs[n];
        const auto lines = static_cast<double>(run.lines);
        double reported = 0.0; // share of this run
        const auto report = [&](double done) {
            const std::lock_guard<std::mutex> lock(mutex);
            done_lines += (done - reported) * lines;
            reported = done;
            progress(std::min(1.0, done_lines / all_lines));
        };
        journal.add(run.name, execute(scene, plan, run, reference, report));
        report(1.0);
    });

    return {mean_curves(plan, reference, journal), plan.executions, plan.varied, reference.relative_square};
}

} // namespace multipath

#include "study/convergence.h"

#include "base/platform/machine.h"
#include "base/text_format.h"
#include "image/checksum.h"
#include "parallel/blocks.h"
#include "radiosity/run/replicates.h"
#include "radiosity/run/statistics.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <cerrno>
#include <cinttypes>
#include <cstring>
#include <locale>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>

namespace multipath {

namespace {

std::string key_text(const ExecutionKey& key)
{
    return key.curve + "\t" + std::to_string(key.lines) + "\t" + std::to_string(key.number);
}

std::string checksum_text(const std::string& text)
{
    return format("%08" PRIx32, crc32(text));
}

std::string values_text(const Execution& e)
{
    return format("\t%" PRIu64 "\t%" PRIu64 "\t%.17g\t%.17g\t%.17g", e.local_lines, e.global_lines, e.mean_square,
                  e.relative, e.seconds);
}

/// Parses a record. Nothing if its checksum is wrong or it is malformed.
std::optional<std::pair<std::string, Execution>> parsed(const std::string& line)
{
    const std::size_t end = line.rfind('\t');
    if (end == std::string::npos || checksum_text(line.substr(0, end)) != line.substr(end + 1))
        return {};
    std::istringstream fields(line.substr(0, end));
    fields.imbue(std::locale::classic());
    ExecutionKey key;
    Execution e;
    std::getline(fields, key.curve, '\t');
    if (!(fields >> key.lines >> key.number >> e.local_lines >> e.global_lines >> e.mean_square >> e.relative >>
          e.seconds))
        return {};
    return std::pair{key_text(key), e};
}

} // namespace

Journal::Journal(const std::string& path, const std::string& identity) : path_(path)
{
    std::ifstream lines(path, std::ios::binary);
    std::string line;
    if (std::getline(lines, line) && line == identity)
        while (std::getline(lines, line))
            if (const auto record = parsed(line))
                executions_[record->first] = record->second;
    const bool fresh = executions_.empty();
    file_.open(path, std::ios::binary | (fresh ? std::ios::trunc : std::ios::app));
    append(fresh ? identity : ""); // a line feed ends a record that a crash may have cut off
}

void Journal::append(const std::string& line)
{
    if (!(file_ << line << '\n' << std::flush))
        throw std::runtime_error("cannot write " + path_ + ": " + std::strerror(errno));
}

std::optional<Execution> Journal::find(const ExecutionKey& key) const
{
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = executions_.find(key_text(key));
    return found == executions_.end() ? std::nullopt : std::optional(found->second);
}

void Journal::add(const ExecutionKey& key, const Execution& execution)
{
    const std::lock_guard<std::mutex> lock(mutex_);
    executions_[key_text(key)] = execution;
    const std::string text = key_text(key) + values_text(execution);
    if (!path_.empty())
        append(text + "\t" + checksum_text(text));
}

// All executions of all curves are independent tasks. Each execution solves the scene on one thread, with its own seed
// or its own range of items (points of the sequence). Its error against the reference is recorded in the journal, so
// that an interrupted study loses at most the runs in progress. At the end the executions with the same number of lines
// are averaged, and a power law is fitted to each curve.

namespace {

constexpr double clearly_above = 10.0; ///< times the error of the reference, which then moves a point by 10 % at most

/// Processor time of the calling thread since this object was made, without the time that other programs take.
class ProcessorTime
{
public:
    double seconds() const { return thread_seconds() - start_; } ///< [s]

private:
    double start_ = thread_seconds();
};

std::string curve_name(const CurveKind& kind)
{
    return kind.method + " " + kind.sequence + " " + kind.pairing + " " + kind.chords + " " + kind.line_order;
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

/// The executions of one curve, which share one preparation.
class CurveRuns
{
public:
    CurveRuns(const Scene& scene, const CurvePlan& plan, std::uint64_t seed) : scene_(scene), plan_(plan), seed_(seed)
    {
    }

    Execution run(std::uint64_t lines, int number, const std::vector<double>& areas, const Reference& reference,
                  const ProgressCallback& progress)
    {
        prepare_once();
        const ProcessorTime time;
        const Solution solution = solve(scene_, preparation_, options_for(lines, number), progress);
        const double seconds = preparation_seconds_ + time.seconds();
        const ErrorMeasure error = reference.measure ? reference.measure(solution.radiosity)
                                                     : measure_error(areas, solution.radiosity, reference.radiosity);
        return {solution.local_lines, solution.global_lines, error.mean_square, error.relative_mean_square, seconds};
    }

private:
    void prepare_once()
    {
        std::call_once(prepared_, [&] {
            const ProcessorTime time;
            preparation_ = prepare(scene_, plan_.options);
            preparation_seconds_ = time.seconds();
        });
    }

    SolveOptions options_for(std::uint64_t lines, int number) const
    {
        SolveOptions options = plan_.options;
        options.lines = lines;
        return independent_run(options, RandomStream::runs, seed_ ^ lines, static_cast<std::uint64_t>(number),
                               item_stride(scene_, options));
    }

    const Scene& scene_;
    const CurvePlan& plan_;
    std::uint64_t seed_;
    std::once_flag prepared_;
    Preparation preparation_;
    double preparation_seconds_ = 0.0;
};

struct PlannedRun
{
    std::size_t curve;
    ExecutionKey key;
};

/// Executions that are not in the journal, the longest first, so that all threads finish at about the same time.
std::vector<PlannedRun> runs_to_do(const StudyPlan& plan, const Journal& journal)
{
    std::vector<PlannedRun> runs;
    for (auto lines = plan.line_counts.rbegin(); lines != plan.line_counts.rend(); ++lines)
        for (std::size_t c = 0; c < plan.curves.size(); ++c)
            for (int number = 0; number < plan.executions; ++number) {
                const ExecutionKey key{curve_name(plan.curves[c].kind), *lines, number};
                if (!journal.find(key))
                    runs.push_back({c, key});
            }
    return runs;
}

CurvePoint mean_point(const CurveKind& kind, std::uint64_t lines, int executions, const Journal& journal)
{
    std::vector<Execution> runs;
    for (int number = 0; number < executions; ++number)
        runs.push_back(*journal.find({curve_name(kind), lines, number}));
    const auto averaged = [&](auto value) {
        RunningMean mean;
        for (const Execution& run : runs)
            mean.add(static_cast<double>(run.*value));
        return mean;
    };
    const RunningMean relative = averaged(&Execution::relative);
    return {lines,
            averaged(&Execution::local_lines).mean(),
            averaged(&Execution::global_lines).mean(),
            averaged(&Execution::mean_square).mean(),
            relative.mean(),
            executions > 1 ? relative.standard_error() : 0.0,
            averaged(&Execution::seconds).mean()};
}

Curve mean_curve(const CurveKind& kind, const StudyPlan& plan, const Reference& reference, const Journal& journal)
{
    Curve curve{kind, {}, {}};
    for (const std::uint64_t count : plan.line_counts) {
        curve.points.push_back(mean_point(kind, count, plan.executions, journal));
        CurvePoint& point = curve.points.back();
        point.above_reference = point.relative > clearly_above * reference.relative_square.value_or(0.0);
    }
    curve.law = fit(curve.points); // (2)
    return curve;
}

} // namespace

Study run_study(const Scene& scene, const Reference& reference, const StudyPlan& plan, Journal& journal, int threads,
                const ProgressCallback& progress)
{
    const std::vector<double> areas = scene.weights();
    std::vector<std::unique_ptr<CurveRuns>> curves;
    for (const CurvePlan& curve : plan.curves)
        curves.push_back(std::make_unique<CurveRuns>(scene, curve, plan.seed));

    const std::vector<PlannedRun> runs = runs_to_do(plan, journal);
    double all_lines = 0.0;
    for (const PlannedRun& run : runs)
        all_lines += static_cast<double>(run.key.lines);
    double done_lines = 0.0;
    std::mutex mutex;
    parallel_blocks(runs.size(), threads, [&](std::uint64_t n) {
        const PlannedRun& run = runs[n];
        const auto lines = static_cast<double>(run.key.lines);
        double reported = 0.0; // share of this run
        const auto report = [&](double done) {
            const std::lock_guard<std::mutex> lock(mutex);
            done_lines += (done - reported) * lines;
            reported = done;
            progress(std::min(1.0, done_lines / all_lines));
        };
        journal.add(run.key, curves[run.curve]->run(run.key.lines, run.key.number, areas, reference, report));
        report(1.0);
    });

    Study study;
    study.executions = plan.executions;
    study.reference_relative_square = reference.relative_square;
    for (const CurvePlan& curve : plan.curves)
        study.curves.push_back(mean_curve(curve.kind, plan, reference, journal));
    return study;
}

} // namespace multipath

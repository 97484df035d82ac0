#include "exam/method_questions.h"

#include "exam/known_scenes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace multipath {

namespace {

constexpr double whole_surfaces = 1e3;      ///< patch size [m] above any edge
constexpr double rounding = 1e-6;           ///< [1] of what is kept in single precision
constexpr double finest_method_miss = 0.05; ///< [1] a method that is off by so much must be caught

SolveOptions run_options(Method method, const std::string& sequence, const ExamSettings& settings, const ExamRun& run)
{
    SolveOptions options;
    options.method = method;
    options.sequence = sequence;
    options.seed = run.seed;
    options.skip = run.first_item;
    options.lines = settings.lines;
    options.threads = settings.threads;
    if (settings.broken == BrokenLaw::pairing)
        options.pairing = Pairing::two_dimensional;
    return options;
}

std::vector<ExamRow> examine(const KnownScene& known, const NamedMethod& named, const ExamSettings& settings)
{
    const Scene scene(with_law_broken(known.file, settings.broken), whole_surfaces);
    const Preparation preparation = preparation_for(scene, named.method);
    const double most_power = mean(scene.source_power());
    std::vector<ExamRow> rows;
    std::vector<Solution> all;
    for (const std::string& sequence : exam_sequences) {
        const std::vector<Solution> runs = solved_runs(scene, preparation, named.method, sequence, settings);
        const double unshot = mean_unshot(runs, named.method);
        for (const KnownAnswer& answer : known.answers) {
            ExamRow row = {known.name, named.name, sequence, answer.quantity, answer.value};
            std::vector<double> samples;
            for (const Solution& solution : runs)
                samples.push_back(answer.read(scene, solution));
            row.allowance = rounding * answer.value + unshot * answer.per_unshot_watt;
            row.resolution = finest_method_miss * (answer.value > 0.0 ? answer.value : most_power);
            rows.push_back(measured_by(row, samples));
        }
        all.insert(all.end(), runs.begin(), runs.end());
    }
    rows.push_back(balance_row(known.name, named.name, all));
    return rows;
}

} // namespace

Preparation preparation_for(const Scene& scene, Method method)
{
    SolveOptions options;
    options.method = method;
    return prepare(scene, options);
}

std::vector<Solution> solved_runs(const Scene& scene, const Preparation& preparation, Method method,
                                  const std::string& sequence, const ExamSettings& settings)
{
    std::vector<Solution> runs;
    for (const ExamRun& run : exam_runs(settings, sequence))
        runs.push_back(solve(scene, preparation, run_options(method, sequence, settings, run), [](double) {}));
    return runs;
}

double mean_unshot(const std::vector<Solution>& runs, Method method)
{
    if (method == Method::local)
        return 0.0;
    double sum = 0.0;
    for (const Solution& solution : runs) {
        const Rgb unshot = solution.balance.unshot;
        sum += std::max({std::abs(unshot.r), std::abs(unshot.g), std::abs(unshot.b)});
    }
    return sum / static_cast<double>(runs.size());
}

ExamRow balance_row(const std::string& topic, const std::string& method, const std::vector<Solution>& runs)
{
    ExamRow row = {topic, method, "all", "power gained or lost [1]"};
    row.allowance = 1e-9;
    row.resolution = 1e-9;
    for (const Solution& solution : runs)
        row.measured = std::max(row.measured, solution.balance.relative_error());
    return row;
}

std::vector<ExamTask> method_tasks(const ExamSettings& settings)
{
    std::vector<ExamTask> tasks;
    for (const KnownScene& known : known_scenes())
        for (const NamedMethod& method : exam_methods)
            tasks.push_back({known.name, [=] { return examine(known, method, settings); }});
    return tasks;
}

} // namespace multipath

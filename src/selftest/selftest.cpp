#include "selftest/selftest.h"

#include "base/elementary.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "export/csv_text.h"
#include "parallel/blocks.h"
#include "radiosity/run/replicates.h"
#include "radiosity/run/statistics.h"
#include "sampling/sequence.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr const char* outcome_words[] = {"passed", "WRONG", "INCONCLUSIVE"}; ///< by CheckOutcome

const char* word_for(CheckOutcome outcome)
{
    return outcome_words[static_cast<std::size_t>(outcome)];
}

/// The sigmas of a random check in this format; `missing` if nothing is random, or if all runs agree.
std::string sigmas_text(const Check& check, const char* number, const char* missing)
{
    const double off = sigmas(check);
    return check.degrees > 0 && std::isfinite(off) ? format(number, off) : missing;
}

std::string check_text(const Check& check, CheckOutcome outcome)
{
    const std::string error = check.degrees > 0 ? format("%.2g", check.standard_error) : "-";
    const char* const number = std::abs(sigmas(check)) < 1000.0 ? "%.2f" : "%.1e";
    return format("%-14s %-10s %-15s %-32s %11.6g %11.6g %9s %7s  %s\n", check.topic.c_str(), check.method.c_str(),
                  check.sequence.c_str(), check.quantity.c_str(), check.expected, check.measured, error.c_str(),
                  sigmas_text(check, number, "-").c_str(), word_for(outcome));
}

} // namespace

SignificanceTest::SignificanceTest(const std::vector<Check>& checks)
{
    const auto random = std::count_if(checks.begin(), checks.end(), [](const Check& c) { return c.degrees > 0; });
    tail_ = risk / static_cast<double>(std::max<std::ptrdiff_t>(1, random));
    failures_ = static_cast<std::size_t>(std::count_if(
        checks.begin(), checks.end(), [&](const Check& c) { return outcome(c) != CheckOutcome::passed; }));
}

double SignificanceTest::most_sigmas(int degrees) const
{
    return degrees > 0 ? student_quantile(tail_, degrees) : 0.0;
}

double SignificanceTest::limit(const Check& check) const
{
    return most_sigmas(check.degrees) * check.standard_error + check.allowance;
}

CheckOutcome SignificanceTest::outcome(const Check& check) const
{
    if (!(std::abs(check.measured - check.expected) <= limit(check))) // also true for NaN
        return CheckOutcome::wrong;
    return limit(check) <= check.resolution ? CheckOutcome::passed : CheckOutcome::inconclusive;
}

double sigmas(const Check& check)
{
    const double deviation = check.measured - check.expected;
    const double beyond = std::abs(deviation) - check.allowance;
    return beyond <= 0.0 ? 0.0 : std::copysign(beyond / check.standard_error, deviation);
}

std::string checks_text(const std::vector<Check>& checks, bool only_failed)
{
    const SignificanceTest test(checks);
    std::string text;
    double most = 0.0; // the widest limit, that of the checks with the fewest runs
    for (const Check& check : checks) {
        const CheckOutcome outcome = test.outcome(check);
        if (outcome != CheckOutcome::passed || !only_failed)
            text += check_text(check, outcome);
        most = std::max(most, test.most_sigmas(check.degrees));
    }
    if (!only_failed && most > 0.0)
        text +=
            format("a check fails beyond %.2f sigmas; a correct program fails any of them with a probability of %g\n",
                   most, SignificanceTest::risk);
    if (!text.empty())
        text = format("%-14s %-10s %-15s %-32s %11s %11s %9s %7s  %s\n", "case", "method", "sequence", "quantity",
                      "expected", "measured", "std error", "sigmas", "outcome") +
               text;
    return text + format("%zu passed, %zu failed\n", checks.size() - test.failures(), test.failures());
}

std::string checks_csv(const std::vector<Check>& checks, const std::vector<std::string>& comments)
{
    const SignificanceTest test(checks);
    std::string csv = comment_lines(comments);
    csv += "case,method,sequence,quantity,expected,measured,standard_error,sigmas,limit,outcome\n";
    for (const Check& check : checks) {
        for (const std::string& name : {check.topic, check.method, check.sequence, check.quantity})
            csv += csv_field(name) + ",";
        csv += format("%.17g,%.17g,", check.expected, check.measured) +
               (check.degrees > 0 ? format("%.17g", check.standard_error) : "") + "," + sigmas_text(check, "%.4g", "") +
               format(",%.4g,%s\n", test.limit(check), word_for(test.outcome(check)));
    }
    return csv;
}

// Every method solves every scene several times with independent lines. The mean of the runs is compared with the known
// answer, or with the mean by local Monte Carlo. The standard error of the mean comes from the scatter of the runs. So
// the checks are statistical tests (see SignificanceTest) that hold for any seed, not comparisons with stored numbers.

namespace {

constexpr double whole_surfaces = 1e3;          ///< [m] patch size larger than any edge: a surface is one patch
constexpr double rounding = 1e-6;               ///< [1] relative, of numbers in single precision
constexpr double known_scene_resolution = 0.05; ///< [1]
constexpr double scene_resolution = 0.25;       ///< [1] scenes may be hard
constexpr std::size_t most_materials = 4;

constexpr const char* scene_sequence = "sobol-owen";

SolveOptions options_of_run(Method method, const std::string& sequence, const SelftestSettings& settings, int number)
{
    constexpr std::uint64_t most_items_per_line = 16;
    SolveOptions options;
    options.method = method;
    options.sequence = sequence;
    options.lines = settings.lines;
    options.bundle = 16; // scenes of few patches need many directions, not many lines per direction
    options.threads = settings.threads;
    return independent_run(options, RandomStream::runs, settings.seed, static_cast<std::uint64_t>(number),
                           most_items_per_line * settings.lines);
}

std::vector<Solution> solved_runs(const Scene& scene, Method method, const std::string& sequence,
                                  const SelftestSettings& settings)
{
    SolveOptions usual; // the same preparation with any number of lines
    usual.method = method;
    const Preparation preparation = prepare(scene, usual);
    return serial_list(settings.replicates, [&](int number) {
        return solve(scene, preparation, options_of_run(method, sequence, settings, number), [](double) {});
    });
}

/// The check with mean, standard error and degrees of freedom of quantity(run) over the runs. Without randomisation,
/// the runs take successive ranges of one sequence and have common errors, which their scatter does not show; 1/200 of
/// the expected value is allowed for these.
template <class Run, class Quantity>
Check measured_by(Check check, const std::vector<Run>& runs, const Quantity& quantity)
{
    RunningMean mean;
    for (const Run& run : runs)
        mean.add(quantity(run));
    check.measured = mean.mean();
    check.standard_error = mean.standard_error();
    check.degrees = static_cast<int>(runs.size()) - 1;
    if (!is_randomised(check.sequence))
        check.allowance += check.expected / 200.0;
    return check;
}

/// Mean over the runs of the power left unshot [W], in the channel with the most. Zero for the local method, whose
/// Russian roulette is unbiased.
double mean_unshot(const std::vector<Solution>& runs, Method method)
{
    if (method == Method::local)
        return 0.0;
    RunningMean mean;
    for (const Solution& run : runs) {
        const Rgb unshot = run.balance.unshot;
        mean.add(std::max({std::abs(unshot.r), std::abs(unshot.g), std::abs(unshot.b)}));
    }
    return mean.mean();
}

/// Checks that emitted = absorbed + unshot + escaped + behind in all runs.
Check balance_check(const std::string& topic, const std::string& method, const std::vector<Solution>& runs)
{
    Check check = {topic, method, "all", "power gained or lost [1]"};
    check.allowance = 1e-9;
    check.resolution = 1e-9;
    for (const Solution& run : runs)
        check.measured = std::max(check.measured, run.balance.relative_error());
    return check;
}

/// The checks of one known scene by one method.
std::vector<Check> known_scene_checks_by(const KnownScene& known, const Method method, const SelftestSettings& settings)
{
    const Scene scene(known.file, whole_surfaces);
    const double most_power = mean(scene.source_power());
    SelftestSettings of_method = settings;
    if (method == Method::gathering)
        of_method.lines *= 4;
    std::vector<Check> checks;
    std::vector<Solution> all;
    for (const SequenceKind& kind : sequence_kinds()) {
        if (!kind.in_selftest)
            continue;
        const std::string sequence(kind.name);
        const std::vector<Solution> runs = solved_runs(scene, method, sequence, of_method);
        const double unshot = mean_unshot(runs, method);
        for (const KnownAnswer& answer : known.answers) {
            Check check = {known.name, std::string(method->name), sequence, answer.quantity, answer.value};
            check.allowance = rounding * answer.value + unshot * answer.per_unshot_watt;
            check.resolution = known_scene_resolution * (answer.value > 0.0 ? answer.value : most_power);
            checks.push_back(measured_by(check, runs, [&](const Solution& run) { return answer.read(scene, run); }));
        }
        all.insert(all.end(), runs.begin(), runs.end());
    }
    checks.push_back(balance_check(known.name, std::string(method->name), all));
    return checks;
}

/// Power [W], mean of the channels, that the patches of each material reflect, for each run.
std::vector<std::vector<double>> reflected_powers(const Scene& scene, const std::vector<Solution>& runs)
{
    return mapped(runs, [&](const Solution& run) {
        std::vector<double> power(scene.materials().size());
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            power[scene.file().material[scene.surface_of(i)]] +=
                scene.area(i) * mean(run.radiosity[i] - scene.emittance(i));
        return power;
    });
}

/// The materials that reflect most power, at most most_materials, the brightest first.
std::vector<std::size_t> brightest_materials(const std::vector<std::vector<double>>& powers)
{
    std::vector<double> sums(powers.front().size());
    std::vector<std::size_t> order;
    for (std::size_t m = 0; m < sums.size(); ++m) {
        for (const std::vector<double>& power : powers)
            sums[m] += power[m];
        if (sums[m] > 0.0)
            order.push_back(m);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return sums[a] > sums[b]; });
    order.resize(std::min(order.size(), most_materials));
    return order;
}

/// Bound of the power [W] that unshot light would still add to a material: twice what it would add if it were spread
/// evenly over the scene.
double missing_power(const Scene& scene, std::size_t material, double unshot)
{
    double area = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        area += scene.file().material[scene.surface_of(i)] == material ? scene.area(i) : 0.0;
    const double absorbed = std::max(0.01, 1.0 - mean(scene.average_reflectance()));
    return 2.0 * unshot * mean(scene.materials()[material].reflectance) * area / scene.total_area() / absorbed;
}

/// Checks of the reflected power of these materials; the expected value is still missing.
std::vector<Check> material_checks(const Scene& scene, const std::string& method,
                                   const std::vector<std::size_t>& materials,
                                   const std::vector<std::vector<double>>& powers, double unshot)
{
    return mapped(materials, [&](std::size_t m) {
        Check check = {"agreement", method, scene_sequence, scene.materials()[m].name + " [W]"};
        check.allowance = missing_power(scene, m, unshot);
        return measured_by(check, powers, [&](const std::vector<double>& power) { return power[m]; });
    });
}

/// The check with the result of another method as the expected value. The standard errors of both are combined.
Check compared_with(Check check, const Check& other)
{
    check.expected = other.measured;
    check.standard_error = elementary::hypot(check.standard_error, other.standard_error);
    check.degrees = std::min(check.degrees, other.degrees);
    check.resolution = scene_resolution * other.measured;
    return check;
}

/// Checks that no patch reflects negative power. Noise may make the exchange of two patches negative in a single run;
/// the mean of all runs may be negative by up to 6 standard errors.
Check reflected_check(const Scene& scene, const std::string& method, const std::vector<Solution>& runs)
{
    double least = 0.0;
    double most = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        RunningMean reflected;
        for (const Solution& run : runs)
            reflected.add(mean(run.radiosity[i] - scene.emittance(i)));
        least = std::min(least, reflected.mean() + 6.0 * reflected.standard_error());
        most = std::max(most, reflected.mean());
    }
    Check check = {"power", method, scene_sequence, "least B - E, or 0 [W/m^2]", 0.0, least};
    check.allowance = 1e-6 * most;
    check.resolution = check.allowance;
    return check;
}

/// Checks that the runs emit the power of the sources.
Check emitted_check(const Scene& scene, const std::string& method, const std::vector<Solution>& runs)
{
    Check check = {"power", method, scene_sequence, "emitted [W]", mean(scene.source_power())};
    check.allowance = 1e-9 * check.expected;
    check.resolution = scene_resolution * check.expected;
    return measured_by(check, runs, [](const Solution& run) { return mean(run.balance.emitted); });
}

} // namespace

std::vector<Check> known_scene_checks(const std::vector<KnownScene>& scenes, const SelftestSettings& settings,
                                      const ProgressCallback& progress)
{
    SelftestSettings of_run = settings;
    of_run.threads = 1;
    const std::vector<Method> methods = all_methods();
    const std::uint64_t tasks = scenes.size() * methods.size();
    BlockBuffers<std::vector<Check>> slots(settings.threads);
    std::vector<Check> checks;
    const auto solve_task = [&](std::uint64_t number, int slot) {
        const auto task = static_cast<std::size_t>(number);
        slots[slot] = known_scene_checks_by(scenes[task / methods.size()], methods[task % methods.size()], of_run);
    };
    const auto append_checks = [&](std::uint64_t number, int slot) {
        const std::vector<Check>& found = slots[slot];
        checks.insert(checks.end(), found.begin(), found.end());
        progress(static_cast<double>(number + 1) / static_cast<double>(tasks));
    };
    ordered_blocks(tasks, settings.threads, solve_task, append_checks);
    return checks;
}

std::vector<Check> scene_checks(const Scene& scene, const SelftestSettings& settings, const ProgressCallback& progress)
{
    std::vector<Check> checks;
    std::vector<std::size_t> materials;
    std::vector<Check> local;
    double done = 0.0;
    for (const Method method : all_methods()) {
        SelftestSettings of_method = settings;
        if (method == Method::gathering) // few of its walks meet a small lamp
            of_method.lines *= 16;
        const std::vector<Solution> runs = solved_runs(scene, method, scene_sequence, of_method);
        const std::string name(method->name);
        checks.push_back(balance_check("power", name, runs));
        checks.push_back(emitted_check(scene, name, runs));
        checks.push_back(reflected_check(scene, name, runs));
        const std::vector<std::vector<double>> powers = reflected_powers(scene, runs);
        if (method == Method::local)
            materials = brightest_materials(powers);
        const std::vector<Check> found = material_checks(scene, name, materials, powers, mean_unshot(runs, method));
        if (method == Method::local)
            local = found;
        else
            for (std::size_t k = 0; k < found.size(); ++k)
                checks.push_back(compared_with(found[k], local[k]));
        progress(++done / static_cast<double>(all_methods().size()));
    }
    return checks;
}

} // namespace multipath

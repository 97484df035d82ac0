#include "exam/sampling_questions.h"

#include "sampling/discrepancy.h"
#include "sampling/sequence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace multipath {

namespace {

ExamRow exact_row(const std::string& sequence, const std::string& quantity, double expected, double measured)
{
    ExamRow row = {"points", "", sequence, quantity, expected, measured};
    row.allowance = 1e-12;
    row.resolution = 1e-12;
    return row;
}

/// The largest difference between a sequence and numbers computed by hand.
double largest_difference(const Sequence& sequence, std::uint64_t first, const std::vector<Item>& known)
{
    double largest = 0.0;
    for (std::size_t k = 0; k < known.size(); ++k)
        for (std::size_t d = 0; d < known[k].size(); ++d)
            largest = std::max(largest, std::abs(sequence.item(first + k)[d] - known[k][d]));
    return largest;
}

/// Sobol: the Gray code of n says which direction numbers are added without carry. Those of the first four dimensions
/// begin with 1/2; 3/4, 1/4, 3/4, 3/4; 5/8, 7/8, 7/8, 3/8.
/// Halton, of bases 2, 7, 3, 5: 10 is 1010 in base 2, 13 in base 7, 101 in base 3, 20 in base 5.
std::vector<ExamRow> first_numbers()
{
    const std::vector<Item> sobol = {{0.0, 0.0, 0.0, 0.0},
                                     {0.5, 0.5, 0.5, 0.5},
                                     {0.25, 0.75, 0.25, 0.25},
                                     {0.75, 0.25, 0.75, 0.75},
                                     {0.375, 0.625, 0.125, 0.625}};
    const std::vector<Item> halton = {{5.0 / 16.0, 22.0 / 49.0, 10.0 / 27.0, 2.0 / 25.0}};
    const double of_sobol = largest_difference(*make_sequence("sobol", 0), 0, sobol);
    const double of_halton = largest_difference(*make_sequence("halton", 0), 10, halton);
    return {exact_row("sobol", "points 0 to 4, difference", 0.0, of_sobol),
            exact_row("halton", "point 10, difference", 0.0, of_halton)};
}

/// Of `count` intervals of one length, how many points the fullest holds of the first `count` points. A point that
/// rounding has put just below the end of an interval belongs to the next.
double fullest_interval(const Sequence& sequence, int dimension, std::uint64_t count)
{
    std::vector<int> points(static_cast<std::size_t>(count), 0);
    for (std::uint64_t n = 0; n < count; ++n) {
        const double place = sequence.coordinate(n, dimension) * static_cast<double>(count) + 1e-9;
        ++points[std::min(points.size() - 1, static_cast<std::size_t>(place))];
    }
    return *std::max_element(points.begin(), points.end());
}

/// In base b, each of the b^k intervals of length b^-k has exactly one of the first b^k points, also of shifted and
/// scrambled ones.
std::vector<ExamRow> elementary_intervals(const ExamSettings& settings)
{
    struct Kind
    {
        const char* sequence;
        std::array<std::uint64_t, 4> counts; ///< powers of the bases
    };
    constexpr std::array<std::uint64_t, 4> binary = {4096, 4096, 4096, 4096};
    constexpr std::array<std::uint64_t, 4> mixed = {4096, 2401, 2187, 3125};
    const std::vector<Kind> kinds = {{"sobol", binary},
                                     {"sobol-shift", binary},
                                     {"sobol-owen", binary},
                                     {"halton", mixed},
                                     {"halton-permuted", mixed}};
    std::vector<ExamRow> rows;
    for (const Kind& kind : kinds) {
        const std::unique_ptr<Sequence> sequence = make_sequence(kind.sequence, settings.seed);
        double fullest = 0.0;
        for (int d = 0; d < 4; ++d)
            fullest = std::max(fullest, fullest_interval(*sequence, d, kind.counts[static_cast<std::size_t>(d)]));
        rows.push_back(exact_row(kind.sequence, "points in the fullest interval", 1.0, fullest));
    }
    return rows;
}

/// N points k / N have the star discrepancy 1 / N: [0, 1 / N] closed holds two of them less one end.
/// Random ones have the mean square (2^-4 - 3^-4) / N: the variance of "is the point in the box", averaged over boxes.
std::vector<ExamRow> discrepancies(const ExamSettings& settings)
{
    constexpr std::uint64_t ordered = 1024;
    const PointSet line = points_of(*make_sequence("sobol", 0, 1), 0, ordered);
    constexpr std::uint64_t loose = 64;
    ExamSettings many = settings;
    many.replicates = 16 * settings.replicates;
    std::vector<double> samples;
    for (const ExamRun& run : exam_runs(many, "random")) {
        const double discrepancy = l2_star_discrepancy(points_of(*make_sequence("random", run.seed), 0, loose));
        samples.push_back(discrepancy * discrepancy);
    }
    const double expected = (1.0 / 16.0 - 1.0 / 81.0) / static_cast<double>(loose);
    ExamRow row = {"points", "", "random", "mean square discrepancy", expected};
    row.resolution = 0.25 * expected;
    return {exact_row("sobol", "star discrepancy of 1024 points", 1.0 / static_cast<double>(ordered),
                      star_discrepancy(line).value_or(-1.0)),
            measured_by(row, samples)};
}

/// The integral of 16 x y z w over the unit cube is 1.
std::vector<ExamRow> integrals(const ExamSettings& settings)
{
    std::vector<ExamRow> rows;
    for (const SequenceKind& kind : sequence_kinds()) {
        if (kind.randomised.empty())
            continue; // it has one stretch of points and one only
        const std::string name(kind.name);
        std::vector<double> samples;
        for (const ExamRun& run : exam_runs(settings, name)) {
            std::vector<Item> items(static_cast<std::size_t>(settings.lines));
            make_sequence(name, run.seed)->generate(run.first_item, items);
            double sum = 0.0;
            for (const Item& x : items)
                sum += 16.0 * x[0] * x[1] * x[2] * x[3];
            samples.push_back(sum / static_cast<double>(items.size()));
        }
        ExamRow row = {"points", "", name, "integral of 16 x y z w", 1.0};
        row.resolution = 0.05;
        rows.push_back(measured_by(row, samples));
    }
    return rows;
}

} // namespace

std::vector<ExamTask> sampling_tasks(const ExamSettings& settings)
{
    return {{"points", first_numbers},
            {"points", [=] { return elementary_intervals(settings); }},
            {"points", [=] { return discrepancies(settings); }},
            {"points", [=] { return integrals(settings); }}};
}

} // namespace multipath

#include "commands/result_comparison.h"

#include "scene/input_error.h"
#include "scene/text_format.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace multipath {

void require_same_patches(const PatchTable& a, const PatchTable& b)
{
    if (a.areas.size() != b.areas.size())
        throw InputError(a.path + ": " + grouped(a.areas.size()) + " patches, expected " + grouped(b.areas.size()) +
                         " as in " + b.path);
    for (std::size_t i = 0; i < a.areas.size(); ++i)
        if (!(std::abs(a.areas[i] - b.areas[i]) <= 1e-9 * b.areas[i]))
            throw InputError(a.path +
                             format(": patch %zu has %.12g m^2, expected %.12g m^2 as in ", i, a.areas[i], b.areas[i]) +
                             b.path);
}

namespace {

/// Area-weighted [W/m^2].
double mean_radiosity(const PatchTable& table)
{
    double power = 0.0;
    double area = 0.0;
    for (std::size_t i = 0; i < table.areas.size(); ++i) {
        power += table.areas[i] * mean(table.radiosity[i]);
        area += table.areas[i];
    }
    return power / area;
}

std::optional<double> expected_error(const PatchTable& table)
{
    if (table.standard_error.empty())
        return std::nullopt;
    return expected_relative_square(table.areas, table.radiosity, table.standard_error);
}

Deviation largest_deviation(const PatchTable& a, const PatchTable& b)
{
    Deviation largest;
    for (std::size_t i = 0; i < a.areas.size(); ++i) {
        const Rgb difference = a.radiosity[i] - b.radiosity[i];
        for (const double value : {difference.r, difference.g, difference.b})
            if (std::abs(value) > std::abs(largest.value))
                largest = {i, value};
    }
    return largest;
}

std::vector<WorstPatch> worst_patches(const PatchTable& a, const PatchTable& b, std::size_t count)
{
    std::vector<WorstPatch> patches;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.areas.size(); ++i) {
        const Rgb error = a.radiosity[i] - b.radiosity[i];
        patches.push_back({i, b.areas[i] * mean(error * error)});
        sum += patches.back().share;
    }
    if (!(sum > 0.0))
        return {};
    for (WorstPatch& patch : patches)
        patch.share /= sum;
    count = std::min(count, patches.size());
    std::partial_sort(patches.begin(), patches.begin() + static_cast<std::ptrdiff_t>(count), patches.end(),
                      [](const WorstPatch& p, const WorstPatch& q) {
                          return p.share != q.share ? p.share > q.share : p.patch < q.patch;
                      });
    patches.resize(count);
    return patches;
}

} // namespace

double Comparison::root() const
{
    return std::sqrt(error.relative_mean_square);
}

std::optional<double> Comparison::measured_over_expected() const
{
    const double expected =
        expected_a.value_or(0.0) * mean_a * mean_a + expected_b.value_or(0.0) * mean_b * mean_b; // [W^2/m^4]
    return expected > 0.0 ? std::optional<double>(error.mean_square / expected) : std::nullopt;
}

Comparison compare(const PatchTable& a, const PatchTable& b, std::size_t worst_count)
{
    Comparison c{a, b};
    c.area = std::accumulate(b.areas.begin(), b.areas.end(), 0.0);
    c.mean_a = mean_radiosity(a);
    c.mean_b = mean_radiosity(b);
    c.error = measure_error(b.areas, a.radiosity, b.radiosity);
    c.expected_a = expected_error(a);
    c.expected_b = expected_error(b);
    const double all_figures = c.area + c.error.mean_square + c.mean_a * c.mean_a + c.mean_b * c.mean_b +
                               c.expected_a.value_or(0.0) + c.expected_b.value_or(0.0);
    if (!std::isfinite(all_figures))
        throw InputError(a.path + ": numbers too large to compare with " + b.path + ", expected W/m^2 and m^2");
    if (!(c.mean_b * c.mean_b > 0.0))
        throw InputError(b.path + ": mean radiosity is 0, expected a reference with light");
    c.largest = largest_deviation(a, b);
    c.worst = worst_patches(a, b, worst_count);
    return c;
}

} // namespace multipath

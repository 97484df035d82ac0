#pragma once

#include "radiosity/run/solve.h"
#include "statistics.h"

#include <cstdint>
#include <vector>

namespace multipath {

inline const ProgressCallback silent = [](double) {};

inline SolveOptions random_lines(Method method, std::uint64_t lines, std::uint64_t seed)
{
    SolveOptions options;
    options.method = method;
    options.sequence = "random";
    options.lines = lines;
    options.seed = seed;
    return options;
}

/// Means of each of `quantities(solution)`, a vector<double>, over independent seeds.
template <class Quantities>
std::vector<Estimate> all_over_seeds(const Scene& scene, SolveOptions options, int seeds, const Quantities& quantities)
{
    std::vector<std::vector<double>> samples;
    for (int seed = 1; seed <= seeds; ++seed) {
        options.seed = static_cast<std::uint64_t>(seed);
        const std::vector<double> values = quantities(solve(scene, options, silent));
        samples.resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i)
            samples[i].push_back(values[i]);
    }
    std::vector<Estimate> means;
    for (const std::vector<double>& of_one : samples)
        means.push_back(estimate(of_one));
    return means;
}

/// Mean of `quantity(solution)` over independent seeds.
template <class Quantity>
Estimate over_seeds(const Scene& scene, const SolveOptions& options, int seeds, const Quantity& quantity)
{
    return all_over_seeds(scene, options, seeds, [&](const Solution& s) { return std::vector<double>{quantity(s)}; })
        .front();
}

/// Mean radiosities of these patches [W/m^2], in the green channel, over independent seeds.
inline std::vector<Estimate> radiosities(const Scene& scene, const SolveOptions& options, int seeds,
                                         const std::vector<std::uint32_t>& patches)
{
    return all_over_seeds(scene, options, seeds, [&](const Solution& s) {
        std::vector<double> values;
        for (const std::uint32_t patch : patches)
            values.push_back(s.radiosity[patch].g);
        return values;
    });
}

} // namespace multipath

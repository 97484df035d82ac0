#pragma once

#include "radiosity/solve.h"
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

/// Mean of `quantity(solution)` over independent seeds.
template <class Quantity>
Estimate over_seeds(const Scene& scene, SolveOptions options, int seeds, const Quantity& quantity)
{
    std::vector<double> samples;
    for (int seed = 1; seed <= seeds; ++seed) {
        options.seed = static_cast<std::uint64_t>(seed);
        samples.push_back(quantity(solve(scene, options, silent)));
    }
    return estimate(samples);
}

} // namespace multipath

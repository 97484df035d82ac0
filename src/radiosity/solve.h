#pragma once

#include "radiosity/extended_first_shot.h"
#include "radiosity/power_state.h"
#include "radiosity/solve_options.h"
#include "transport/unoccluded_exchange.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace multipath {

struct Solution
{
    std::vector<Rgb> radiosity; ///< [W/m^2] per patch
    /// [W/m^2] per patch: received or emitted, not yet sent on when the work ended. Of the method `reuse` what the
    /// solution lacks or has too much.
    std::vector<Rgb> unshot;
    PowerBalance balance;
    std::uint64_t local_lines = 0;  ///< N_l
    std::uint64_t global_lines = 0; ///< N_g, charged by (N1)
    std::uint64_t global_lines_cast = 0;
    std::vector<ShotPass> shot_passes; ///< of the (extended) first shot; with replicates of the first one
    std::uint64_t all_lines = 0;       ///< charged, rounds before included that led to this result

    int replicates = 1;
    std::vector<Rgb> standard_error;               ///< [W/m^2] per patch; empty without replicates
    std::optional<double> relative_standard_error; ///< [1] root of the relative MSE (1) to be expected
};

/// Told how much of the work is done, 0 ... 1, in increasing order, from the thread that just finished a piece.
using ProgressCallback = std::function<void(double done)>;

/// What solving needs to know of a scene and is the same for every run with the same options but seed and lines.
struct Preparation
{
    std::optional<double> ratio;                          ///< N_l / N_g of the methods that have one
    std::shared_ptr<const UnoccludedExchange> unoccluded; ///< of `reuse`, if there is memory for a table of all pairs
};

Preparation prepare(const Scene& scene, const SolveOptions& options);

Solution solve(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
               const ProgressCallback& progress);

/// The radiosity of every patch. The result is a function of scene, options and seed; not of the threads.
/// Throws InputError for a sequence with too few items or more rays by power_by_line than lines, std::invalid_argument
/// for an unknown one.
Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress);

} // namespace multipath

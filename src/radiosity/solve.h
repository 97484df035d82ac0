#pragma once

#include "parallel/run_control.h"
#include "radiosity/reuse/gathered_light.h"
#include "radiosity/solution.h"
#include "radiosity/solve_options.h"
#include "transport/exchange/unoccluded_exchange.h"

#include <functional>
#include <memory>
#include <optional>

namespace multipath {

/// Told how much of the work is done, 0 ... 1, in increasing order, from the thread that just finished a piece.
using ProgressCallback = std::function<void(double done)>;

/// What solving needs to know of a scene and is the same for every run with the same options but seed and lines.
struct Preparation
{
    std::optional<double> ratio;                          ///< N_l / N_g of the methods that have one
    std::shared_ptr<const UnoccludedExchange> unoccluded; ///< of `reuse` with a table of all pairs
    std::shared_ptr<const SceneLights> lights;            ///< of `reuse` without
};

/// Throws InputError if light is trapped among surfaces that reflect all of it.
Preparation prepare(const Scene& scene, const SolveOptions& options);

/// The radiosity of every patch. The result is a function of scene, options and seed; not of the threads. If the
/// checkpoint stops the work, the result is what it was then; a share of it has no result but what it hands in.
/// Throws SettingsError for a sequence with too few items, more rays by power_by_line than lines, and more lines than
/// `reuse` can count; InputError for a share whose counts fill the memory; std::invalid_argument for an unknown
/// sequence.
Solution solve(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
               const ProgressCallback& progress, Checkpoint* checkpoint = nullptr, Shard shard = {});

Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress);

} // namespace multipath

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

/// Called with the finished fraction of the work, 0 ... 1, in increasing order, by the thread that just finished a
/// part.
using ProgressCallback = std::function<void(double done)>;

/// Data shared by all runs of a scene whose options differ only in seed and lines.
struct Preparation
{
    std::optional<double> ratio;                          ///< N_l / N_g, for methods that use it
    std::shared_ptr<const UnoccludedExchange> unoccluded; ///< for `reuse` with a table of all pairs
    std::shared_ptr<const SceneLights> lights;            ///< for `reuse` without a table
};

/// Prepares runs of the scene. Throws InputError if light is trapped among surfaces that reflect all of it.
Preparation prepare(const Scene& scene, const SolveOptions& options);

/// Solves for the radiosity of every patch. The result is a function of scene, options and seed, not of the number of
/// threads. If the checkpoint stops the work, returns the solution so far; a shard of `reuse` returns nothing useful,
/// as its counts are in the checkpoint. Throws SettingsError for a sequence with too few items, more rays by
/// power_by_line than lines, more lines than `reuse` can count, or a shard with too few; InputError for a shard whose
/// counts do not fit into the memory, or if the equations have no sound solution; std::invalid_argument for an unknown
/// sequence.
Solution solve(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
               const ProgressCallback& progress, Checkpoint* checkpoint = nullptr, Shard shard = {});

Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress);

} // namespace multipath

#pragma once

#include "parallel/run_control.h"
#include "radiosity/reuse/gathered_light.h"
#include "radiosity/run/solution.h"
#include "radiosity/run/solve_options.h"
#include "transport/exchange/pair_counts.h"

#include <functional>
#include <future>
#include <memory>
#include <optional>

namespace multipath {

/// Called now and then with the finished fraction of the work, 0 ... 1. The fraction never decreases during one call of
/// solve(). It begins at 0 again in each round of solve_in_rounds() and in the second run of solve_incrementally(). The
/// calls come from any thread, but one at a time.
using ProgressCallback = std::function<void(double done)>;

/// Data shared by all runs of a scene whose options differ only in seed and lines. The method decides which of them are
/// set.
struct Preparation
{
    std::optional<double> ratio; ///< N_l / N_g, local lines per global line, for methods that shoot first
    /// [m^2] For the method `reuse` with a table of all pairs of patches: unoccluded_exchange(), computed on first use,
    /// so that lines can be cast before it takes memory.
    std::shared_future<PairMatrix<float>> unoccluded;
    std::shared_ptr<const SceneLights> lights; ///< for the method `reuse` without a table
};

/// Prepares runs of the scene. Throws InputError if light is trapped among surfaces that reflect all of it.
Preparation prepare(const Scene& scene, const SolveOptions& options);

/// Solves for the radiosity of every patch. The result is a function of scene, options (the seed is one of them) and
/// preparation, not of the number of threads. If the checkpoint stops the work, returns the solution so far. `shard`:
/// the part of the work for the method `reuse`, if several runs divide its lines; the result of such a run is not
/// useful, since its counts are in the checkpoint.
///
/// Throws SettingsError for a sequence with too few items, for a first shot whose first pass needs more rays of
/// power_by_line than there are lines, for more lines than `reuse` can count, and for a shard with too few lines per
/// patch. Throws InputError for a shard whose counts do not fit into the memory, and NoSolution if not even particles
/// find a sound solution: where the method finds none, they carry the light (Solution::by_particles). Throws
/// std::invalid_argument for a sequence that cannot be made, and ArchiveError if the checkpoint does not fit.
Solution solve(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
               const ProgressCallback& progress, Checkpoint* checkpoint = nullptr, Shard shard = {});

/// The same with the preparation that prepare() makes; throws what prepare() throws, too.
Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress);

} // namespace multipath

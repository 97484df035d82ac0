#include "radiosity/run/solve.h"

#include "radiosity/run/run.h"
#include "radiosity/run/trapped_light.h"

namespace multipath {

Preparation prepare(const Scene& scene, const SolveOptions& options)
{
    require_absorption(scene);
    Preparation preparation;
    if (options.method->prepare)
        options.method->prepare(scene, options, preparation);
    return preparation;
}

Solution solve(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
               const ProgressCallback& progress, Checkpoint* checkpoint, Shard shard)
{
    SolveOptions prepared = options;
    if (preparation.ratio)
        prepared.ratio = preparation.ratio;
    try {
        return Run(scene, prepared, preparation, progress, checkpoint, shard).solve();
    } catch (const NoSolution&) {
        if (prepared.method == Method::local || shard.of > 1)
            throw;
    }
    prepared.method = Method::local;
    Solution solution = Run(scene, prepared, preparation, progress, nullptr, shard).solve();
    solution.by_particles = true;
    return solution;
}

Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress)
{
    return solve(scene, prepare(scene, options), options, progress);
}

} // namespace multipath

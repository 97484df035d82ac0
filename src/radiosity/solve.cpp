#include "radiosity/solve.h"

#include "radiosity/run.h"
#include "radiosity/trapped_light.h"

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
    return Run(scene, prepared, preparation, progress, checkpoint, shard).solve();
}

Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress)
{
    return solve(scene, prepare(scene, options), options, progress);
}

} // namespace multipath

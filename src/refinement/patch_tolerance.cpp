#include "refinement/patch_tolerance.h"

#include "base/elementary.h"
#include "refinement/adaptive_patches.h"
#include "refinement/shown_error.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace multipath {

RefinedScene refined_to_error(const Scene& coarse, double wanted, const std::function<void(double)>& require_memory,
                              double memory, int threads, const ProgressCallback& progress)
{
    constexpr double most = 1e6;              // patches
    constexpr double order = 1.3;             // of convergence of the MSE in the number of patches, measured in rooms
    constexpr double least = 1.5, step = 8.0; // smallest and largest growth at a time
    Scene scene = coarse;
    for (;;) {
        const double error = patch_error(scene, wanted, memory, threads, progress).root_upper_bound();
        const double room = most / scene.patch_count();
        if (error <= wanted || room < least)
            return {scene, error};
        const double growth = std::clamp(elementary::pow(error / wanted, 2.0 / order), least, std::min(step, room));
        const auto patches = static_cast<std::uint64_t>(growth * scene.patch_count());
        require_memory(static_cast<double>(patches));
        Scene finer = adaptively_refined(scene, patches, memory, threads, progress);
        if (finer.patch_count() == scene.patch_count()) // no patch can be cut further
            return {scene, error};
        scene = std::move(finer);
    }
}

} // namespace multipath

#include "refinement/patch_tolerance.h"

#include "base/elementary.h"
#include "refinement/adaptive_patches.h"
#include "refinement/shown_error.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace multipath {

RefinedScene refined_to_error(const Scene& coarse, double wanted, const std::function<void(double)>& before_cut,
                              double memory, int threads, const ProgressCallback& progress)
{
    constexpr double most = 1e6;              // patches
    constexpr double order = 1.3;             // of convergence of the MSE in the number of patches, measured in rooms
    constexpr double least = 1.5, step = 8.0; // smallest and largest growth at a time
    constexpr double cutting = 0.6;           // share of the work of cutting and measuring
    RefinedScene best = {coarse, patch_error(coarse, wanted, memory, threads, progress).root_upper_bound()};
    try {
        for (;;) {
            const double room = most / best.scene.patch_count();
            if (best.error <= wanted || room < least)
                return best;
            const double growth =
                std::clamp(elementary::pow(best.error / wanted, 2.0 / order), least, std::min(step, room));
            const auto patches = static_cast<std::uint64_t>(growth * best.scene.patch_count());
            before_cut(static_cast<double>(patches));
            Scene finer = adaptively_refined(best.scene, patches, memory, threads,
                                             [&](double done) { progress(cutting * done); });
            if (finer.patch_count() == best.scene.patch_count()) // no patch can be cut further
                return best;
            const ShownError error = patch_error(finer, wanted, memory, threads,
                                                 [&](double done) { progress(cutting + (1.0 - cutting) * done); });
            best = {std::move(finer), error.root_upper_bound()};
        }
    } catch (const EnoughPatches&) {
        return best;
    }
}

} // namespace multipath

#pragma once

#include "scene/scene.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace multipath {

/// Which patches see the whole of which surfaces, with certainty: nothing reaches into the convex hull of the two.
/// Found when it is first asked for, so that only what a picture shows is looked at. Safe to share between threads.
class ClearSight
{
public:
    /// `targets`: numbers of surfaces. The scene must outlive this object. Of scenes so large that it would take longer
    /// than it saves nothing is found to be clear.
    ClearSight(const Scene& scene, std::vector<std::uint32_t> targets);

    /// Does nothing stand between any point of a patch and any of a target, given by its place in the list? False if
    /// that is not certain, and for Scene::no_patch.
    bool is_clear(std::uint32_t patch, std::size_t target) const;

private:
    bool find(std::uint32_t patch, std::uint32_t target) const;

    const Scene& scene_;
    std::vector<std::uint32_t> targets_;
    double touching_; ///< [scene units] what reaches less far into the hull touches it
    mutable std::vector<std::atomic<std::uint8_t>> known_; ///< per patch and target: 0 not yet, 1 no, 2 yes
};

} // namespace multipath

#pragma once

#include "scene/scene.h"

#include <algorithm>

namespace multipath {

constexpr double bytes_per_surface = 700; ///< [bytes] peak while the file is read: corners, mesh parts, names

/// [bytes] Peak memory of a run with so many surfaces and patches, by any method but `reuse`. That method needs more:
/// reuse_bytes() in addition if it makes a table of all pairs of patches, otherwise at least min_balanced_bytes() in
/// total. An empirical formula. Takes real numbers, since estimated sizes may exceed the integer types.
inline double run_bytes(double surfaces, double patches)
{
    constexpr double bytes_per_patch = 400; // line counts, or shading, or a mesh for output
    return bytes_per_surface * surfaces + bytes_per_patch * patches;
}

/// [bytes] Peak memory for making an interactive page with so many surfaces and patches: all quantities that the page
/// can show, each as numbers and as text. An empirical formula.
inline double page_bytes(double surfaces, double patches)
{
    constexpr double bytes_per_patch = 600;
    return bytes_per_surface * surfaces + bytes_per_patch * patches;
}

/// [bytes] Part of `memory` [bytes] that a run can use for pairs of patches: what run_bytes() leaves, at least 0.
inline double bytes_for_pairs(double memory, const Scene& scene)
{
    return std::max(0.0, memory - run_bytes(static_cast<double>(scene.surfaces().size()), scene.patch_count()));
}

} // namespace multipath

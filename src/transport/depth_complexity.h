#pragma once

#include "scene/scene.h"
#include "transport/lines/global_lines.h"

namespace multipath {

// Depth complexity: the number of surfaces along a line, or coincident at a point. The time and memory that a line
// takes grow with it.

/// Mean number of surfaces that a cast line crosses, by integral geometry (G1).
double crossings_per_line(const Scene& scene, const GlobalLines& lines);

/// Mean number of pairs of surfaces along a cast line, estimated with a few random lines. Deterministic.
double pairs_along_line(const Scene& scene, const GlobalLines& lines);

// The share [1] of the wanted lines that costs no more than all of them do in an ordinary scene: 1 in ordinary scenes,
// less where very many surfaces coincide or follow each other along a line. A global line is compared with all surfaces
// along it, a ray with all surfaces that coincide with its two ends.

/// Affordable share of global lines.
double affordable_lines(const Scene& scene);

/// Affordable share of rays from the sources.
double affordable_source_rays(const Scene& scene);

/// Affordable share of rays to every patch.
double affordable_patch_rays(const Scene& scene);

} // namespace multipath

#pragma once

#include "scene/scene.h"
#include "transport/lines/global_lines.h"

namespace multipath {

// How many surfaces lie behind each other, or on each other. The work and memory of a line grow with it.

/// Mean number of surfaces that a line meets, by integral geometry.
double crossings_per_line(const Scene& scene, const GlobalLines& lines);

/// Mean number of pairs of surfaces along a line, measured with a few random lines, always the same.
double pairs_along_line(const Scene& scene, const GlobalLines& lines);

// The share of lines, and of rays from the sources, and of rays to every patch that cost no more than all of them do in
// ordinary scenes: 1 in those. A line is compared with all surfaces along it, a ray with all that lie on its two ends.

double affordable_lines(const Scene& scene);
double affordable_source_rays(const Scene& scene);
double affordable_patch_rays(const Scene& scene);

} // namespace multipath

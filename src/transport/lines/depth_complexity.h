#pragma once

#include "scene/scene.h"
#include "transport/lines/global_lines.h"

namespace multipath {

// Depth complexity: the number of surfaces along a line, or coincident at a point. The time and memory that a line
// takes grow with the depth complexity.

/// Expected number of surfaces that a cast line crosses, by integral geometry ((G1) in docs/equations.md). Lines that
/// miss the scene count as cast.
double crossings_per_line(const Scene& scene, const GlobalLines& lines);

/// Mean number of pairs of surfaces along a cast line, estimated with 256 random lines, which are the same in every
/// call.
double pairs_along_line(const Scene& scene, const GlobalLines& lines);

// Affordable share: the fraction [1] of the wanted lines or rays that costs as much as all of them cost in an ordinary
// scene. It is 1 if a line or ray is compared with at most 16 surfaces on the average, else 16 over this number. The
// number is crossings_per_line() for global lines. For rays it is estimated with a few rays, which are the same in
// every call.

/// Affordable share of global lines, each of which is compared with all surfaces along the line.
double affordable_lines(const Scene& scene);

/// Affordable share of rays from the emitting surfaces. A ray is compared with the surfaces that coincide with its two
/// ends, and with all surfaces along the line if its start is covered. 1 if no surface emits.
double affordable_source_rays(const Scene& scene);

/// Affordable share of rays that are aimed at patches, equally many at each patch. A ray is compared with the surfaces
/// that coincide with its patch.
double affordable_patch_rays(const Scene& scene);

} // namespace multipath

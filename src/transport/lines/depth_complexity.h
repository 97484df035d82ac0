#pragma once

#include "scene/scene.h"
#include "transport/lines/global_lines.h"

#include <cstdint>

namespace multipath {

// Depth complexity: the number of surfaces along a line, with those that coincide. The time and memory that a line
// takes grow with it.

/// Expected number of surfaces that a cast line crosses, by integral geometry ((G1) in docs/equations.md). Lines that
/// miss the scene count as cast.
double crossings_per_line(const Scene& scene, const GlobalLines& lines);

/// Mean number of pairs of surfaces along a cast line, estimated with 256 random lines, which are the same in every
/// call.
double pairs_along_line(const Scene& scene, const GlobalLines& lines);

/// Mean number of pairs of surfaces along a line above which a scene is unusually deep: some 45 surfaces.
constexpr double many_pairs_along_line = 1024.0;

/// `wanted` lines or rays, but fewer in an unusually deep scene, in proportion to the pairs along a line: there a line
/// or ray is compared with very many surfaces that coincide or follow each other.
std::uint64_t affordable_lines(const Scene& scene, std::uint64_t wanted);

} // namespace multipath

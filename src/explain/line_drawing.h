#pragma once

#include "explain/stage_trace.h"

#include <string>
#include <vector>

namespace multipath {

/// Draws traced lines as SVG in two views side by side, from above and from the side, with the outlines of the scene.
/// Sources are yellow; a ring marks the start of a line, an arrowhead its end. Segments that join
/// two patches are solid, the others dashed. The hits of each line are numbered if there are at most eight lines. Lines
/// that are chords of the sphere around the scene are drawn with it. `up`: upward direction.
/// The comments go into the file, not into the picture.
std::string draw_lines(const TracedRun& run, const StageTrace& trace, Vec3 up,
                       const std::vector<std::string>& comments);

} // namespace multipath

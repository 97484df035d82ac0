#pragma once

#include "explain/line_trace.h"
#include "export/svg/line_drawing.h"

#include <vector>

namespace multipath {

// Traced lines (explain/line_trace.h) as lines of a drawing, in the order of the trace. A ray, also one of a particle
// or walk, is bold if it ends on a patch; the segment within the patch, from there to the start of the next ray, is not
// bold. A segment of a global line is bold if it joins two patches. A ray that leaves the scene is drawn for a fifth of
// the diagonal of the scene.

std::vector<DrawnLine> drawn_lines(const std::vector<GlobalLine>& lines);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const ShotTrace& trace);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const ParticleTrace& trace);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const WalkTrace& trace);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const JacobiTrace& trace);

} // namespace multipath

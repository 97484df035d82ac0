#pragma once

#include "explain/line_trace.h"
#include "export/svg/line_drawing.h"

#include <vector>

namespace multipath {

// Traced lines as lines of a drawing. Rays that leave the scene are drawn for a fifth of its diagonal.

std::vector<DrawnLine> drawn_lines(const std::vector<GlobalLine>& lines);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const ShotTrace& trace);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const ParticleTrace& trace);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const WalkTrace& trace);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const JacobiTrace& trace);

} // namespace multipath

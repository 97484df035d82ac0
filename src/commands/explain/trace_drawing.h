#pragma once

#include "explain/line_trace.h"
#include "export/svg/line_drawing.h"

#include <vector>

namespace multipath {

// The told lines as they are drawn. What leaves the scene is drawn a little way.

std::vector<DrawnLine> drawn_lines(const std::vector<GlobalLine>& lines);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const ShotTrace& trace);
std::vector<DrawnLine> drawn_lines(const Scene& scene, const ParticleTrace& trace);

} // namespace multipath

#pragma once

#include "explain/stage_trace.h"
#include "export/svg/line_drawing.h"

#include <vector>

namespace multipath {

/// The lines of a trace as lines of a drawing, in the same order. Segments that join two patches are bold.
std::vector<DrawnLine> drawn_lines(const StageTrace& trace);

} // namespace multipath

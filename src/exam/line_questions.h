#pragma once

#include "exam/exam_runs.h"

#include <vector>

namespace multipath {

/// Integral geometry: what global lines meet, how rays leave, and the form factors that both measure.
std::vector<ExamTask> line_tasks(const ExamSettings& settings);

} // namespace multipath

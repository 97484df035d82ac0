#pragma once

#include "exam/exam_runs.h"

#include <vector>

namespace multipath {

/// Single stages of the solver, by themselves: the first shot (S1) and the walk along global lines (M1) (M2).
std::vector<ExamTask> stage_tasks(const ExamSettings& settings);

} // namespace multipath

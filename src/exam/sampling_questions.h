#pragma once

#include "exam/exam_runs.h"

#include <vector>

namespace multipath {

/// Points of the sequences: their first numbers, how they fill elementary intervals, discrepancy, an integral.
std::vector<ExamTask> sampling_tasks(const ExamSettings& settings);

} // namespace multipath

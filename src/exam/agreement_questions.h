#pragma once

#include "exam/exam_runs.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Solves a scene of the user's with every method: power is neither gained nor lost, no patch radiates less than it
/// emits, and each method finds for every material what local Monte Carlo finds. The scene must outlive the tasks.
std::vector<ExamTask> agreement_tasks(const Scene& scene, const ExamSettings& settings);

} // namespace multipath

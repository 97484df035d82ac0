#pragma once

#include "exam/exam_runs.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Integral geometry on a scene of the user's: crossings of its lines, and what its largest surfaces send each other,
/// by rays from either and by global lines. The scene must outlive the tasks.
std::vector<ExamTask> surface_tasks(const Scene& scene, const ExamSettings& settings);

} // namespace multipath

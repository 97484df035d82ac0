#pragma once

#include "exam/exam_runs.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <vector>

namespace multipath {

/// All that is known without a scene of the user's: sequences, lines, rays, stages and methods.
std::vector<ExamTask> known_answer_tasks(const ExamSettings& settings);

/// What must hold in any scene: power balance, integral geometry, reciprocity, agreement of the methods. The scene must
/// outlive the tasks.
std::vector<ExamTask> scene_tasks(const Scene& scene, const ExamSettings& settings);

/// Without repetition, in the order of the tasks.
std::vector<std::string> topics_of(const std::vector<ExamTask>& tasks);

/// The tasks of some topics; of all if there are none.
std::vector<ExamTask> tasks_of(const std::vector<ExamTask>& tasks, const std::vector<std::string>& topics);

/// The rows of all tasks in their order, whatever the number of threads; `progress` is told the share done, 0 ... 1.
std::vector<ExamRow> take_exam(const std::vector<ExamTask>& tasks, int threads,
                               const std::function<void(double done)>& progress);

} // namespace multipath

#include "exam/exam.h"

#include "exam/agreement_questions.h"
#include "exam/line_questions.h"
#include "exam/method_questions.h"
#include "exam/sampling_questions.h"
#include "exam/stage_questions.h"
#include "exam/surface_questions.h"
#include "parallel/ordered_blocks.h"

#include <algorithm>
#include <utility>

namespace multipath {

std::vector<ExamTask> known_answer_tasks(const ExamSettings& settings)
{
    std::vector<ExamTask> tasks = sampling_tasks(settings);
    for (std::vector<ExamTask> more : {line_tasks(settings), stage_tasks(settings), method_tasks(settings)})
        for (ExamTask& task : more)
            tasks.push_back(std::move(task));
    return tasks;
}

std::vector<ExamTask> scene_tasks(const Scene& scene, const ExamSettings& settings)
{
    std::vector<ExamTask> tasks = surface_tasks(scene, settings);
    for (ExamTask& task : agreement_tasks(scene, settings))
        tasks.push_back(std::move(task));
    return tasks;
}

std::vector<std::string> topics_of(const std::vector<ExamTask>& tasks)
{
    std::vector<std::string> topics;
    for (const ExamTask& task : tasks)
        if (std::find(topics.begin(), topics.end(), task.topic) == topics.end())
            topics.push_back(task.topic);
    return topics;
}

std::vector<ExamTask> tasks_of(const std::vector<ExamTask>& tasks, const std::vector<std::string>& topics)
{
    std::vector<ExamTask> chosen;
    for (const ExamTask& task : tasks)
        if (topics.empty() || std::find(topics.begin(), topics.end(), task.topic) != topics.end())
            chosen.push_back(task);
    return chosen;
}

std::vector<ExamRow> take_exam(const std::vector<ExamTask>& tasks, int threads,
                               const std::function<void(double done)>& progress)
{
    std::vector<std::vector<ExamRow>> slots(static_cast<std::size_t>(slot_count(threads)));
    std::vector<ExamRow> rows;
    const auto take = [&](std::uint64_t number, int slot) {
        slots[static_cast<std::size_t>(slot)] = tasks[static_cast<std::size_t>(number)].rows();
    };
    const auto collect = [&](std::uint64_t number, int slot) {
        const std::vector<ExamRow>& part = slots[static_cast<std::size_t>(slot)];
        rows.insert(rows.end(), part.begin(), part.end());
        progress(static_cast<double>(number + 1) / static_cast<double>(tasks.size()));
    };
    ordered_blocks(tasks.size(), threads, take, collect);
    return rows;
}

} // namespace multipath

#include "cli/files/planned_outputs.h"
#include "cli/files/standard_streams.h"
#include "cli/options/number_text.h"
#include "cli/options/usage_error.h"
#include "cli/progress.h"
#include "cli/provenance.h"
#include "commands/commands.h"
#include "commands/options/scene_options.h"
#include "exam/exam.h"
#include "exam/exam_table.h"

#include <algorithm>
#include <optional>

namespace multipath {

namespace {

CommandTable selftest_table()
{
    return {"selftest",
            "an exam of the physics with known answers, or of what must hold in a scene",
            {{"SCENE.obj", false, true, {".obj"}}},
            {{"Exam",
              {{"output", 'o', "FILE", "", "Write the table as CSV too.", true},
               {"case", 0, "NAME", "",
                "Hold only this part of the exam, such as furnace or lines; of a scene surfaces or methods.", true},
               {"quiet", 'q', "", "", "Show only the rows that did not pass, and the last line."},
               {"progress", 0, "WHEN", "auto", "Show progress on stderr.", false, {"auto", "always", "never"}},
               {"seed", 0, "N", "1", "Chooses the random numbers; a right program passes with any."},
               threads_option(),
               {"break", 0, "LAW", "", "Break a law, to see that the exam fails.", false, broken_law_names, true}}},
             scene_option_group()},
            "Exit code 0: every row passed; 1: a row failed, which is WRONG or VAGUE.\n"};
}

/// A scene is examined with as many lines as its patches need, and fewer runs; its runs use the threads themselves.
ExamSettings settings_for(const Scene& scene, ExamSettings settings, int threads)
{
    settings.replicates = 16;
    settings.lines = std::min<std::uint64_t>(1 << 20, std::max<std::uint64_t>(1 << 16, 128ull * scene.patch_count()));
    settings.threads = threads;
    return settings;
}

ExamSettings read_exam_settings(const CommandLine& line)
{
    ExamSettings settings;
    settings.seed = read_count("--seed", line.text("seed"));
    if (line.has("break"))
        settings.broken = broken_law_named(line.text("break"));
    return settings;
}

/// The options of scenes have no use without one.
void require_scene_for_scene_options(const CommandLine& line)
{
    for (const Option& option : scene_option_group().options)
        if (line.operands().empty() && line.has(option.name))
            throw UsageError("--" + std::string(option.name) + " has no effect without SCENE.obj");
}

std::vector<ExamTask> chosen_tasks(const CommandLine& line, const std::vector<ExamTask>& tasks)
{
    const std::vector<std::string> topics = topics_of(tasks);
    for (const std::string& wanted : line.all("case"))
        require_choice("--case", wanted, {topics.begin(), topics.end()});
    return tasks_of(tasks, line.all("case"));
}

int run_selftest(const CommandLine& line)
{
    require_scene_for_scene_options(line);
    ExamSettings settings = read_exam_settings(line);
    int threads = thread_count(line);
    const std::vector<std::string> paths = line.all("output");
    const bool own_scene = !line.operands().empty();
    std::vector<PlannedOutput> outputs =
        open_outputs(paths, own_scene ? std::vector{scene_path(line)} : std::vector<std::string>{}, {".csv"});

    std::optional<Scene> scene;
    std::vector<std::string> comments = provenance(selftest_table(), line);
    if (own_scene) {
        scene.emplace(read_scene(line, threads));
        require_no_input(outputs, scene->file().material_files);
        comments = provenance(selftest_table(), line, *scene);
        settings = settings_for(*scene, settings, threads);
        threads = 1;
    }
    const std::vector<ExamTask> tasks =
        chosen_tasks(line, scene ? scene_tasks(*scene, settings) : known_answer_tasks(settings));
    std::vector<ExamRow> rows;
    {
        Progress progress("selftest", progress_style(line));
        rows = take_exam(tasks, threads, [&](double done) { progress.show(done); });
    }
    for (PlannedOutput& output : outputs)
        output.file.write(exam_csv(rows, comments));
    commit(outputs);
    if (std::find(paths.begin(), paths.end(), "-") == paths.end())
        print(exam_text(rows, line.has("quiet")));
    return failures(rows) == 0 ? 0 : 1;
}

} // namespace

Command selftest_command()
{
    return {selftest_table(), run_selftest};
}

} // namespace multipath

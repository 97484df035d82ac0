#include "base/platform/machine.h"
#include "base/text_format.h"
#include "cli/files/interrupt.h"
#include "cli/files/output_file.h"
#include "cli/files/standard_streams.h"
#include "cli/provenance.h"
#include "cli/version.h"
#include "commands/commands.h"
#include "commands/options/scene_options.h"
#include "commands/paper_steps.h"
#include "scene/obj/obj_reader.h"
#include "scene/tessellation.h"
#include "study/paper_report.h"
#include "study/study_table.h"

#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <string>

namespace multipath {

namespace {

/// Runs one step as if it had been typed, with its outputs in the folder.
void run_step(const PaperStep& step, const std::string& folder, const CommandLine& line)
{
    const Command command = command_named(step.words.front());
    std::vector<std::string> words(step.words.begin() + 1, step.words.end());
    for (const std::string& output : step.outputs)
        words.insert(words.end(), {"--output", folder + "/" + output});
    const auto add = [&](const char* option, const std::string& value) {
        if (find_option(command.table, option) == nullptr)
            return;
        words.push_back("--" + std::string(option));
        if (!value.empty())
            words.push_back(value);
    };
    add("quiet", "");
    add("cache", folder + "/cache");
    if (line.has("threads"))
        add("threads", line.text("threads"));
    command.run(CommandLine(command.table, words));
}

SceneFindings scene_findings(const std::string& name, const std::string& path, int threads)
{
    SceneFile file = read_obj(path);
    const double patch_size = default_patch_size(file.surfaces);
    const Scene scene(std::move(file), patch_size);
    return {name, scene.patch_count(), report_on(scene, report_lines, threads)};
}

/// The folder that --scenes names; or the bundled one if --scenes has its default and the working directory has no
/// folder with the scenes.
std::string scenes_folder(const CommandLine& line)
{
    const std::string given = line.text("scenes");
    const std::string bundled = bundled_scenes_folder();
    std::error_code error;
    const bool here = std::filesystem::exists(given + "/5cubes.obj", error);
    return here || given != line.default_text("scenes") || bundled.empty() ? given : bundled;
}

PaperFindings read_findings(const CommandLine& line, const std::string& scenes, const std::string& folder,
                            const std::vector<PaperStep>& steps)
{
    const int threads = thread_count(line);
    PaperFindings findings;
    findings.quick = line.has("quick");
    findings.five_cubes = scene_findings("5CUBES", scenes + "/5cubes.obj", threads);
    findings.four_chairs = scene_findings("4CHAIRS, lit downwards", scenes + "/4chairs.obj", threads);
    findings.four_chairs_up = scene_findings("4CHAIRS, lit upwards", scenes + "/4chairs-up.obj", threads);
    for (const PaperStep& step : steps)
        for (const std::string& output : step.outputs) {
            findings.commands[output] = typed(step);
            if (step.words.front() == "study" && output.substr(output.size() - 4) == ".csv")
                findings.studies[output.substr(0, output.size() - 4)] = read_study(folder + "/" + output);
        }
    return findings;
}

/// The current date (UTC), such as "2026-11-21".
std::string today()
{
    const std::time_t now = std::time(nullptr);
    std::array<char, 16> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", std::gmtime(&now));
    return text.data();
}

std::vector<std::string> facts(const CommandLine& line, double seconds, bool resumed)
{
    return {"program: " + version(), "threads: " + std::to_string(thread_count(line)), "date: " + today(),
            "time: " + format("%.0f s", seconds) + (resumed ? ", without the runs kept from before" : "")};
}

void write_file(const std::string& path, const std::string& text)
{
    OutputFile file(path);
    file.write(text);
    file.commit();
}

int run_paper(const CommandLine& line)
{
    const std::string folder = line.text("output");
    const bool quiet = line.has("quiet");
    const auto start = std::chrono::steady_clock::now();
    const std::string scenes = scenes_folder(line);
    const std::vector<PaperStep> steps = paper_steps(line.has("quick"), scenes, folder);
    always_end_at_interrupts();
    make_folder(folder);
    std::error_code error;
    const bool resumed = std::filesystem::exists(folder + "/cache", error);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (!quiet)
            print_note(format("[%zu/%zu] %s\n", k + 1, steps.size(), typed(steps[k]).c_str()));
        run_step(steps[k], folder, line);
    }
    PaperFindings findings = read_findings(line, scenes, folder, steps);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    findings.facts = facts(line, elapsed.count(), resumed);
    const Report report = paper_report(findings);
    const std::vector<std::string> comments = provenance(line);
    write_file(folder + "/results.md", report_markdown(report, comments));
    write_file(folder + "/index.html", report_html(report, folder, comments));
    if (!quiet) {
        print(claims_text(paper_claims(findings)));
        print_note(format("wrote      %s/index.html\n", folder.c_str()));
    }
    return 0;
}

} // namespace

Command paper_command()
{
    return {{"paper",
             "compute every table and figure of the paper from the bundled scenes, as one report",
             {},
             {{"Output",
               {{"output", 'o', "FOLDER", "paper",
                 "Folder for the report, index.html and results.md, its figures and tables as files, and the finished "
                 "runs, from which the command resumes."},
                {"quiet", 'q', "", "", "Print only errors."}}},
              {"Work",
               {{"quick", 0, "", "", "Fewer lines and executions: one minute instead of five on two processors."},
                {"scenes", 0, "FOLDER", "scenes",
                 "Folder with the scenes of the paper; if the default does not exist, the bundled ones."},
                threads_option()}}},
             "  multipath paper --quick -o paper && xdg-open paper/index.html\n"},
            run_paper};
}

} // namespace multipath

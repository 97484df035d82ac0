#include "base/text_format.h"
#include "cli/files/interrupt.h"
#include "cli/files/output_file.h"
#include "cli/files/standard_streams.h"
#include "cli/provenance.h"
#include "commands/commands.h"
#include "commands/options/scene_options.h"
#include "commands/paper_steps.h"
#include "study/paper_report.h"

#include <sstream>

namespace multipath {

namespace {

/// Runs one step as if it had been typed, with its outputs in the folder, and adds what it finds.
void run_step(const std::string& step, const std::string& folder, const CommandLine& line, PaperFindings& findings)
{
    std::istringstream text(step);
    std::string name;
    text >> name;
    const Command command = command_named(name);
    std::vector<std::string> words;
    std::string output;
    for (std::string word; text >> word; words.push_back(word))
        if (!words.empty() && words.back() == "-o") {
            output = word;
            findings.commands[word] = "multipath " + step;
            word = folder + "/" + word;
        } else if (word.rfind("FOLDER/", 0) == 0) {
            word.replace(0, 6, folder);
        }
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
    const CommandLine step_line(command.table, words);
    if (name == "study")
        findings.studies[output.substr(0, output.rfind('.'))] = study_of(step_line);
    else
        command.run(step_line);
}

/// The figures of a bundled scene, as `check` measures them.
SceneFindings scene_findings(const std::string& title, const std::string& name, int threads)
{
    const Scene scene = read_scene(CommandLine(check_command().table, {name}), threads);
    return {title, scene.patch_count(), report_on(scene, report_lines, threads)};
}

int run_paper(const CommandLine& line)
{
    const std::string folder = line.text("output");
    const bool quiet = line.has("quiet");
    const int threads = thread_count(line);
    const std::vector<std::string> steps = paper_steps(line.has("quick"));
    always_end_at_interrupts();
    make_folder(folder);
    PaperFindings findings;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        if (!quiet)
            print_note(format("[%zu/%zu] multipath %s\n", k + 1, steps.size(), steps[k].c_str()));
        run_step(steps[k], folder, line, findings);
    }
    findings.five_cubes = scene_findings("5CUBES", "5cubes", threads);
    findings.four_chairs = scene_findings("4CHAIRS, lit downwards", "4chairs", threads);
    findings.four_chairs_up = scene_findings("4CHAIRS, lit upwards", "4chairs-up", threads);
    OutputFile page(folder + "/index.html");
    page.write(paper_report(findings, folder, provenance(line)));
    page.commit();
    if (!quiet)
        print_note(format("wrote      %s/index.html\n", folder.c_str()));
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
                 "Folder for the report, index.html, its figures and tables as files, and the finished runs, from "
                 "which the command resumes."},
                {"quiet", 'q', "", "", "Print only errors."}}},
              {"Work",
               {{"quick", 0, "", "", "Fewer lines and executions: one minute instead of five on two processors."},
                threads_option()}}},
             "  multipath paper --quick -o paper && xdg-open paper/index.html\n"},
            run_paper};
}

} // namespace multipath

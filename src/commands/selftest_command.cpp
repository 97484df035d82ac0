#include "base/errors.h"
#include "base/lists.h"
#include "cli/files/output_file.h"
#include "cli/files/standard_streams.h"
#include "cli/options/number_text.h"
#include "cli/progress.h"
#include "cli/provenance.h"
#include "commands/commands.h"
#include "commands/options/scene_options.h"
#include "selftest/selftest.h"

#include <algorithm>
#include <optional>

namespace multipath {

namespace {

/// Throws UsageError for options without effect: scene options without SCENE.obj, --case with it.
void require_effect(const CommandLine& line)
{
    if (!line.operands().empty()) {
        if (line.has("case"))
            throw UsageError("--case has no effect with SCENE.obj");
        return;
    }
    for (const Option& option : scene_option_group().options)
        if (line.has(option.name))
            throw UsageError("--" + std::string(option.name) + " has no effect without SCENE.obj");
}

/// The known scenes that --case names, or all of them.
std::vector<KnownScene> chosen_scenes(const CommandLine& line)
{
    const std::vector<KnownScene> all = known_scenes();
    std::vector<KnownScene> chosen;
    for (const std::string& name : line.all("case"))
        chosen.push_back(row_named(all, "--case", name));
    return line.has("case") ? chosen : all;
}

int run_selftest(const CommandLine& line)
{
    require_effect(line);
    SelftestSettings settings;
    settings.seed = read_count("--seed", line.text("seed"));
    settings.threads = thread_count(line);
    const std::vector<KnownScene> known = chosen_scenes(line);
    const std::vector<std::string> paths = line.all("output");
    const bool own_scene = !line.operands().empty();
    std::vector<PlannedOutput> outputs =
        open_outputs(paths, own_scene ? std::vector{scene_path(line)} : std::vector<std::string>{}, {".csv"});

    std::optional<Scene> scene;
    std::vector<std::string> comments = provenance(line);
    if (own_scene) {
        scene.emplace(read_scene(line, settings.threads));
        require_no_input(outputs, input_files(scene->file()));
        comments = provenance(line, *scene);
        settings.replicates = 16; // fewer runs than for the known scenes
        settings.lines = std::clamp<std::uint64_t>(128ull * scene->patch_count(), 1 << 16, 1 << 20);
    }
    std::vector<Check> checks;
    {
        Progress progress("selftest", progress_style(line));
        checks = scene ? scene_checks(*scene, settings, std::ref(progress))
                       : known_scene_checks(known, settings, std::ref(progress));
    }
    for (PlannedOutput& output : outputs)
        output.file.write(checks_csv(checks, comments));
    commit(outputs);
    if (!is_among("-", paths))
        print(checks_text(checks, line.has("quiet")));
    return SignificanceTest(checks).failures() == 0 ? 0 : 1;
}

} // namespace

Command selftest_command()
{
    return {{"selftest",
             "check every method against known answers, or against each other in a scene",
             {"[SCENE.obj]", 0, 1},
             {{"Selftest",
               {{"output", 'o', "FILE", "", "Also write the table as CSV.", true},
                {"case", 0, "NAME", "", "Check only this known scene, such as furnace.", true},
                {"quiet", 'q', "", "", "Show only the checks that did not pass, and the last line."},
                {"seed", 0, "N", "1", "Seed of the random numbers; a correct program passes with any seed."},
                threads_option()}},
              scene_option_group()},
             "Exit code 0: every check passed; 1: a check failed, as WRONG or INCONCLUSIVE.\n"},
            run_selftest};
}

} // namespace multipath

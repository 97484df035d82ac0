#include "cli/interrupt.h"
#include "cli/planned_outputs.h"
#include "cli/provenance.h"
#include "cli/shell_words.h"
#include "cli/standard_streams.h"
#include "cli/usage_error.h"
#include "commands/commands.h"
#include "commands/recorded_command.h"
#include "commands/rerun.h"
#include "commands/result_difference.h"
#include "commands/scene_options.h"
#include "export/file_bytes.h"
#include "scene/obj_reader.h"
#include "scene/text_format.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <unistd.h>
#include <vector>

namespace multipath {

namespace {

CommandTable reproduce_table()
{
    return {"reproduce",
            "run the command in a file's header again, and compare",
            {{"FILE"}},
            {{"Output",
              {{"keep", 0, "FILE", "", "Leave the new file here. Without it, nothing is left."},
               {"quiet", 'q', "", "", "Print nothing on stderr but errors."}}},
             {"Work", {threads_option()}}},
            "FILE is what 'multipath' wrote: a CSV, SVG, PNG, PPM, PLY, GLB, OBJ or HTML, such as the\n"
            "index.html of 'multipath paper'. The paths in its record start in the folder where its command\n"
            "was run: run this one there too.\n"
            "Exit code 0: the same result; times and dates may differ. 1: another result, or none.\n"
            "\n"
            "  multipath explain scenes/5cubes.obj -o lines.svg && multipath reproduce lines.svg\n"};
}

/// Both files and what they say of themselves.
struct Reproduction
{
    std::string path;
    std::string then;
    std::string now;
    RecordedCommand record;
    RecordedCommand new_record;
};

std::string then_and_now(const std::string& then, const std::string& now)
{
    const auto shown = [](const std::string& text) { return text.empty() ? "unknown" : quoted_argument(text); };
    return ": then " + shown(then) + ", now " + shown(now);
}

/// Differences of the records that need not change the result.
std::vector<std::string> other_writing(const Reproduction& r)
{
    std::vector<std::string> remarks;
    if (r.record.version != r.new_record.version)
        remarks.push_back("another version" + then_and_now(r.record.version, r.new_record.version));
    if (r.record.words != r.new_record.words)
        remarks.push_back("its command is now written " + shell_text(r.new_record.words));
    return remarks;
}

/// Why the result could not be the same, whatever the program does.
std::vector<std::string> other_inputs(const Reproduction& r)
{
    std::vector<std::string> reasons;
    if (r.record.scene != r.new_record.scene)
        reasons.push_back("the scene has changed" +
                          then_and_now(r.record.scene.value_or(""), r.new_record.scene.value_or("")));
    if (r.record.seed != r.new_record.seed)
        reasons.push_back("another seed" + then_and_now(r.record.seed.value_or(""), r.new_record.seed.value_or("")));
    return reasons;
}

/// For a result that depends on how fast the machine is.
std::string dependence_on_time(const RecordedCommand& record)
{
    const auto at = [&](const char* word) { return std::find(record.words.begin(), record.words.end(), word); };
    if (at("--time") != record.words.end())
        return "it took as many lines as its time allowed (--time), so that it cannot be compared exactly";
    const auto against = at("--against");
    const bool seconds = against != record.words.end() && against + 1 != record.words.end() && against[1] == "seconds";
    if (seconds && record.kind == RecordedFile::drawing)
        return "it has seconds across (--against seconds), which differ from run to run: it cannot be compared exactly";
    return "";
}

void print_verdict(const std::string& path, const std::string& verdict, const std::vector<std::string>& remarks)
{
    std::string text = path + ": " + verdict;
    for (const std::string& remark : remarks)
        text += (remarks.size() == 1 ? ": " : "\n  ") + remark;
    print(text + "\n");
}

/// Prints what came out; returns the exit code.
int judge(const Reproduction& r)
{
    if (r.then == r.now) {
        print_verdict(r.path, "reproduced, the same " + grouped(r.now.size()) + " bytes", {});
        return 0;
    }
    std::vector<std::string> reasons = other_inputs(r);
    const std::string by_time = dependence_on_time(r.record);
    const ResultDifference difference =
        by_time.empty() ? result_difference(r.record.kind, r.then, r.now, r.path) : ResultDifference{by_time};
    const std::vector<std::string> remarks = other_writing(r);
    if (reasons.empty() && difference.text.empty()) {
        const bool only_writing = !difference.only_times && remarks.empty();
        print_verdict(r.path,
                      difference.only_times ? "reproduced; times differ, as they do from run to run"
                      : only_writing        ? "reproduced; the files differ only in how the same is written"
                                            : "reproduced, apart from its record",
                      remarks);
        return 0;
    }
    if (!difference.text.empty())
        reasons.push_back(difference.text);
    reasons.insert(reasons.end(), remarks.begin(), remarks.end());
    print_verdict(r.path, "not reproduced", reasons);
    return 1;
}

/// Files that exist, with the materials of scenes.
std::vector<std::string> inputs_among(const std::vector<std::string>& words)
{
    std::vector<std::string> inputs;
    for (const std::string& word : words) {
        if (access(word.c_str(), F_OK) != 0)
            continue;
        inputs.push_back(word);
        if (word.size() > 4 && word.compare(word.size() - 4, 4, ".obj") == 0)
            for (const std::string& material : read_obj(word).material_files)
                inputs.push_back(material);
    }
    return inputs;
}

/// Open already. `words` are those of the recorded command, among them its inputs.
std::optional<OutputFile> file_to_keep(const CommandLine& line, const std::vector<std::string>& words)
{
    if (!line.has("keep"))
        return std::nullopt;
    const std::string keep = line.text("keep");
    if (keep == "-")
        throw UsageError("--keep: standard output tells what came out; expected a file");
    if (same_file(keep, line.operands()[0]))
        throw UsageError("--keep: " + quoted_argument(keep) + " is the file to compare with; expected another file");
    if (access(keep.c_str(), F_OK) == 0)
        for (const std::string& input : inputs_among(words))
            if (same_file(keep, input))
                throw UsageError("--keep: " + quoted_argument(keep) +
                                 " is an input of the command; expected another file");
    return OutputFile(keep);
}

int run_reproduce(const CommandLine& line)
{
    const std::string path = line.operands()[0];
    const std::optional<std::string> threads =
        line.has("threads") ? std::optional(std::to_string(thread_count(line))) : std::nullopt;
    const std::string then = bytes_of_file(path);
    const RecordedCommand record = read_recorded_command(then, path);
    always_end_at_interrupts();
    std::optional<OutputFile> keep = file_to_keep(line, record.words);
    if (!line.has("quiet"))
        print_note(format("running    multipath %s\n", shell_text(record.words).c_str()));
    const std::string now = run_again(record, path, threads);
    if (keep) {
        keep->write(now);
        keep->commit();
        if (!line.has("quiet"))
            print_note(format("wrote      %s\n", keep->name().c_str()));
    }
    return judge({path, then, now, record, read_recorded_command(now, "the new file")});
}

} // namespace

Command reproduce_command()
{
    return {reproduce_table(), run_reproduce};
}

} // namespace multipath

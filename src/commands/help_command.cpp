#include "base/errors.h"
#include "base/text_format.h"
#include "cli/files/standard_streams.h"
#include "commands/commands.h"
#include "commands/solve/formats.h"
#include "radiosity/run/methods.h"
#include "sampling/sequence.h"

namespace multipath {

namespace {

constexpr const char* scenes_text = R"(A scene is a Wavefront OBJ file; mtllib names the MTL file of its materials.

  Kd r g b   diffuse reflectance, 0 to 1; one number is grey
  Ke r g b   emittance in W/m^2: power emitted per area
  map_Kd F   texture (PNG, JPEG, TGA, BMP or PPM), times Kd; -s, -o, -clamp
  map_Ke F   the same, times Ke; its surfaces emit the mean over all of them
Everything else is ignored, and reported once. A material that no file defines
is grey with reflectance 0.5, with a warning. A scene that emits nothing is
refused.

The front of a face is the side from which its corners run counter-clockwise.
Only fronts reflect, emit and receive light, unless --two-sided gives every
surface a back, which does not emit. Light that meets a back from behind is
lost, and the loss is reported. A closed shell that light meets only from behind
is turned over, with a message; so are all faces that do not emit if no front is
lit. --flip turns all faces over instead.

Surfaces are cut into patches of constant radiosity. --patch-size sets the
longest edge of a patch in metres, --patches the largest number of patches.
Without either, 'solve' cuts them where the light changes, into 5,000 patches
and five more for every four surfaces; other commands make a few thousand
patches of equal size.

A bare name that is not a file here, such as 5cubes, is a bundled scene.
)";

constexpr const char* states_text = R"(A state is one file that holds a whole run: the scene, the options, the progress
and the results so far. Ctrl-C leaves it complete. A later run resumes from it,
and writes the same bytes as a run that was never interrupted.

Resume after an interruption, or with more lines:
  multipath solve room.obj --lines 2^30 --state room.state --resume
Make other pictures, meshes and tables of a finished run, without the OBJ file:
  multipath render room.state --eye 1,1,5 --target 2,1,0 -o door.png
Split a run among computers, which need no connection to each other:
  multipath solve room.obj --shard 1/2 --state 1.state
  multipath solve room.obj --shard 2/2 --state 2.state
  multipath merge 1.state 2.state -o room.png -o room.csv

An existing state is replaced only with --resume, and only by a later state of
the same run; --from-state reads one without changing it.
)";

constexpr const char* exit_codes_text = R"(  0    success: everything that was asked for has been written
  1    the input or the work failed, as with a scene that cannot be read or a
       full disk; or check, selftest or compare --tolerance found a fault
  2    wrong usage: an unknown command, option, value or extension of an output
  130  interrupted (Ctrl-C): solve and merge write their results so far, unless
       interrupted again; other commands write nothing

An error is one line on standard error, which says what was expected. Of several
outputs, none gets its name before all are on the disk.
)";

std::string methods_text()
{
    std::string text = "Methods to compute the light of a scene, --method NAME:\n\n";
    for (const Method method : all_methods())
        text += two_columns("  " + std::string(method->name), std::string(method->summary), 21);
    return text + "\nTheir cost is counted in lines (--lines), rays from patches and global lines\n"
                  "together. 'multipath study' measures the error of each against the number of\n"
                  "lines.\n";
}

std::string sequences_text()
{
    std::string text = "Sequences of items, four numbers in [0, 1) for each line, --sequence NAME:\n\n";
    for (const SequenceKind& kind : sequence_kinds())
        text += two_columns("  " + std::string(kind.name) + std::string(kind.arguments), kind.summary, 28);
    return text + "\nBASES are coprime numbers, one for each dimension, as in halton:2,7,3,5; N is a\n"
                  "count, as in hammersley:65536. --seed is the seed of random and randomised\n"
                  "sequences (shifted, scrambled, permuted, from a random start); --skip K leaves\n"
                  "out the first K items. --replicates takes the randomised form of a sequence.\n"
                  "The number of lines should be a power of two for those of Sobol.\n\n"
                  "'multipath points' draws sequences and measures how evenly they fill space.\n";
}

std::string outputs_text()
{
    std::string text = "-o FILE may be repeated; the extension of the file determines its format:\n\n";
    const auto row = [](std::string_view extension, std::string_view summary) {
        return two_columns("  " + std::string(extension), summary, 10);
    };
    for (const OutputFormat& format : output_formats())
        text += row(format.name, format.summary);
    return text +
           "\nsolve, render and merge write these formats. selftest writes .csv files, study\n"
           "and points .csv and .svg files, explain .svg files:\n\n" +
           row(".svg", "plot or drawing") +
           "\n'-' is standard output. Formats that can hold text record the command that made\n"
           "them: run it again and compare the files with 'cmp'.\n";
}

int run_help(const CommandLine& line)
{
    const std::vector<CommandTable> tables = tables_of(commands());
    std::vector<HelpTopic> topics = help_topics();
    if (line.has("man") && !line.operands().empty())
        throw UsageError("a topic and --man exclude each other; expected one of them");
    if (line.has("man")) {
        print(man_page(tables, topics));
    } else if (line.operands().empty()) {
        print(program_help(tables, topics));
    } else {
        for (const CommandTable& table : tables)
            topics.push_back({table.name, help_text(table)});
        print(row_named(topics, "TOPIC", line.operands()[0]).text);
    }
    return 0;
}

} // namespace

std::vector<HelpTopic> help_topics()
{
    return {{"scenes", scenes_text},     {"methods", methods_text()}, {"sequences", sequences_text()},
            {"outputs", outputs_text()}, {"states", states_text},     {"exit-codes", exit_codes_text}};
}

Command help_command()
{
    return {{"help",
             "explain a command or a topic, or print the manual",
             {"[TOPIC]", 0, 1},
             {{"For installation", {{"man", 0, "", "", "Print the manual page, for 'man'."}}}},
             "  multipath help scenes\n"},
            run_help};
}

} // namespace multipath

#include "cli/files/standard_streams.h"
#include "cli/options/help_text.h"
#include "cli/options/usage_error.h"
#include "commands/commands.h"
#include "commands/options/method_options.h"
#include "commands/solve/formats.h"
#include "sampling/sequence.h"
#include "scene/text/text_format.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace multipath {

namespace {

constexpr std::size_t topic_width = 80; ///< [columns]

constexpr const char* scenes_text = R"(A scene is a Wavefront OBJ file; mtllib names the MTL file of its materials.

  Kd r g b   diffuse reflectance, 0 to 1; one number is grey
  Ke r g b   emittance in W/m^2: power emitted per area
  Ka r g b   ambient light, ignored; the emittance with --emission-from Ka
  map_Kd F   texture: PNG, JPEG, TGA, BMP or PPM, times Kd; with -s, -o, -clamp
  map_Ke F   likewise times Ke; a lamp emits the mean of its surfaces
Everything else (Ks, Ns, d, illum, ...) is ignored, and said once. A material
that faces use and no file defines becomes grey 0.5, with a warning. A scene
that emits nothing is refused.

The front of a face is the side from which its corners run counter-clockwise.
Only fronts reflect, emit and receive, unless --two-sided gives every surface a
back, which does not emit. So solids look outward and the room looks inward;
light that meets a surface from behind is lost, and counted. --flip turns all
faces over, for a room that was modelled to be seen from outside.

A quad that is a parallelogram is one surface, and so are two triangles that
form one. Other polygons are cut into triangles. Faces without an area are
dropped, and counted. Of two faces in one place that look the same way the
smaller hides the larger.

Surfaces are cut into patches of constant radiosity: --patch-size is the longest
edge of one in metres, --patches how many there may be. Without either,
'solve' cuts them where the light changes, 5,000 and five for every four
surfaces, and other commands take some thousand equal ones.

'multipath check SCENE.obj' tells what was read and what is suspicious about it:
WRONG is what concerns half a percent of the power, or of the area, and more.

A bare name that is no file here, such as 5cubes, is a scene that came with the
program: of share/multipath/scenes beside the folder of the installed program,
or of the folder 'scenes' beside one that was built from sources.
)";

constexpr const char* numbers_text = R"(Counts are written 1000000, 1e6, 1M or 2^20 (k, M, G are powers of 1000), exact
up to 2^63. Decimals have a point, in every locale: 0.5, .5, 5e-1.

  count           --lines 2^22        a whole number
  share           --tolerance 1%      or 0.01; a bare 1 is refused, since it
                                      could be 1 % or everything
  time            --time 90s          250ms, 90s, 5m, 2h; without unit: seconds
  size of memory  --memory 2GB        512MB, 2GB, 1GiB; without unit: bytes
  point           --eye 1,2.5,-3      x,y,z in metres, without blanks
  picture         --size 800x600      width and height in pixels
  part            --shard 3/16        the third of sixteen

Anything else is refused: nan, inf, decimal commas, trailing text, negative
numbers where they make no sense.
)";

constexpr const char* states_text = R"(A state is one file that holds the whole run: scene, options, how far it is and
what it has found. Ctrl-C leaves it complete; a later run goes on from it with
the same bytes as a run that was never interrupted.

Go on after an interruption, or to more lines:
  multipath solve room.obj --lines 2^28 --state room.state
  multipath solve room.obj --lines 2^28 --state room.state --resume
  multipath solve room.obj --lines 2^30 --state room.state --resume

Other pictures, meshes and tables of a finished run, without the OBJ file:
  multipath render room.state --eye 1,1,5 --target 2,1,0 -o door.png
  multipath compare room.state other.csv

Share a run among machines, which need not know each other:
  multipath solve room.obj --shard 1/2 --state 1.state
  multipath solve room.obj --shard 2/2 --state 2.state
  multipath merge 1.state 2.state -o room.png -o room.csv

A state is replaced only with --resume, and only by a later one of the same run.
--save-every says how often it is saved; --from-state reads one without touching
it. With --method reuse shards give the bytes of one run; those of the other
methods are averaged.
)";

constexpr const char* exit_codes_text = R"(  0    done: all that was asked for is written
  1    the input or the work failed: a scene that cannot be read, a full disk;
       also what check, selftest and compare --tolerance find wrong
  2    wrong usage: an unknown command, option, value or extension of an output
  130  interrupted (Ctrl-C); what solve and merge found until then is written
       as far as two seconds suffice, of anything else nothing

Errors are one line on standard error, which says what was expected. Results go
to files and standard output, everything else to standard error. An output is
complete or not there: of several none is put into place before all are on the
disk.
)";

std::string methods_text()
{
    std::string text = "How the light of the scene is found, --method NAME:\n\n";
    for (const Method method : all_methods())
        text += two_columns("  " + std::string(method->name), std::string(method->summary), 21, topic_width);
    return text + "\nWhat they cost is counted in lines, --lines: rays from patches and global lines\n"
                  "together. 'multipath study' measures the error of each against lines.\n";
}

std::string sequences_text()
{
    std::string text = "Where the lines come from: items of four numbers in [0, 1), --sequence NAME:\n\n";
    std::vector<std::string> best_at_powers;
    for (const SequenceKind& kind : sequence_kinds()) {
        const std::string name = std::string(kind.name) + std::string(kind.arguments);
        text += two_columns("  " + name, kind.summary, 28, topic_width);
        if (kind.fills_best_at_powers_of_two)
            best_at_powers.emplace_back(kind.name);
    }
    return text +
           "\nBASES are coprime numbers, one for each dimension, as in halton:2,7,3,5; N is a\n"
           "count, as in hammersley:2^16. --seed chooses among the random and randomised\n"
           "ones (shifted, scrambled, permuted, from a random start); --skip K leaves out\n"
           "the first K items. --replicates takes the randomised form of a sequence.\n" +
           wrapped_text("Numbers of lines that are a power of two suit " + join(best_at_powers) + ".", 0, 0,
                        topic_width) +
           "\n"
           "'multipath points' draws them and measures how evenly they fill space.\n";
}

std::string outputs_text()
{
    std::string text = "-o FILE, any number of times; the extension says what is written:\n\n";
    const auto row = [](std::string_view extension, std::string_view summary) {
        return two_columns("  " + std::string(extension), summary, 10, topic_width);
    };
    for (const OutputFormat& format : output_formats())
        text += row(format.extension, format.summary);
    return text +
           "\nThese are what solve, render and merge write. selftest writes a .csv, study and\n"
           "points a .csv or what explain writes:\n\n" +
           row(".svg", "plot or drawing") +
           "\n'-' is standard output. A file takes its name when it is complete; until then an\n"
           "old one stays as it is. Formats with a place for text hold the command that made\n"
           "them: run it again and compare the files with 'cmp'.\n";
}

CommandTable help_table(const std::vector<CommandTable>& others)
{
    CommandTable table = {"help",
                          "a command or a topic in words; the manual and the completion for bash",
                          {{"TOPIC", false, true}},
                          {{"For installation",
                            {{"man", 0, "", "", "Print the manual page, for 'man'."},
                             {"completion",
                              0,
                              "SHELL",
                              "",
                              "Print the script that lets a shell complete commands, options, their values and files.",
                              false,
                              {"bash"}}}}},
                          "  multipath help scenes\n"
                          "  multipath help solve\n"
                          "  . <(multipath help --completion bash)\n"};
    for (const CommandTable& other : others)
        table.operands[0].choices.push_back(other.name);
    table.operands[0].choices.push_back(table.name);
    for (const HelpTopic& topic : help_topics())
        table.operands[0].choices.push_back(topic.name);
    return table;
}

/// The help of a command, or the text of a topic. One of them must have this name.
std::string explanation(const std::string& name, const std::vector<CommandTable>& tables,
                        const std::vector<HelpTopic>& topics)
{
    for (const CommandTable& table : tables)
        if (table.name == name)
            return help_text(table);
    return std::find_if(topics.begin(), topics.end(), [&](const HelpTopic& topic) { return topic.name == name; })->text;
}

int run_help(const CommandLine& line)
{
    const std::vector<CommandTable> tables = tables_of(commands());
    const std::vector<HelpTopic> topics = help_topics();
    const bool shell_given = line.has("completion");
    if (line.operands().size() + (line.has("man") ? 1 : 0) + (shell_given ? 1 : 0) > 1)
        throw UsageError("a topic, --man and --completion exclude each other; expected one of them");
    if (line.has("man"))
        print(man_page(tables, topics));
    else if (shell_given)
        print(bash_completion(tables));
    else if (line.operands().empty())
        print(program_help(tables, topics));
    else
        print(explanation(line.operands()[0], tables, topics));
    return 0;
}

} // namespace

std::vector<HelpTopic> help_topics()
{
    return {{"scenes", "what is read from OBJ and MTL files", scenes_text},
            {"methods", "how the light is found", methods_text()},
            {"sequences", "where the lines come from", sequences_text()},
            {"numbers", "how numbers, sizes and times are written", numbers_text},
            {"outputs", "formats of files by their extension", outputs_text()},
            {"states", "going on, sharing a run among machines, other pictures", states_text},
            {"exit-codes", "what the program returns", exit_codes_text}};
}

Command help_command(const std::vector<Command>& others)
{
    return {help_table(tables_of(others)), run_help};
}

} // namespace multipath

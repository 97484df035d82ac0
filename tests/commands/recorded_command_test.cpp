#include "commands/recorded_command.h"

#include "cli/provenance.h"
#include "commands/commands.h"
#include "export/glb.h"
#include "export/mesh_scenes.h"
#include "export/obj_colours.h"
#include "export/ply.h"
#include "export/svg_plot.h"
#include "image/png.h"
#include "image/ppm.h"
#include "scene/input_error.h"
#include "study/report.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace recorded_command_test {

using namespace multipath;

namespace {

using Words = std::vector<std::string>;

const Words odd_words = {"solve", "my room; seed: 9.obj", "--sequence", "it's <b> & \"c\"; scene: 1", "--up=0,1,0"};
const Words odd_facts = {"multipath 0.1.0",
                         "command: multipath solve 'my room; seed: 9.obj' --sequence 'it'\\''s <b> & \"c\"; scene: 1' "
                         "--up=0,1,0",
                         "seed: 7", "scene: 0123456789abcdef"};

std::string joined(const Words& facts)
{
    std::string text;
    for (const std::string& fact : facts)
        text += (text.empty() ? "" : "; ") + fact;
    return text;
}

std::string table_of(const Words& facts)
{
    std::string text;
    for (const std::string& fact : facts)
        text += "# " + fact + "\n";
    return text + "a,b\n1,2\n";
}

const ScreenImage pixel = {1, 1, {1, 2, 3}};

void check_odd_record(const std::string& bytes, RecordedFile kind)
{
    const RecordedCommand record = read_recorded_command(bytes, "file");
    CHECK(record.kind == kind);
    CHECK(record.version == "multipath 0.1.0");
    CHECK(record.words == odd_words);
    CHECK(record.seed == "7");
    CHECK(record.scene == "0123456789abcdef");
}

/// What is wrong with a file.
std::string problem(const std::string& bytes)
{
    try {
        (void)read_recorded_command(bytes, "file");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

Command command_named(const std::string& name)
{
    for (const Command& command : commands())
        if (command.table.name == name)
            return command;
    throw std::out_of_range(name);
}

CommandLine recorded_line(const CommandTable& table, const CommandLine& line)
{
    const Words words = read_recorded_command(table_of(provenance(table, line)), "file").words;
    return {table, {words.begin() + 1, words.end()}};
}

} // namespace

TEST_CASE("every kind of file gives back what it was told of its command")
{
    check_odd_record(table_of(odd_facts), RecordedFile::table);
    check_odd_record(ppm_bytes(pixel, joined(odd_facts)), RecordedFile::ppm);
    check_odd_record(png_bytes(pixel, joined(odd_facts)), RecordedFile::png);
    check_odd_record(svg_head(10, 10, "command: no <desc>", odd_facts) + svg_end(), RecordedFile::drawing);
    check_odd_record(report_html({ReportParagraph{"text"}}, "", odd_facts), RecordedFile::report);
}

TEST_CASE("meshes give it back too")
{
    const Scene scene = walls_that_do_not_match().scene(4.0);
    const std::vector<Rgb> radiosity = some_values(scene);
    const PatchMesh mesh = patch_mesh(scene, flat_corners(radiosity), {});
    const ScreenColour colour = [](Rgb value) { return value; };
    check_odd_record(ply_bytes(mesh, radiosity, colour, odd_facts), RecordedFile::ply);
    check_odd_record(obj_text(mesh, scene, colour, odd_facts), RecordedFile::obj);
    Words with_brackets = odd_facts;
    with_brackets.insert(with_brackets.begin(), "a \\ and [a] \"]\"");
    const std::string glb = glb_bytes(mesh, scene, 1.0, with_brackets);
    check_odd_record(glb, RecordedFile::glb);
    for (std::size_t length : {std::size_t{4}, glb.find("]\\\""), glb.find("seed")})
        CHECK(problem(glb.substr(0, length)).find("file: no record") == 0);
    CHECK(problem("ply\n").find("file: no record") == 0);
    CHECK(problem("ply\ncomment command: multipath x").find("file: no record") == 0);
    CHECK(problem("# one\nv 0 0 0\n").find("file: no record") == 0);
}

TEST_CASE("line ends of another system do not matter")
{
    std::string table = table_of(odd_facts);
    for (std::size_t at = table.find('\n'); at != std::string::npos; at = table.find('\n', at + 2))
        table.insert(at, "\r");
    check_odd_record(table, RecordedFile::table);
}

TEST_CASE("version, seed and scene may be missing, the command may not")
{
    const RecordedCommand record = read_recorded_command("# command: multipath points\nn\n", "file");
    CHECK(record.words == Words{"points"});
    CHECK(record.version.empty());
    CHECK_FALSE(record.seed);
    CHECK_FALSE(record.scene);
    for (const std::string& bytes :
         {std::string(), std::string("n\n1\n# command: multipath points\n"), table_of({"seed: 1"}), ppm_bytes(pixel),
          png_bytes(pixel), svg_head(1, 1, "", {}), std::string("<svg "), std::string("\x89PNG\r\n\x1a\n"),
          std::string("P6\n"), std::string("P6\n#"), std::string("<!DOCTYPE html><meta name=\"multipath\" content=\""),
          std::string("#")})
        CHECK(problem(bytes).find("file: no record of a multipath command") == 0);
    CHECK(problem("PF\n1 1\n-1\n").find("file: a PFM keeps no record") == 0);
}

TEST_CASE("another program's command is refused in one line")
{
    for (const char* command : {"rm -rf /", "multipath", "", "'multipath solve'", "multipathsolve x"})
        CHECK(problem(table_of({"command: " + std::string(command)})).find("file: expected a multipath command") == 0);
    for (const char* command : {"multipath solve x; rm x", "multipath solve 'x", "multipath solve $(x)"})
        CHECK(problem(table_of({"command: " + std::string(command)})).find("file: expected a command of plain") == 0);
    CHECK(problem("# command: \x1b[2J\n").find('\x1b') == std::string::npos);
}

TEST_CASE("operands and values that look like options are recorded so that they are read as what they are")
{
    const CommandTable table = command_named("study").table;
    for (const Words& words : {Words{"--reference=--quick.csv", "room.obj"}, Words{"--seed", "2", "--", "-room.obj"},
                               Words{"--", "--two-sided"}, Words{"-"}, Words{"two\nlines.obj", "--methods=--x"}}) {
        const CommandLine line(table, words);
        const CommandLine again = recorded_line(table, line);
        CHECK(again.operands() == line.operands());
        for (const char* option : {"reference", "seed", "methods", "to"})
            CHECK(again.text(option) == line.text(option));
        CHECK_FALSE(again.has("two-sided"));
    }
}

TEST_CASE("what was not given is recorded with its default, unless that would be refused or mean something else")
{
    const CommandTable table = command_named("solve").table;
    const auto recorded = [&](Words words, const char* option) {
        words.insert(words.begin(), "room.obj");
        return recorded_line(table, CommandLine(table, words)).has(option);
    };
    for (const char* option : {"lines", "replicates", "ratio", "shading", "exposure", "tone-map", "seed"})
        CHECK_MESSAGE(recorded({}, option), option);
    for (const char* option : {"lines", "replicates"}) {
        CHECK_FALSE(recorded({"--tolerance", "1%"}, option));
        CHECK_FALSE(recorded({"--time", "3s"}, option));
        CHECK(recorded({"--tolerance", "1%", "--" + std::string(option), "4"}, option));
    }
    CHECK_FALSE(recorded({"--power-per-line", "2"}, "ratio"));
    CHECK_FALSE(recorded({"--show", "error"}, "tone-map"));
    CHECK(recorded({"--show", "radiosity"}, "tone-map"));
    CHECK(recorded({"--show", "error", "--shading", "flat"}, "shading"));
    CHECK_FALSE(recorded({}, "gather-rays"));
    CHECK_FALSE(recorded({"--show", "error"}, "gather-rays"));
    CHECK(recorded({"--shading", "gather"}, "gather-rays"));
    CHECK(recorded({"--shading", "gather", "--gather-rays", "9"}, "gather-rays"));
}

TEST_CASE("options that do not change the result are not recorded")
{
    const CommandTable table = command_named("solve").table;
    const CommandLine line(table, {"room.obj", "--threads", "2", "-o", "x.png", "--quiet", "--json", "--verbose"});
    const CommandLine again = recorded_line(table, line);
    for (const char* option : {"threads", "output", "quiet", "json", "verbose", "progress"}) {
        CHECK_FALSE(is_recorded(option));
        CHECK_FALSE(again.has(option));
    }
}

} // namespace recorded_command_test

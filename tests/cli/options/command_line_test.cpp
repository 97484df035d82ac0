#include "base/errors.h"
#include "cli/options/command_line.h"

#include <doctest/doctest.h>

namespace command_line_test {

using namespace multipath;

namespace {

CommandTable solve_like()
{
    return {"solve",
            "solve a scene",
            {"SCENE.obj", 1, 1},
            {{"Results", {{"output", 'o', "FILE", "", "write FILE", true}}},
             {"Budget",
              {{"lines", 0, "N", "2^20", "lines"},
               {"method", 'm', "NAME", "reuse", "method", false, {"local", "reuse"}},
               {"quiet", 'q', "", "", "no progress"},
               {"json", 0, "", "", "summary"}}}}};
}

CommandLine parse(const std::vector<std::string>& arguments)
{
    return CommandLine(solve_like(), arguments);
}

using Texts = std::vector<std::string>;

} // namespace

TEST_CASE("all spellings of an option with a value mean the same")
{
    for (const Texts& spelling :
         {Texts{"--output", "a.png"}, {"--output=a.png"}, {"-o", "a.png"}, {"-oa.png"}, {"-o=a.png"}}) {
        Texts before = spelling;
        before.push_back("room.obj");
        Texts after = {"room.obj"};
        after.insert(after.end(), spelling.begin(), spelling.end());
        for (const Texts& arguments : {before, after}) {
            const CommandLine line = parse(arguments);
            CHECK(line.all("output") == Texts{"a.png"});
            CHECK(line.operands() == Texts{"room.obj"});
        }
    }
}

TEST_CASE("a repeatable option keeps its values in order")
{
    CHECK(parse({"-o", "b.png", "room.obj", "--output=a.ply", "-oc.csv"}).all("output") ==
          Texts{"b.png", "a.ply", "c.csv"});
}

TEST_CASE("an option not given has its default as text but is not given")
{
    const CommandLine line = parse({"room.obj"});
    CHECK(line.text("lines") == "2^20");
    CHECK(line.text("output").empty());
    CHECK_FALSE(line.has("lines"));
    CHECK_FALSE(line.has("quiet"));
    CHECK(line.all("lines").empty());
    CHECK(parse({"room.obj", "--lines", "5"}).text("lines") == "5");
    CHECK(parse({"room.obj", "--quiet"}).has("quiet"));
}

TEST_CASE("after -- everything is an operand; a lone dash always is")
{
    CHECK(parse({"--quiet", "--", "--lines"}).operands() == Texts{"--lines"});
    CHECK(parse({"-"}).operands() == Texts{"-"});
    CHECK(parse({"-o", "-", "room.obj"}).all("output") == Texts{"-"});
}

TEST_CASE("values may hold equals signs, start with one dash, or be empty")
{
    CHECK(parse({"room.obj", "--output=a=b.png"}).all("output") == Texts{"a=b.png"});
    CHECK(parse({"room.obj", "--lines", "-5"}).text("lines") == "-5");
    CHECK(parse({"room.obj", "--output="}).all("output") == Texts{""});
}

TEST_CASE("help is answered whatever is missing")
{
    CHECK(parse({"--help"}).has("help"));
    CHECK(parse({"-h", "--nonsense"}).has("help"));
    CHECK(parse({"-q", "-h"}).has("help"));
    CHECK_FALSE(parse({"room.obj"}).has("help"));
    CHECK_FALSE(parse({"--", "--help"}).has("help"));
}

TEST_CASE("wrong usage is refused with one plain line")
{
    struct Wrong
    {
        Texts arguments;
        const char* message;
    };
    const std::vector<Wrong> cases = {
        {{"room.obj", "--line", "5"}, "unknown option '--line'; did you mean --lines?"},
        {{"room.obj", "--line=5"}, "unknown option '--line'; did you mean --lines?"},
        {{"room.obj", "--zebra"}, "unknown option '--zebra'"},
        {{"room.obj", "-x"}, "unknown option '-x'"},
        {{"room.obj", "-qx"}, "--quiet takes no value, got 'x'"},
        {{"room.obj", "-lines"}, "unknown option '-lines'; did you mean --lines?"},
        {{"room.obj", "--lines"}, "--lines needs a value: --lines N"},
        {{"room.obj", "-o"}, "--output needs a value: --output FILE"},
        {{"room.obj", "-o", "--quiet"}, "--output needs a value: --output FILE"},
        {{"room.obj", "--quiet=yes"}, "--quiet takes no value, got 'yes'"},
        {{"room.obj", "--lines", "5", "--lines=6"}, "--lines is given twice"},
        {{"room.obj", "-q", "--quiet"}, "--quiet is given twice"},
        {{"room.obj", "-o", "a.png", "--output=b.png", "-oa.png"}, "--output: 'a.png' is named twice"},
        {{"room.obj", "-mlocl"}, "--method: expected one of local, reuse, got 'locl'"},
        {{"--quiet"}, "missing SCENE.obj"},
        {{"a.obj", "b.obj"}, "unexpected argument 'b.obj': 'solve' takes SCENE.obj"},
        {{"a.obj", "b\nc\x7f"}, "unexpected argument 'b?c?': 'solve' takes SCENE.obj"},
    };
    for (const Wrong& wrong : cases)
        CHECK_THROWS_WITH_AS(parse(wrong.arguments), wrong.message, UsageError);
}

TEST_CASE("the number of operands is what the table says")
{
    const CommandTable compare = {"compare", "", {"A [B]", 1, 2}, {}};
    CHECK(CommandLine(compare, {"x", "y"}).operands() == Texts{"x", "y"});
    CHECK(CommandLine(compare, {"x"}).operands() == Texts{"x"});
    CHECK_THROWS_WITH_AS(CommandLine(compare, {}), "missing A [B]", UsageError);
    CHECK_THROWS_WITH_AS(CommandLine(compare, {"x", "y", "z"}), "unexpected argument 'z': 'compare' takes A [B]",
                         UsageError);

    const CommandTable merge = {"merge", "", {"STATE...", 1, any_number}, {}};
    CHECK(CommandLine(merge, {"x", "y", "z"}).operands().size() == 3);
    CHECK_THROWS_WITH_AS(CommandLine(merge, {}), "missing STATE...", UsageError);

    const CommandTable points = {"points", "", {}, {}};
    CHECK(CommandLine(points, {}).operands().empty());
    CHECK_THROWS_WITH_AS(CommandLine(points, {"x"}), "unexpected argument 'x': 'points' takes none", UsageError);
}

TEST_CASE("a word outside the choices is refused with all of them")
{
    CHECK_NOTHROW(require_choice("--method", "local", {"local", "global"}));
    CHECK_THROWS_WITH_AS(require_choice("--method", "gobal", {"local", "global"}),
                         "--method: expected one of local, global, got 'gobal'", UsageError);
    CHECK_THROWS_WITH_AS(require_choice("--method", "photons", {"local", "global"}),
                         "--method: expected one of local, global, got 'photons'", UsageError);
}

} // namespace command_line_test

#include "cli/options/help_text.h"

#include <doctest/doctest.h>

#include <sstream>

namespace help_text_test {

using namespace multipath;

namespace {

CommandTable table_with_long_help()
{
    return {"solve",
            "solve a scene",
            {"SCENE.obj", 1, 1},
            {{"Results", {{"output", 'o', "FILE", "", "write FILE", true}}},
             {"Budget",
              {{"lines", 0, "N", "2^20",
                "total number of lines, 3 \xc3\x97 local global together, so that methods can "
                "be compared at equal cost"},
               {"method", 'm', "NAME", "reuse", "method", false, {"local", "reuse"}},
               {"an-option-that-is-far-too-long", 0, "VALUE", "", "goes below"},
               {"quiet", 'q', "", "", "no progress"}}}},
            "Example:\n  multipath solve room.obj"};
}

std::vector<std::string> lines_of(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

bool contains(const std::string& text, const std::string& part)
{
    CAPTURE(text);
    CAPTURE(part);
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("words are wrapped to a width, counted in characters")
{
    CHECK(wrapped_text("", 0, 0, 10) == "\n");
    CHECK(wrapped_text("one two three four", 0, 0, 9) == "one two\nthree\nfour\n");
    CHECK(wrapped_text("one two three four", 0, 0, 10) == "one two\nthree four\n");
    CHECK(wrapped_text("\xc3\xa9t\xc3\xa9 \xc3\xa9t\xc3\xa9", 0, 0, 7) == "\xc3\xa9t\xc3\xa9 \xc3\xa9t\xc3\xa9\n");
}

TEST_CASE("the first line goes on where it is, the others are indented")
{
    CHECK(wrapped_text("one two three", 5, 2, 12) == "one two\n  three\n");
    CHECK(wrapped_text("one two three", 6, 2, 12) == "one\n  two three\n");
}

TEST_CASE("a word that is wider than a line has one of its own")
{
    CHECK(wrapped_text("a incomprehensible b", 0, 1, 10) == "a\n incomprehensible\n b\n");
}

TEST_CASE("the help shows usage, groups, both forms, choices, defaults and notes")
{
    CHECK(help_text(table_with_long_help()) ==
          "usage: multipath solve [OPTIONS] SCENE.obj\n"
          "\n"
          "solve a scene\n"
          "\n"
          "Results:\n"
          "  -o, --output FILE         write FILE (may be repeated)\n"
          "\n"
          "Budget:\n"
          "      --lines N             total number of lines, 3 \xc3\x97 local global together, so\n"
          "                            that methods can be compared at equal cost (default\n"
          "                            2^20)\n"
          "  -m, --method NAME         method (one of local, reuse; default reuse)\n"
          "      --an-option-that-is-far-too-long VALUE\n"
          "                            goes below\n"
          "  -q, --quiet               no progress\n"
          "\n"
          "Help:\n"
          "  -h, --help                Print this help.\n"
          "\n"
          "Example:\n"
          "  multipath solve room.obj\n");
}

TEST_CASE("no line of the help is wider than 80 columns and none ends in a blank")
{
    CommandTable table = table_with_long_help();
    table.groups.pop_back(); // has a character of two bytes
    std::string words;
    for (int i = 0; i < 200; ++i)
        words += (i > 0 ? " " : "") + std::string(static_cast<std::size_t>(1 + i % 9), 'w');
    table.groups[0].options[0].help = words;
    const std::vector<std::string> lines = lines_of(help_text(table));
    CHECK(lines.size() > 20); // 1000 letters and blanks in a column of 52
    for (const std::string& line : lines) {
        CHECK(line.size() <= 80);
        CHECK((line.empty() || line.back() != ' '));
    }
}

TEST_CASE("the usage line names the command and its operands")
{
    CHECK(contains(help_text({"merge", "", {"STATE...", 1, any_number}, {}}),
                   "usage: multipath merge [OPTIONS] STATE...\n"));
    CHECK(contains(help_text({"selftest", "", {"[SCENE.obj]", 0, 1}, {}}),
                   "usage: multipath selftest [OPTIONS] [SCENE.obj]\n"));
    CHECK(contains(help_text({"points", "", {}, {}}), "usage: multipath points [OPTIONS]\n"));
}

TEST_CASE("the list of commands is aligned")
{
    CHECK(contains(program_help({{"solve", "solve a scene", {}, {}}, {"selftest", "take an exam", {}, {}}}, {}),
                   "\n  solve     solve a scene\n"
                   "  selftest  take an exam\n"));
}

TEST_CASE("the manual has the help of commands, and topics, as they are")
{
    const CommandTable table = {"solve",
                                "solve a scene",
                                {"SCENE.obj", 1, 1},
                                {{"Budget", {{"lines", 'n', "N", "2^20", "How many."}}}},
                                "  multipath solve room.obj"};
    const std::string page = man_page({table}, {{"exit-codes", "  0  done\n"}});
    CHECK(contains(page, ".SS solve\n.nf\nusage: multipath solve [OPTIONS] SCENE.obj\n"));
    CHECK(contains(page, "  \\-n, \\-\\-lines N             How many. (default 2^20)\n"));
    CHECK(contains(page, "\n  multipath solve room.obj\n.fi\n"));
    CHECK(contains(page, ".SS exit\\-codes\n.nf\n  0  done\n.fi\n"));
}

TEST_CASE("nothing in a text is a command of roff")
{
    const std::string page = man_page({}, {{"odd", ".so /etc/passwd\n'br\na\\b isn't .x\n"}});
    CHECK(contains(page, "\n\\&.so /etc/passwd\n\\&\\(aqbr\na\\eb isn\\(aqt .x\n"));
}

} // namespace help_text_test

#include "scene/text/text_lines.h"

#include "scene/input_problem.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

namespace text_lines_test {

using namespace multipath;

namespace {

using Lines = std::vector<std::pair<std::string, std::uint32_t>>;

Lines lines_of(const std::string& path)
{
    TextLines lines(path);
    Lines all;
    TextLine line;
    while (lines.next(line))
        all.emplace_back(std::string(line.text), line.place.line);
    return all;
}

Lines split(const std::string& text)
{
    const ScratchFolder folder;
    return lines_of(folder.write("a.txt", text));
}

std::string problem(const std::string& text)
{
    return problem_of([&] { split(text); });
}

} // namespace

TEST_CASE("any line end ends a line, and lines are numbered as an editor does")
{
    CHECK(split("a\nb\r\nc\rd") == Lines{{"a", 1}, {"b", 2}, {"c", 3}, {"d", 4}});
    CHECK(split("a\n\n\r\n\r\rb\n") == Lines{{"a", 1}, {"", 2}, {"", 3}, {"", 4}, {"", 5}, {"b", 6}});
    CHECK(split("").empty());
    CHECK(split("\xef\xbb\xbf"
                "a\n") == Lines{{"a", 1}});
}

TEST_CASE("a backslash joins lines, but not in names and comments")
{
    CHECK(split("f 1 \\\r\n2\\ \n3\nv\n") == Lines{{"f 1  2 3", 1}, {"v", 4}});
    CHECK(split("mtllib a\\\n# c\\\nmap_Kd d\\\nv 1 # \\\n") ==
          Lines{{"mtllib a\\", 1}, {"# c\\", 2}, {"map_Kd d\\", 3}, {"v 1 # \\", 4}});
    CHECK(contains(problem("a\nf 1 \\\n"), "a.txt:2: the file ends after a `\\`"));
}

TEST_CASE("what is not UTF-8 text is refused")
{
    using namespace std::string_literals;
    CHECK(contains(problem("\xff\xfev\0 \0"s), "a.txt:1: control character, expected text in UTF-8"));
    CHECK(contains(problem("\xfe\xff\0v\0 "s), "a.txt:1: control character"));
    CHECK(contains(problem("v\0 \0001\0"s), "a.txt:1: control character"));
    CHECK(contains(problem("a\nb\0c\n"s), "a.txt:2: control character"));
    for (std::size_t place = 0; place < 20; ++place) { // eight characters are looked at together
        std::string text = "v 1 2 3 # caf\xc3\xa9 \xff\x7f~\n";
        text[place] = '\x1f';
        CHECK(contains(problem(text), "a.txt:1: control character"));
    }
    for (const std::string end : {"", "\n", "\nb\n"})
        CHECK(contains(problem("a\n" + std::string(TextLines::longest_line + 1, 'x') + end),
                       "a.txt:2: line is longer than 16 MB"));
    CHECK(problem(std::string(TextLines::longest_line, 'x') + "\n").empty());
    std::string endless;
    while (endless.size() <= TextLines::longest_line)
        endless += std::string(1 << 20, 'x') + "\\\n";
    CHECK(contains(problem("a\n" + endless), "a.txt:2: continued line is longer than 16 MB"));
}

TEST_CASE("a file that cannot be read is refused with the reason")
{
    const ScratchFolder folder;
    const auto problem_with = [](const std::string& path) { return problem_of([&] { lines_of(path); }); };
    CHECK(problem_with(folder.path("none.obj")) ==
          folder.path("none.obj") + ": cannot be read: No such file or directory");
    CHECK(problem_with(folder.path("")) == folder.path("") + ": cannot be read: Is a directory");
}

TEST_CASE("words in messages are short and printable")
{
    CHECK(in_quotes("a b") == "`a b`");
    CHECK(in_quotes("a\x1b\n") == "`a??`");
    CHECK(in_quotes(std::string(1000, 'x')).size() == 65);
}

} // namespace text_lines_test

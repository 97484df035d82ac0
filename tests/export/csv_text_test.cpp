#include "export/csv_text.h"

#include "scene/input_problem.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace csv_text_test {

using namespace multipath;

namespace {

using Words = std::vector<std::string>;

CsvTable parsed(const std::string& text)
{
    const ScratchFolder folder;
    return read_csv(folder.write("a.csv", text));
}

/// The message, which begins with the name of the file without its folder.
template <class Work>
std::string message_of(const Work& work)
{
    const std::string message = problem_of(work);
    return message.empty() ? message : message.substr(message.find("a.csv"));
}

std::string problem(const std::string& text)
{
    return message_of([&] { parsed(text); });
}

} // namespace

TEST_CASE("a table is its comments, its header and its rows, with the lines where they stand")
{
    const CsvTable table = parsed("# one: 1\n#two\n#\n#  three\npatch,area\n0,1.5\n1,#\n");
    CHECK(table.comments == Words{"one: 1", "two", "", " three"});
    CHECK(table.header.fields == Words{"patch", "area"});
    CHECK(table.header.line == 5);
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].fields == Words{"0", "1.5"});
    CHECK(table.rows[1].fields == Words{"1", "#"});
    CHECK(table.rows[1].line == 7);
}

TEST_CASE("lines end in LF or CRLF, and the last one need not")
{
    for (const char* text : {"# c\na,b\n1,\n", "# c\r\na,b\r\n1,\r\n", "# c\na,b\r\n1,"}) {
        CAPTURE(text);
        const CsvTable table = parsed(text);
        CHECK(table.comments == Words{"c"});
        CHECK(table.header.fields == Words{"a", "b"});
        REQUIRE(table.rows.size() == 1);
        CHECK(table.rows[0].fields == Words{"1", ""});
    }
    CHECK(parsed("a").rows.empty());
}

TEST_CASE("quoted fields hold commas and quotes")
{
    const CsvTable table = parsed("\"a,\",\"\"\r\n\"x \"\"y\"\"\",\"1,2\"\r\n\"\"\"\",\"\t\"\n");
    CHECK(table.header.fields == Words{"a,", ""});
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].fields == Words{"x \"y\"", "1,2"});
    CHECK(table.rows[0].line == 2);
    CHECK(table.rows[1].fields == Words{"\"", "\t"});
    CHECK(table.rows[1].line == 3);
}

TEST_CASE("columns are found by name, and their fields read as numbers")
{
    const CsvTable table = parsed("# c\na,b,c\n0.1,-2e3,\nnan,1e999,1;5\n");
    CHECK(table.find_column("b") == 1);
    CHECK_FALSE(table.find_column("B"));
    CHECK(table.column("c") == 2);
    CHECK(message_of([&] { table.column("d"); }) == "a.csv:2: no column `d`, expected a column of that name");
    CHECK(table.number(table.rows[0], 0) == 0.1);
    CHECK(table.number(table.rows[0], 1) == -2000.0);
    const auto problem_at = [&](std::size_t row, std::size_t column) {
        return message_of([&] { table.number(table.rows[row], column); });
    };
    CHECK(problem_at(0, 2) == "a.csv:3: c: a number is missing");
    CHECK(problem_at(1, 0) == "a.csv:4: a: `nan` is not a finite number");
    CHECK(problem_at(1, 1) == "a.csv:4: b: `1e999` is not a finite number");
    CHECK(problem_at(1, 2) == "a.csv:4: c: `1;5` is not a finite number");
}

TEST_CASE("what is no table is refused with the line where it ceases to be one")
{
    CHECK(problem("") == "a.csv:1: the file ends here, expected a header with the names of the columns");
    CHECK(problem("# only\n# comments") ==
          "a.csv:3: the file ends here, expected a header with the names of the columns");
    CHECK(problem("# c\n\na\n") == "a.csv:2: empty line, expected the names of the columns");
    CHECK(problem("a,b,a\n") == "a.csv:1: two columns are named `a`, expected different names");
    CHECK(problem("a,b\n1,2\n1,2,3\n") == "a.csv:3: row has 3 fields, expected 2 as in the header");
    CHECK(problem("a,b\n1\n") == "a.csv:2: row has 1 field, expected 2 as in the header");
    CHECK(problem("a,b\n1,2\n\n") == "a.csv:3: row has 1 field, expected 2 as in the header");
    CHECK(problem("a,b\n# late comment\n") == "a.csv:2: row has 1 field, expected 2 as in the header");
}

TEST_CASE("quotes stand around a whole field or nowhere")
{
    CHECK(problem("a\nb\"c\"\n") ==
          "a.csv:2: quote inside a field, expected the whole field in quotes and this one doubled");
    CHECK(problem("a,b\n1,\"c\" \n") == "a.csv:2: text after a closing quote, expected a comma or the end of the line");
    const std::string unclosed = "quote without end, expected a closing quote before the end of the line";
    CHECK(problem("a,b\n1,2\n1,\"c\n2,d\n") == "a.csv:3: " + unclosed);
    CHECK(problem("\"") == "a.csv:1: " + unclosed);
    CHECK(problem("a\n\"\"\"") == "a.csv:2: " + unclosed);
}

TEST_CASE("control characters are refused wherever they stand")
{
    using namespace std::string_literals;
    const std::string binary = "control character, expected text in UTF-8 (is the file UTF-16, binary or damaged?)";
    CHECK(problem("\0"s) == "a.csv:1: " + binary);
    CHECK(problem("# \0\n"s) == "a.csv:1: " + binary);
    CHECK(problem("a\n1\0\n"s) == "a.csv:2: " + binary);
    CHECK(problem("a\n\"\x1b\"\n") == "a.csv:2: " + binary);
}

// Each of these takes milliseconds in linear time and minutes in quadratic time.
TEST_CASE("hostile lines of megabytes end in one short line")
{
    constexpr std::size_t megabytes = 1u << 20;
    const std::vector<std::string> lines = {std::string(megabytes, 'x'), std::string(megabytes, ','),
                                            "\"" + std::string(megabytes, ','), std::string(megabytes, '"'),
                                            "\"" + std::string(megabytes, '"') + "x"};
    for (const std::string& line : lines) {
        const std::string message = problem("a,b\n" + line);
        CHECK(message.substr(0, 8) == "a.csv:2:");
        CHECK(message.size() < 200);
    }
    CHECK(problem(std::string(megabytes, ',')) == "a.csv:1: two columns are named ``, expected different names");
    CHECK(parsed("# " + std::string(megabytes, 'x') + "\na\n").comments[0].size() == megabytes);
}

TEST_CASE("a file is read as its text, with or without a UTF-8 mark")
{
    const ScratchFolder folder;
    const CsvTable table = read_csv(folder.write("t.csv", "\xef\xbb\xbf# c\r\na,b\r\n\"1,2\",3\n4,5"));
    CHECK(table.comments == Words{"c"});
    CHECK(table.header.fields == Words{"a", "b"});
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].fields == Words{"1,2", "3"});
    CHECK(table.rows[1].fields == Words{"4", "5"});
    CHECK(table.rows[1].line == 4);
    CHECK(table.path == folder.path("t.csv"));
    CHECK(problem_of([&] { read_csv(folder.path("none.csv")); }) ==
          folder.path("none.csv") + ": cannot be read: No such file or directory");
    CHECK(problem_of([&] { read_csv(folder.path("")); }) == folder.path("") + ": cannot be read: Is a directory");
    CHECK(contains(problem_of([&] { read_csv(folder.write("empty.csv", "")); }), "empty.csv:1: the file ends here"));
}

TEST_CASE("a row of a file may end in a backslash")
{
    const ScratchFolder folder;
    const CsvTable table = read_csv(folder.write("t.csv", "a,b\n1,C:\\\n2,d\n"));
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].fields[1] == "C:\\");
    CHECK(table.rows[1].line == 3);
}

TEST_CASE("a field is quoted where it must be, and is read back")
{
    CHECK(csv_field("sobol") == "sobol");
    CHECK(csv_field("halton:2,7") == "\"halton:2,7\"");
    for (const std::string text : {"a \"b\", c", "\"", ","})
        CHECK(parsed("name\n" + csv_field(text) + "\n").rows[0].fields == Words{text});
}

TEST_CASE("a comment's value is what follows its name and a colon")
{
    const std::vector<std::string> comments = {"multipath 1.0.0", "scenery: a", "scene: 0123: 4", "scene: 5", "seed:6"};
    CHECK(comment_value(comments, "scene") == "0123: 4");
    CHECK_FALSE(comment_value(comments, "seed"));
    CHECK_FALSE(comment_value(comments, "multipath"));
}

TEST_CASE("every comment is a line of its own")
{
    CHECK(comment_lines({"multipath 1.0.0", "seed: 1"}) == "# multipath 1.0.0\n# seed: 1\n");
    CHECK(comment_lines({}).empty());
}

} // namespace csv_text_test

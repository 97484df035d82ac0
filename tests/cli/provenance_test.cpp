#include "cli/provenance.h"

#include "commands/commands.h"

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace provenance_test {

using namespace multipath;

namespace {

using Words = std::vector<std::string>;

/// The words of a command as a shell has them: plain characters, \c and '...'.
Words shell_words(std::string_view text)
{
    Words words(1);
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\'')
            quoted = !quoted;
        else if (quoted)
            words.back() += c;
        else if (c == ' ')
            words.emplace_back();
        else
            words.back() += c == '\\' ? text[++i] : c;
    }
    return words;
}

/// What is recorded of the command, in one line.
std::string recorded_text(const CommandLine& line)
{
    const std::string key = "command: ";
    const std::string fact = provenance(line).at(1);
    REQUIRE(fact.substr(0, key.size()) == key);
    return fact.substr(key.size());
}

CommandLine recorded_line(const CommandLine& line)
{
    const Words words = shell_words(recorded_text(line));
    REQUIRE(words.at(0) == "multipath");
    REQUIRE(words.at(1) == line.table().name);
    return {line.table(), {words.begin() + 2, words.end()}};
}

/// An operand of `check` as it is recorded.
std::string recorded_operand(const std::string& word)
{
    const CommandTable table = {"check", "", {"SCENE.obj", 1, 1}, {}, ""};
    const std::string start = "multipath check ";
    const std::string text = recorded_text(CommandLine(table, {"--", word}));
    REQUIRE(text.substr(0, start.size()) == start);
    return text.substr(start.size());
}

} // namespace

TEST_CASE("plain words are recorded as they are, others are quoted as in every shell")
{
    CHECK(recorded_operand("halton:2,7,3,5") == "halton:2,7,3,5");
    CHECK(recorded_operand("2^20") == "2^20");
    CHECK(recorded_operand("my room.obj") == "'my room.obj'");
    CHECK(recorded_operand("it's") == "'it'\\''s'");
    CHECK(recorded_operand("$HOME") == "'$HOME'");
    CHECK(recorded_operand("~") == "'~'");
    CHECK(recorded_operand("#") == "'#'");
    CHECK(recorded_operand("a\nb\x1b") == "'a?b?'");
}

TEST_CASE("every byte but control characters comes back from the recorded command")
{
    for (int code = 0x20; code < 256; ++code) {
        if (code == 0x7f)
            continue;
        const std::string byte(1, static_cast<char>(code));
        CAPTURE(code);
        for (const std::string& word : {"x" + byte, "1" + byte + "2'", "'" + byte + byte}) {
            const std::string text = recorded_operand(word);
            CHECK(shell_words(text) == Words{word});
        }
    }
}

TEST_CASE("operands and values that look like options are recorded so that they are read as what they are")
{
    const CommandTable table = command_named("study").table;
    for (const Words& words : {Words{"--reference=--quick.csv", "room.obj"}, Words{"--seed", "2", "--", "-room.obj"},
                               Words{"--", "--two-sided"}, Words{"-"}, Words{"two words.obj", "--methods=--x"}}) {
        const CommandLine line(table, words);
        const CommandLine again = recorded_line(line);
        CHECK(again.operands() == line.operands());
        for (const char* option : {"reference", "seed", "methods", "to"})
            CHECK(again.text(option) == line.text(option));
        CHECK_FALSE(again.has("two-sided"));
    }
}

TEST_CASE("what was given is recorded, defaults are not")
{
    const CommandTable table = command_named("solve").table;
    const CommandLine line(table, {"room.obj", "--ratio", "1", "--lamp", "a=1", "--lamp", "b=2", "--two-sided"});
    const std::vector<Option> options = all_options(table.groups);
    CHECK(recorded_line(line).words(options) == line.words(options));
    CHECK(recorded_text(CommandLine(table, {"room.obj"})) == "multipath solve room.obj");
}

TEST_CASE("options that do not change the result are not recorded")
{
    const CommandTable table = command_named("solve").table;
    const CommandLine line(table, {"room.obj", "--threads", "2", "-o", "x.png", "--quiet", "--json", "--verbose"});
    const CommandLine again = recorded_line(line);
    for (const char* option : {"threads", "output", "quiet", "json", "verbose"}) {
        CHECK_FALSE(is_recorded(option));
        CHECK_FALSE(again.has(option));
    }
}

} // namespace provenance_test

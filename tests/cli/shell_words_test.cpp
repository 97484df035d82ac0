#include "cli/shell_words.h"

#include <doctest/doctest.h>

namespace shell_words_test {

using namespace multipath;

using Words = std::vector<std::string>;

TEST_CASE("words come back from the text that a shell would read, and the text is one line")
{
    const Words words = {"solve",
                         "scenes/5cubes.obj",
                         "",
                         " ",
                         "my room.obj",
                         "it's",
                         "'",
                         "''",
                         "a'b'c",
                         "$HOME",
                         "`ls`",
                         "a;b; c",
                         "\"x\"",
                         "back\\slash",
                         "\\",
                         "--size",
                         "a=b",
                         "#",
                         "*?[x]",
                         "K\xc3\xbc"
                         "che.obj",
                         "a\nb",
                         "\t",
                         "\n'\\",
                         "\x1b[2J",
                         "\x7f",
                         "9\n1",
                         "~"};
    for (const std::string& word : words) {
        CAPTURE(word);
        CHECK(split_shell_words(shell_word(word)) == Words{word});
        CHECK(shell_word(word).find_first_of("\n\r\t\x1b\x7f") == std::string::npos);
    }
    CHECK(split_shell_words(shell_text(words)) == words);
}

TEST_CASE("every byte but zero comes back, alone and between others")
{
    for (int code = 1; code < 256; ++code) {
        const std::string byte(1, static_cast<char>(code));
        CAPTURE(code);
        CHECK(split_shell_words(shell_word(byte)) == Words{byte});
        CHECK(split_shell_words(shell_word("1" + byte + "2'")) == Words{"1" + byte + "2'"});
    }
}

TEST_CASE("plain words stay as they are, others are quoted as in every shell")
{
    CHECK(shell_word("halton:2,7,3,5") == "halton:2,7,3,5");
    CHECK(shell_word("2^20") == "2^20");
    CHECK(shell_word("") == "''");
    CHECK(shell_word("my room.obj") == "'my room.obj'");
    CHECK(shell_word("it's") == "'it'\\''s'");
    CHECK(shell_word("a\nb") == "$'a\\012b'");
}

TEST_CASE("pieces of a word are joined, any number of blanks lies between words")
{
    CHECK(split_shell_words("  a  b='c d' ") == Words{"a", "b=c d"});
    CHECK(split_shell_words("") == Words{});
    CHECK(split_shell_words("   ") == Words{});
}

TEST_CASE("a text that a shell would do more with than split it has no words")
{
    for (const char* text :
         {"a; rm b", "a | b", "a & b", "$HOME", "`ls`", "$(ls)", "a > b",  "\"a\"",  "*",   "~",    "a #b",
          "!a",      "{a,b}", "'a",    "a'",    "$'a",  "$'\\",  "$'\\1'", "$'\\n'", "a\\", "a\nb", "a\tb"})
        CHECK_MESSAGE(!split_shell_words(text), text);
}

TEST_CASE("a text is cut at separators outside quotes only")
{
    CHECK(split_outside_quotes("a; b", "; ") == Words{"a", "b"});
    CHECK(split_outside_quotes("", "; ") == Words{""});
    for (const char* name : {"x; seed: 3", "it's; y", "'; '", "\n'; ", "\\'; z"}) {
        const std::string command = "command: " + shell_word(name);
        CHECK(split_outside_quotes("v; " + command + "; seed: 1", "; ") == Words{"v", command, "seed: 1"});
    }
}

} // namespace shell_words_test

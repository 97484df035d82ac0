#include "cli/wrapped_text.h"

#include <doctest/doctest.h>

namespace wrapped_text_test {

using namespace multipath;

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

} // namespace wrapped_text_test

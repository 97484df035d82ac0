#include "commands/explain/trace_text.h"

#include "explain/words.h"

#include <doctest/doctest.h>

#include <sstream>

namespace trace_text_test {

using namespace multipath;

TEST_CASE("wrapped text has the same words in the same order on lines of at most 110 columns, indented as asked")
{
    std::string text;
    for (int k = 0; k < 200; ++k)
        text += (k == 0 ? "" : " ") + std::to_string(k * k * k);
    std::istringstream lines(wrapped(text, 3, 5));
    std::string words;
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        CHECK(line.size() <= 110);
        CHECK(line.find_first_not_of(' ') == (count == 0 ? 3 : 5));
        words += (words.empty() ? "" : " ") + line.substr(line.find_first_not_of(' '));
    }
    CHECK(count > 5);
    CHECK(words == text);
}

TEST_CASE("one number stands for equal channels")
{
    CHECK(wrapped(watts({0.5, 0.5, 0.5}), 0, 0) == "0.5 W\n");
    CHECK(wrapped(watts({0.5, 0.25, 0.5}), 0, 0) == "(0.5, 0.25, 0.5) W\n");
}

} // namespace trace_text_test

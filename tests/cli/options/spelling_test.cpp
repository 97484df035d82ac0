#include "cli/options/spelling.h"

#include <doctest/doctest.h>

namespace spelling_test {

using namespace multipath;

TEST_CASE("a misspelling is answered with the nearest word: one letter wrong, missing, added, or two swapped")
{
    const std::vector<std::string> words = {"--lines", "--local", "--threads", "--threshold"};
    CHECK(did_you_mean("--lined", words) == "; did you mean --lines?");
    CHECK(did_you_mean("--line", words) == "; did you mean --lines?");
    CHECK(did_you_mean("--liness", words) == "; did you mean --lines?");
    CHECK(did_you_mean("--lnies", words) == "; did you mean --lines?");
    CHECK(did_you_mean("-lines", words) == "; did you mean --lines?");
    CHECK(did_you_mean("--LINES", words) == "; did you mean --lines?");
}

TEST_CASE("an unfinished word counts as a misspelling, a different word does not")
{
    const std::vector<std::string> words = {"bidirectional", "sequence"};
    CHECK(did_you_mean("bidi", words) == "; did you mean bidirectional?");
    CHECK(did_you_mean("camera", words).empty());
    CHECK(did_you_mean("", words).empty());
    CHECK(did_you_mean("word", {}).empty());
}

TEST_CASE("of several near words the nearest is proposed, not the first")
{
    CHECK(did_you_mean("threds", {"tread", "threads"}) == "; did you mean threads?");
}

} // namespace spelling_test

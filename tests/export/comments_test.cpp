#include "export/comments.h"

#include <doctest/doctest.h>

namespace comments_test {

using namespace multipath;

TEST_CASE("a comment's value is what follows its name and a colon")
{
    const std::vector<std::string> comments = {"multipath 0.1.0", "scenery: a", "scene: 0123: 4", "scene: 5", "seed:6"};
    CHECK(comment_value(comments, "scene") == "0123: 4");
    CHECK_FALSE(comment_value(comments, "seed"));
    CHECK_FALSE(comment_value(comments, "multipath"));
}

TEST_CASE("every comment is a line of its own")
{
    CHECK(comment_lines({"multipath 0.1.0", "seed: 1"}) == "# multipath 0.1.0\n# seed: 1\n");
    CHECK(comment_lines({}).empty());
}

} // namespace comments_test

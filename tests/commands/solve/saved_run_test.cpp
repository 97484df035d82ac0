#include "commands/solve/saved_run.h"

#include "base/errors.h"
#include "commands/commands.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace saved_run_test {

using namespace multipath;

namespace {

Scene room(double reflectance)
{
    SceneBuilder builder;
    return builder.room({0, 0, 0}, {1, 1, 1}, builder.grey(reflectance, 1.0)).scene(1.0);
}

RunDescription run_of(const std::vector<std::string>& options, Shard shard = {}, double reflectance = 0.5)
{
    std::vector<std::string> words = {"room.obj"};
    words.insert(words.end(), options.begin(), options.end());
    return description_of({solve_command().table, words}, room(reflectance), shard);
}

/// What is said against going on from one run with another, or "".
std::string difference(const RunDescription& saved, const RunDescription& wanted)
{
    try {
        require_same_run(saved, "a.state", wanted);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool says(const std::string& text, const char* part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("a run goes on with other lines, tolerance or time, and with nothing else")
{
    const RunDescription saved = run_of({"--lines", "1000", "--seed", "1"});
    CHECK(difference(saved, run_of({"--lines", "2000", "--seed", "1"})).empty());
    CHECK(says(difference(saved, run_of({"--lines", "1000", "--seed", "2"})), "made with --seed 1, not with --seed 2"));
    CHECK(says(difference(saved, run_of({"--lines", "1000", "--seed", "1", "--two-sided"})),
               "made with no --two-sided, not with --two-sided"));
    CHECK(says(difference(saved, run_of({"--lines", "1000", "--seed", "1"}, {}, 0.6)), "not with the one given now"));
}

// Which lines are those of a share depends on how many there are in all.
TEST_CASE("a shard goes on with its own lines alone")
{
    const RunDescription saved = run_of({"--lines", "1000"}, {0, 2});
    CHECK(difference(saved, run_of({"--lines", "1000"}, {0, 2})).empty());
    CHECK(
        says(difference(saved, run_of({"--lines", "2000"}, {0, 2})), "made with --lines 1000, not with --lines 2000"));
    CHECK(says(difference(saved, run_of({"--lines", "1000"}, {1, 2})), "of another shard"));
    CHECK(says(difference(saved, run_of({"--lines", "1000"}, {0, 3})), "of another shard"));
}

} // namespace saved_run_test

#include "commands/options/scene_options.h"

#include "commands/solve/accuracy.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace scene_options_test {

using namespace multipath;

namespace {

CommandLine solve_line(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "scenes/furnace.obj");
    return {{"solve", "", {{"SCENE.obj"}}, {accuracy_option_group(), scene_option_group()}}, arguments};
}

std::uint32_t patches(const std::vector<std::string>& arguments)
{
    return read_scene(solve_line(arguments)).patch_count();
}

} // namespace

TEST_CASE("two sides double the patches of a size, and share those that a number allows")
{
    CHECK(patches({"--patch-size", "0.1", "--two-sided"}) == 2 * patches({"--patch-size", "0.1"}));
    CHECK(patches({"--patches", "600"}) == 600);
    CHECK(patches({"--patches", "1200", "--two-sided"}) == 1200);
    CHECK(patches({"--patches", "1", "--two-sided"}) == 12);
}

TEST_CASE(
    "two sides double the usual number of adaptive patches, not a given one, and keep the share of the coarse ones")
{
    const auto adaptive = [](const std::vector<std::string>& arguments) {
        const CommandLine line = solve_line(arguments);
        return adaptive_patches(line, read_scene(line).surfaces());
    };
    CHECK(adaptive({"--two-sided"}) == 2 * adaptive({}));
    CHECK(adaptive({"--adaptive", "900", "--two-sided"}) == 900);
    CHECK(patches({"--adaptive", "5964"}) == 6 * 18 * 18); // a third of the divisions, 5,958, beside the six surfaces
    CHECK(patches({"--adaptive", "11928", "--two-sided"}) == 2 * 6 * 18 * 18);
}

} // namespace scene_options_test

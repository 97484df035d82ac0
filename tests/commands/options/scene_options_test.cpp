#include "commands/options/scene_options.h"

#include "base/text_format.h"
#include "commands/solve/accuracy.h"
#include "scene/input_problem.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace scene_options_test {

using namespace multipath;

namespace {

CommandLine solve_line(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), "scenes/furnace.obj");
    return {{"solve", "", {"SCENE.obj", 1, 1}, {accuracy_option_group(), scene_option_group()}}, arguments};
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

TEST_CASE("every remedy is a scene option that takes its value")
{
    const auto option = [](Remedy remedy, const std::string& value = "") {
        const std::string text = option_text({remedy, value});
        const std::size_t space = text.find(' ', 1);
        std::vector<std::string> words = {"scenes/furnace.obj", text.substr(1, space - 1)};
        if (space != std::string::npos)
            words.push_back(text.substr(space + 1));
        const CommandLine line({"check", "", {"SCENE.obj", 1, 1}, {scene_option_group()}},
                               words); // throws if it is none
        CHECK(line.text(words[1].substr(2)) == value);
        return words[1];
    };
    CHECK(option(Remedy::patch_size, "0.2") == "--patch-size");
    CHECK(option(Remedy::two_sided) == "--two-sided");
    CHECK(option(Remedy::flip) == "--flip");
    CHECK(option(Remedy::lamp, "ceiling=10") == "--lamp");
    CHECK(option(Remedy::sky, "10") == "--sky");
    CHECK(option(Remedy::sun, "150,40,20") == "--sun");
    CHECK(option(Remedy::reflectance_limit, "0.9") == "--reflectance-limit");
}

TEST_CASE("advice is given in clauses that begin with the option")
{
    CHECK(advice_text({}).empty());
    CHECK(advice_text({{Remedy::flip, "", "turns all faces over"}, {Remedy::patch_size, "0.2", "gives 7 patches"}}) ==
          "; --flip turns all faces over; --patch-size 0.2 gives 7 patches");
    CHECK(advice_text({{Remedy::lamp, "desk lamp=10"}}) == ": --lamp 'desk lamp=10'");
}

TEST_CASE("the error of a scene without light advises the options that light it")
{
    const ScratchFolder folder;
    const std::string path = folder.write("dark.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n");
    const CommandLine line({"solve", "", {"SCENE.obj", 1, 1}, {scene_option_group()}}, {path});
    std::string problem;
    try {
        read_scene(line);
    } catch (const InputError& error) {
        problem = error.what() + advice_text(error.advice);
    }
    CHECK(contains(problem, "to light it by sky and sun: --sky 10 --sun 150,40,20"));
}

} // namespace scene_options_test

#include "cli/files/planned_outputs.h"

#include "cli/options/usage_error.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <filesystem>

namespace planned_outputs_test {

using namespace multipath;

TEST_CASE("files are the same by any of their names, also before they exist")
{
    const ScratchFolder folder;
    const std::string file = folder.write("a.csv", "a");
    std::filesystem::create_symlink("a.csv", folder.path("link.csv"));
    std::filesystem::create_hard_link(file, folder.path("hard.csv"));
    std::filesystem::create_directory(folder.path("sub"));
    std::filesystem::create_symlink("../new.csv", folder.path("sub/later.csv"));
    CHECK(same_file(file, folder.path("link.csv")));
    CHECK(same_file(file, folder.path("hard.csv")));
    CHECK(same_file(file, folder.path("sub/../a.csv")));
    CHECK(same_file(folder.path("new.csv"), folder.path("sub/later.csv")));
    CHECK_FALSE(same_file(file, folder.path("new.csv")));
    CHECK_FALSE(same_file(folder.path("new.csv"), folder.path("sub/new.csv")));
    CHECK_FALSE(same_file(folder.path("new.csv"), folder.path("other.csv")));
}

TEST_CASE("an output has one of the command's extensions, in upper or lower case, and standard output the first one")
{
    CHECK(output_extension("a/b.CSV", {".svg", ".csv"}) == ".csv");
    CHECK(output_extension("-", {".svg", ".csv"}) == ".svg");
    CHECK_THROWS_WITH_AS(output_extension("a.csv/b", {".svg", ".csv"}),
                         "--output: 'a.csv/b' does not end in a known extension; expected one of .svg, .csv",
                         UsageError);
    CHECK_THROWS_WITH_AS(output_extension("a.cvs", {".svg", ".csv"}), doctest::Contains("did you mean .csv?"),
                         UsageError);
}

TEST_CASE("of any number of outputs no two may be the same, and nothing is left of those before")
{
    const ScratchFolder folder;
    const auto open = [&](const std::vector<std::string>& names) {
        std::vector<std::string> paths;
        for (const std::string& name : names)
            paths.push_back(folder.path(name));
        open_outputs(paths, {}, {".csv", ".png"});
    };
    CHECK_NOTHROW(open({"a.csv", "b.csv", "a.png"}));
    CHECK_THROWS_WITH_AS(open({"a.csv", "b.csv", "./b.csv"}), doctest::Contains("is named twice"), UsageError);
    CHECK_THROWS_WITH_AS(open({"a.csv", "b.csv", "c.csv", "a.csv"}), doctest::Contains("is named twice"), UsageError);
    CHECK(std::filesystem::is_empty(folder.path(".")));
}

TEST_CASE("an output that turns out to be an input is refused")
{
    const ScratchFolder folder;
    const std::string library = folder.write("lib.csv", "newmtl a");
    const std::vector<PlannedOutput> outputs = open_outputs({library}, {folder.path("scene.obj")}, {".csv"});
    CHECK_THROWS_AS(require_no_input(outputs, {folder.path("other.mtl"), library}), UsageError);
    CHECK_NOTHROW(require_no_input(outputs, {folder.path("other.mtl")}));
}

TEST_CASE("a commit puts all outputs into place")
{
    const ScratchFolder folder;
    std::vector<PlannedOutput> outputs = open_outputs({folder.path("a.csv"), folder.path("b.csv")}, {}, {".csv"});
    outputs[0].file.write("a");
    outputs[1].file.write("b");
    commit(outputs);
    CHECK(std::filesystem::exists(folder.path("a.csv")));
    CHECK(std::filesystem::exists(folder.path("b.csv")));
}

} // namespace planned_outputs_test

#include "cli/planned_outputs.h"

#include "cli/usage_error.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <filesystem>

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
}

TEST_CASE("an output that turns out to be an input is refused")
{
    const ScratchFolder folder;
    const std::string library = folder.write("lib.csv", "newmtl a");
    const std::vector<PlannedOutput> outputs = open_outputs({library}, {folder.path("scene.obj")});
    CHECK_THROWS_AS(require_no_input(outputs, {folder.path("other.mtl"), library}), UsageError);
    CHECK_NOTHROW(require_no_input(outputs, {folder.path("other.mtl")}));
}

TEST_CASE("a commit puts all outputs into place")
{
    const ScratchFolder folder;
    std::vector<PlannedOutput> outputs = open_outputs({folder.path("a.csv"), folder.path("b.csv")}, {});
    outputs[0].file.write("a");
    outputs[1].file.write("b");
    commit(outputs);
    CHECK(std::filesystem::exists(folder.path("a.csv")));
    CHECK(std::filesystem::exists(folder.path("b.csv")));
}

#include "cli/files/part_file.h"

#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <sys/file.h>
#include <unistd.h>

namespace part_file_test {

using namespace multipath;

TEST_CASE("part files of one target stand side by side while their makers live")
{
    const ScratchFolder folder;
    const PartFile first = create_part_file(folder.path("a.csv"), 0666);
    const PartFile second = create_part_file(folder.path("a.csv"), 0666);
    REQUIRE(first.descriptor >= 0);
    REQUIRE(second.descriptor >= 0);
    CHECK(std::filesystem::exists(first.path));
    CHECK(std::filesystem::exists(second.path));
    CHECK(first.path != second.path);
    close(first.descriptor);
    close(second.descriptor);
}

TEST_CASE("what nobody holds any more is removed by the next, and nothing else")
{
    const ScratchFolder folder;
    const PartFile dead = create_part_file(folder.path("a.csv"), 0666);
    close(dead.descriptor); // as the system does for a program that was killed
    const std::string others[] = {".b.csv.abcdef.part", ".a.csv.abcdefg.part", ".a.csv.abcde.part",
                                  ".a.csv.ABCDEF.part", ".a.csv.abcdef.part~", ".xa.csv.abcdef.part",
                                  "a.csv.abcdef.part"};
    for (const std::string& name : others)
        folder.write(name, "");
    const PartFile next = create_part_file(folder.path("a.csv"), 0666);
    CHECK_FALSE(std::filesystem::exists(dead.path));
    CHECK(std::filesystem::exists(next.path));
    for (const std::string& name : others)
        CHECK_MESSAGE(std::filesystem::exists(folder.path(name)), name);
    close(next.descriptor);
}

TEST_CASE("a link that is named like a part file costs nothing that it leads to")
{
    const ScratchFolder folder;
    folder.write("kept", "bytes");
    std::filesystem::create_symlink("kept", folder.path(".a.csv.abcdef.part"));
    close(create_part_file(folder.path("a.csv"), 0666).descriptor);
    CHECK(std::filesystem::file_size(folder.path("kept")) == 5);
}

TEST_CASE("the folder of a path ends in a slash")
{
    CHECK(folder_of("a.csv") == "");
    CHECK(folder_of("/a.csv") == "/");
    CHECK(folder_of("../b/a.csv") == "../b/");
}

} // namespace part_file_test

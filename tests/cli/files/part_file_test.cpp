#include "cli/files/part_file.h"

#include "export/file_bytes.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <sys/file.h>
#include <unistd.h>
#include <utility>
#include <vector>

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

TEST_CASE("what is unfinished is removed, what is finished stays")
{
    const ScratchFolder folder;
    for (const char* name : {"part", "moved", "finished", "replaced"})
        folder.write(name, "bytes");
    const Unfinished part(folder.path("part"), folder.path("a"));
    Unfinished first(folder.path("moved"), folder.path("b"));
    const Unfinished moved(std::move(first));
    Unfinished replaced(folder.path("replaced"), folder.path("c"));
    replaced = Unfinished(folder.path("missing"), folder.path("d"));
    Unfinished(folder.path("finished"), folder.path("e"));

    remove_unfinished();
    CHECK_FALSE(std::filesystem::exists(folder.path("part")));
    CHECK_FALSE(std::filesystem::exists(folder.path("moved")));
    CHECK(std::filesystem::exists(folder.path("finished")));
    CHECK(std::filesystem::exists(folder.path("replaced")));
}

TEST_CASE("what is complete gets the name of its target, the targets of the rest are named")
{
    const ScratchFolder folder;
    for (const char* name : {"part-a", "part-b", "part-c"})
        folder.write(name, "new");
    folder.write("a", "old");
    folder.write("b", "old");
    Unfinished complete(folder.path("part-a"), folder.path("a"));
    complete.complete();
    const Unfinished moved(std::move(complete));
    const Unfinished incomplete(folder.path("part-b"), folder.path("b"));
    Unfinished nowhere(folder.path("part-c"), folder.path("no folder/c"));
    nowhere.complete();

    static std::vector<std::string> not_written;
    not_written.clear();
    settle_unfinished([](const char* target) { not_written.emplace_back(target); });
    CHECK(bytes_of_file(folder.path("a")) == "new");
    CHECK(bytes_of_file(folder.path("b")) == "old");
    CHECK(not_written == std::vector<std::string>{folder.path("b"), folder.path("no folder/c")});
    for (const char* name : {"part-a", "part-b", "part-c"})
        CHECK_FALSE(std::filesystem::exists(folder.path(name)));
}

TEST_CASE("those beyond the number of slots are left alone, and slots are used again")
{
    const ScratchFolder folder;
    for (int round = 0; round < 2; ++round) {
        std::vector<Unfinished> many;
        for (int n = 0; n < 100; ++n) {
            folder.write(std::to_string(n), "");
            many.emplace_back(folder.path(std::to_string(n)), folder.path("target"));
        }
        remove_unfinished();
        CHECK_FALSE(std::filesystem::exists(folder.path("0")));
        CHECK_FALSE(std::filesystem::exists(folder.path("63")));
        CHECK(std::filesystem::exists(folder.path("64")));
    }
    folder.write("long", "");
    const Unfinished endless(folder.path("long") + std::string(5000, '/'), folder.path("target"));
    remove_unfinished();
    CHECK(std::filesystem::exists(folder.path("long")));
}

} // namespace part_file_test

#include "cli/files/unfinished.h"

#include "export/file_bytes.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace unfinished_test {

using namespace multipath;

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

} // namespace unfinished_test

#include "cli/unfinished.h"

#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <utility>
#include <vector>

using namespace multipath;

TEST_CASE("what is unfinished is removed, files and then their folder; what is finished stays")
{
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path("runs"));
    for (const char* name : {"runs/part", "moved", "finished", "replaced"})
        folder.write(name, "bytes");
    const Unfinished runs(folder.path("runs"));
    const Unfinished part(folder.path("runs/part"));
    Unfinished first(folder.path("moved"));
    const Unfinished moved(std::move(first));
    Unfinished replaced(folder.path("replaced"));
    replaced = Unfinished(folder.path("missing"));
    Unfinished(folder.path("finished"));

    remove_unfinished();
    CHECK_FALSE(std::filesystem::exists(folder.path("runs")));
    CHECK_FALSE(std::filesystem::exists(folder.path("moved")));
    CHECK(std::filesystem::exists(folder.path("finished")));
    CHECK(std::filesystem::exists(folder.path("replaced")));
}

TEST_CASE("a folder with other files stays")
{
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path("runs"));
    folder.write("runs/result", "bytes");
    const Unfinished runs(folder.path("runs"));
    remove_unfinished();
    CHECK(std::filesystem::exists(folder.path("runs/result")));
}

TEST_CASE("those beyond the number of slots are left alone, and slots are used again")
{
    const ScratchFolder folder;
    for (int round = 0; round < 2; ++round) {
        std::vector<Unfinished> many;
        for (int n = 0; n < 100; ++n) {
            folder.write(std::to_string(n), "");
            many.emplace_back(folder.path(std::to_string(n)));
        }
        remove_unfinished();
        CHECK_FALSE(std::filesystem::exists(folder.path("0")));
        CHECK_FALSE(std::filesystem::exists(folder.path("63")));
        CHECK(std::filesystem::exists(folder.path("64")));
    }
    folder.write("long", "");
    const Unfinished endless(folder.path("long") + std::string(5000, '/'));
    remove_unfinished();
    CHECK(std::filesystem::exists(folder.path("long")));
}

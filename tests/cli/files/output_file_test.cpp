#ifndef _WIN32 // permissions, links, named pipes; scripts test the outputs there

#include "base/errors.h"
#include "cli/files/output_file.h"

#include "base/file_bytes.h"
#include "base/platform/process.h"
#include "cli/options/command_line.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace output_file_test {

using namespace multipath;

namespace {

/// An empty folder that vanishes at the end of the test.
class Folder
{
public:
    Folder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "multipath_output.XXXXXX").string();
        path_ = mkdtemp(&name[0]);
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string operator/(const std::string& name) const { return path_ + "/" + name; }
    std::ptrdiff_t file_count() const
    {
        return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
    }

private:
    std::string path_;
};

std::string content(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void put(const std::string& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
}

mode_t mode_of(const std::string& path)
{
    struct stat status = {};
    REQUIRE(stat(path.c_str(), &status) == 0);
    return status.st_mode & 07777;
}

std::string error_of(const std::string& path)
{
    try {
        OutputFile file(path);
    } catch (const OutputError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST_CASE("a file appears complete, under its name, at the commit and not before")
{
    const Folder folder;
    const std::string bytes("a\0b\r\n\xff", 6);
    OutputFile file(folder / "room.png");
    file.write(bytes);
    file.write("end");
    CHECK_FALSE(std::filesystem::exists(folder / "room.png"));
    CHECK(folder.file_count() == 1);
    file.commit();
    CHECK(content(folder / "room.png") == bytes + "end");
    CHECK(folder.file_count() == 1);
}

TEST_CASE("without a commit nothing remains and the old file is as it was")
{
    const Folder folder;
    put(folder / "room.png", "old");
    {
        OutputFile file(folder / "room.png");
        file.write("new");
        OutputFile moved = std::move(file);
        moved.write("newer");
        CHECK(folder.file_count() == 2);
    }
    CHECK(content(folder / "room.png") == "old");
    CHECK(folder.file_count() == 1);
}

TEST_CASE("two files of one name are written side by side; the last commit stays")
{
    const Folder folder;
    OutputFile first(folder / "a.csv");
    OutputFile second(folder / "a.csv");
    second.write("second");
    first.write("first");
    second.commit();
    first.commit();
    CHECK(content(folder / "a.csv") == "first");
    CHECK(folder.file_count() == 1);
}

TEST_CASE("an existing file keeps its permissions, a new one gets what the umask leaves")
{
    const Folder folder;
    put(folder / "old.csv", "old");
    REQUIRE(chmod((folder / "old.csv").c_str(), 0640) == 0);
    const mode_t before = umask(027);
    for (const char* name : {"old.csv", "new.csv"})
        OutputFile(folder / name).commit();
    umask(before);
    CHECK(mode_of(folder / "old.csv") == 0640);
    CHECK(mode_of(folder / "new.csv") == 0640);
    REQUIRE(chmod((folder / "old.csv").c_str(), 0604) == 0);
    OutputFile(folder / "old.csv").commit();
    CHECK(mode_of(folder / "old.csv") == 0604);
}

TEST_CASE("a symbolic link is followed, also when it leads nowhere yet")
{
    const Folder folder;
    std::filesystem::create_directory(folder / "store");
    put(folder / "store/old.png", "old");
    std::filesystem::create_symlink("store/old.png", folder / "old.png");
    std::filesystem::create_symlink("old.png", folder / "twice.png");
    std::filesystem::create_symlink("store/new.png", folder / "new.png");
    for (const char* name : {"twice.png", "new.png"}) {
        OutputFile file(folder / name);
        file.write("fresh");
        file.commit();
        CHECK(std::filesystem::is_symlink(folder / name));
    }
    CHECK(content(folder / "store/old.png") == "fresh");
    CHECK(content(folder / "store/new.png") == "fresh");
    CHECK(folder.file_count() == 4);
}

TEST_CASE("what cannot be written is reported before the work, in one plain line")
{
    const Folder folder;
    put(folder / "file", "");
    std::filesystem::create_symlink("loop", folder / "loop");
    CHECK(error_of(folder / "none/room.png") ==
          "cannot write " + folder / "none/room.png" + ": No such file or directory");
    CHECK(error_of(folder / "") == "cannot write " + (folder / "") + ": Is a directory");
    CHECK(error_of(folder / "new/") == "cannot write " + (folder / "new/") + ": Is a directory");
    CHECK(error_of(folder / "file/room.png") == "cannot write " + (folder / "file/room.png") + ": Not a directory");
    CHECK(error_of(folder / "loop").find("cannot write ") == 0);
    CHECK(error_of("").find("cannot write ") == 0);
    CHECK(error_of(folder / std::string(300, 'n')).find("cannot write ") == 0);
    CHECK(folder.file_count() == 2);
}

TEST_CASE("protected files and folders are refused")
{
    if (geteuid() == 0)
        return; // nothing is protected from root
    const Folder folder;
    put(folder / "kept.png", "old");
    REQUIRE(chmod((folder / "kept.png").c_str(), 0444) == 0);
    CHECK(error_of(folder / "kept.png") == "cannot write " + (folder / "kept.png") + ": Permission denied");
    std::filesystem::create_directory(folder / "locked");
    REQUIRE(chmod((folder / "locked").c_str(), 0555) == 0);
    CHECK(error_of(folder / "locked/a.png") == "cannot write " + (folder / "locked/a.png") + ": Permission denied");
}

TEST_CASE("a name as long as the file system permits can be written")
{
    const Folder folder;
    const std::string name = folder / std::string(255, 'n');
    OutputFile file(name);
    file.write("x");
    file.commit();
    CHECK(content(name) == "x");
}

TEST_CASE("devices are written, not replaced")
{
    OutputFile null("/dev/null");
    null.write("gone");
    null.commit();
    CHECK(std::filesystem::is_character_file("/dev/null"));
    if (std::filesystem::exists("/dev/full")) {
        OutputFile full("/dev/full");
        CHECK_THROWS_WITH_AS(full.write("x"), "cannot write /dev/full: No space left on device", OutputError);
    }
}

TEST_CASE("a named pipe is written to its reader")
{
    prepare_process();
    const Folder folder;
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
    const int reader = open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
    OutputFile file(folder / "pipe");
    file.write("hello");
    char bytes[8] = {};
    CHECK(read(reader, bytes, sizeof bytes) == 5);
    CHECK(std::string(bytes) == "hello");
    close(reader);
    CHECK_THROWS_WITH_AS(file.write("x"), ("cannot write " + (folder / "pipe") + ": Broken pipe").c_str(), OutputError);
    CHECK(std::filesystem::is_fifo(folder / "pipe"));
}

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

} // namespace output_file_test

namespace part_file_test {

using namespace multipath;

TEST_CASE("two runs can write one target at a time; the last one to finish replaces it")
{
    const ScratchFolder folder;
    OutputFile first(folder.path("a.csv"));
    OutputFile second(folder.path("a.csv"));
    first.write("1");
    second.write("2");
    second.commit();
    CHECK(bytes_of_file(folder.path("a.csv")) == "2");
    first.commit();
    CHECK(bytes_of_file(folder.path("a.csv")) == "1");
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
    const Unfinished part = unfinished(folder.path("part"), folder.path("a"));
    Unfinished first = unfinished(folder.path("moved"), folder.path("b"));
    const Unfinished moved = std::move(first);
    Unfinished replaced = unfinished(folder.path("replaced"), folder.path("c"));
    replaced = unfinished(folder.path("missing"), folder.path("d"));
    unfinished(folder.path("finished"), folder.path("e"));

    settle_unfinished([](const char*) {});
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
    Unfinished complete = unfinished(folder.path("part-a"), folder.path("a"));
    multipath::complete(complete);
    const Unfinished moved = std::move(complete);
    const Unfinished incomplete = unfinished(folder.path("part-b"), folder.path("b"));
    Unfinished nowhere = unfinished(folder.path("part-c"), folder.path("no folder/c"));
    multipath::complete(nowhere);

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
            many.push_back(unfinished(folder.path(std::to_string(n)), folder.path("target")));
        }
        settle_unfinished([](const char*) {});
        CHECK_FALSE(std::filesystem::exists(folder.path("0")));
        CHECK_FALSE(std::filesystem::exists(folder.path("63")));
        CHECK(std::filesystem::exists(folder.path("64")));
    }
    folder.write("long", "");
    const Unfinished endless = unfinished(folder.path("long") + std::string(5000, '/'), folder.path("target"));
    settle_unfinished([](const char*) {});
    CHECK(std::filesystem::exists(folder.path("long")));
}

} // namespace part_file_test

#endif

#include "study/journal.h"

#include "scene/scratch_folder.h"

#include <csignal>
#include <doctest/doctest.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/resource.h>

namespace journal_test {

using namespace multipath;

namespace {

const ExecutionKey key{"global halton:2,7,3,5 4d sphere shuffled", 1u << 20, 3};
const Execution execution{123, 456, 0.1, 1.0 / 3.0, 2.0 / 7.0};

std::string text_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void write(const std::string& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
}

} // namespace

TEST_CASE("a journal gives back what was added, to the bit")
{
    const ScratchFolder folder;
    const std::string path = folder.path("runs.txt");
    {
        Journal journal(path, "identity");
        CHECK(!journal.find(key));
        journal.add(key, execution);
    }
    const Journal journal(path, "identity");
    const auto found = journal.find(key);
    REQUIRE(found);
    CHECK(found->local_lines == execution.local_lines);
    CHECK(found->global_lines == execution.global_lines);
    CHECK(found->mean_square == execution.mean_square);
    CHECK(found->relative == execution.relative);
    CHECK(found->seconds == execution.seconds);
    CHECK(!journal.find({key.curve, key.lines, 4}));
    CHECK(!journal.find({key.curve, key.lines + 1, 3}));
    CHECK(!journal.find({"global sobol 4d sphere shuffled", key.lines, 3}));
}

TEST_CASE("wherever a journal is cut off, what is left of it is used, and it can be continued")
{
    const ScratchFolder folder;
    const std::string path = folder.path("runs.txt");
    {
        Journal journal(path, "identity");
        journal.add({"a", 1, 0}, execution);
        journal.add({"a", 2, 0}, execution);
    }
    const std::string whole = text_of(path);
    const std::size_t second = whole.find("a\t2");
    for (std::size_t size = 0; size <= whole.size(); ++size) {
        write(path, whole.substr(0, size));
        Journal journal(path, "identity");
        CHECK(journal.find({"a", 1, 0}).has_value() == (size + 1 >= second));
        journal.add({"a", 3, 0}, execution);
        CHECK(Journal(path, "identity").find({"a", 3, 0}));
    }
}

TEST_CASE("a damaged run is not believed, the others are")
{
    const ScratchFolder folder;
    const std::string path = folder.path("runs.txt");
    {
        Journal journal(path, "identity");
        journal.add({"a", 1, 0}, execution);
        journal.add({"a", 2, 0}, execution);
    }
    std::string text = text_of(path);
    text[text.find("a\t1") + 8] ^= 1;
    write(path, text);
    const Journal journal(path, "identity");
    CHECK(!journal.find({"a", 1, 0}));
    CHECK(journal.find({"a", 2, 0}));
}

TEST_CASE("runs of another identity are not those of this study")
{
    const ScratchFolder folder;
    const std::string path = folder.path("runs.txt");
    {
        Journal journal(path, "one scene");
        journal.add(key, execution);
    }
    CHECK(!Journal(path, "another scene").find(key));
    CHECK(text_of(path) == "another scene\n");
}

TEST_CASE("a journal that cannot be written says so")
{
    CHECK_THROWS_WITH(Journal("/nonexistent/runs.txt", "identity"),
                      "cannot write /nonexistent/runs.txt: No such file or directory");
}

// A limit on the size of files stands for a full disk, which takes a part of the bytes too and refuses the rest.
TEST_CASE("a disk that is full is an error with its reason")
{
    const ScratchFolder folder;
    rlimit before = {};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small = {3, before.rlim_max};
    REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
    const std::string path = folder.path("runs.txt");
    CHECK_THROWS_WITH_AS(Journal(path, "study 1"), ("cannot write " + path + ": File too large").c_str(),
                         std::runtime_error);
    setrlimit(RLIMIT_FSIZE, &before);
}

} // namespace journal_test

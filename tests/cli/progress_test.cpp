// What a user sees of the progress: the bytes on the standard error stream.

#include "cli/progress.h"

#include "scene/scratch_folder.h"

#include <cstdio>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <thread>
#include <unistd.h>

namespace progress_test {

using namespace multipath;

namespace {

/// What is printed on standard error when half of the work is done after so long that there is something to show.
std::string printed_at_half(ProgressStyle style)
{
    const ScratchFolder folder;
    const std::string path = folder.write("err", "");
    std::fflush(stderr);
    const int kept = dup(STDERR_FILENO);
    const int file = open(path.c_str(), O_WRONLY);
    REQUIRE(dup2(file, STDERR_FILENO) >= 0);
    {
        Progress progress("shooting", style);
        std::this_thread::sleep_for(std::chrono::milliseconds(110));
        progress(0.5);
    }
    std::fflush(stderr);
    dup2(kept, STDERR_FILENO);
    close(kept);
    close(file);
    std::ifstream printed(path);
    return {std::istreambuf_iterator<char>(printed), {}};
}

} // namespace

TEST_CASE("a line shows the share of the work that is done, and is wiped out at the end")
{
    const std::string text = printed_at_half(ProgressStyle::redrawn);
    CHECK(text.find("\rshooting: 50 %, about 0 s left") == 0);
    REQUIRE(text.size() > 4);
    CHECK(text.substr(text.size() - 4) == "\r\033[K");
}

TEST_CASE("who wants no progress sees none")
{
    CHECK(printed_at_half(ProgressStyle::none).empty());
}

} // namespace progress_test

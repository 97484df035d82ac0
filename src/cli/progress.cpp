#include "cli/progress.h"

#include "base/platform/process.h"
#include "base/text_format.h"

#include <cstdio>
#include <utility>

namespace multipath {

ProgressStyle progress_style(const CommandLine& line)
{
    if (line.has("quiet"))
        return ProgressStyle::none;
    return standard_error_is_terminal() ? ProgressStyle::redrawn : ProgressStyle::lines;
}

Progress::Progress(std::string what, ProgressStyle style) : what_(std::move(what)), style_(style) {}

Progress::~Progress()
{
    if (redrawn_)
        std::fputs("\r\033[K", stderr);
}

void Progress::operator()(double done)
{
    if (style_ == ProgressStyle::none)
        return;
    const Clock::time_point now = Clock::now();
    const auto pause = style_ == ProgressStyle::redrawn ? std::chrono::milliseconds(100) : std::chrono::seconds(10);
    if (now - last_shown_ < pause)
        return;
    last_shown_ = now;

    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const std::string left = done > 0.0 ? format(", about %.0f s left", elapsed * (1.0 - done) / done) : "";
    redrawn_ = style_ == ProgressStyle::redrawn;
    std::fprintf(stderr, "%s%s: %.0f %%%s%s", redrawn_ ? "\r" : "", what_.c_str(), 100.0 * done, left.c_str(),
                 redrawn_ ? "\033[K" : "\n");
    std::fflush(stderr);
}

} // namespace multipath

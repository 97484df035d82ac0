#include "cli/progress.h"

#include "base/platform/process.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace multipath {

ProgressStyle progress_style(const CommandLine& line)
{
    if (line.has("quiet"))
        return ProgressStyle::none;
    return standard_error_is_terminal() ? ProgressStyle::bar : ProgressStyle::lines;
}

Progress::Progress(std::string what, ProgressStyle style) : what_(std::move(what)), style_(style) {}

Progress::~Progress()
{
    if (bar_drawn_)
        std::fputs("\r\033[K", stderr);
}

void Progress::operator()(double done)
{
    if (style_ == ProgressStyle::none)
        return;
    const Clock::time_point now = Clock::now();
    const auto pause = style_ == ProgressStyle::bar ? std::chrono::milliseconds(100) : std::chrono::seconds(10);
    if (now - last_shown_ < pause)
        return;
    last_shown_ = now;

    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double left = done > 0.0 ? elapsed * (1.0 - done) / done : 0.0;
    if (style_ == ProgressStyle::lines) {
        std::fprintf(stderr, "%s: %.0f %%, about %.0f s left\n", what_.c_str(), 100.0 * done, left);
        return;
    }
    const int width = 30;
    const int filled = std::clamp(static_cast<int>(done * width), 0, width);
    const std::string bar(static_cast<std::size_t>(filled), '#');
    std::fprintf(stderr, "\r%s [%-*s] %3.0f %%  %.0f s left\033[K", what_.c_str(), width, bar.c_str(), 100.0 * done,
                 left);
    std::fflush(stderr);
    bar_drawn_ = true;
}

} // namespace multipath

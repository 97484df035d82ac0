#pragma once

#include "cli/options/command_line.h"

#include <chrono>
#include <string>

namespace multipath {

enum class ProgressStyle {
    none,    ///< nothing is shown
    redrawn, ///< one line that is redrawn, for a terminal
    lines,   ///< a line at most every ten seconds, for a log file
};

/// One line redrawn if stderr is a terminal, lines otherwise; none with --quiet.
ProgressStyle progress_style(const CommandLine& line);

/// Shows on stderr how much of the work is done and how long the rest will take. A run of a few seconds prints no
/// lines.
class Progress
{
public:
    /// `what`: name of the work, which begins every line.
    Progress(std::string what, ProgressStyle style);
    ~Progress(); ///< clears the line that is redrawn

    void operator()(double done); ///< `done`: share of the work, 0 ... 1

private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    ProgressStyle style_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_shown_ = start_;
    bool redrawn_ = false; ///< a line stands on the terminal
};

} // namespace multipath

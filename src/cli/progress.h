#pragma once

#include "cli/options/command_line.h"

#include <chrono>
#include <string>

namespace multipath {

enum class ProgressStyle {
    none,
    bar,   ///< one line that is drawn over again: for a terminal
    lines, ///< a plain line now and then: for a log file
};

/// `--progress`: a definition for the tables.
Option progress_option();

/// The style that the options --progress and --quiet ask for: a bar when stderr is a terminal, otherwise lines, which a
/// run of some seconds never gets to see.
ProgressStyle progress_style(const CommandLine& line);

/// Shows on stderr how far the work is and how long it will take.
class Progress
{
public:
    Progress(std::string what, ProgressStyle style);
    ~Progress(); ///< clears the bar

    void show(double done); ///< 0 ... 1

private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    ProgressStyle style_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_shown_ = start_;
    bool bar_drawn_ = false;
};

} // namespace multipath

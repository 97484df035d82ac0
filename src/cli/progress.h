#pragma once

#include "cli/options/command_line.h"

#include <chrono>
#include <string>

namespace multipath {

enum class ProgressStyle {
    none,
    bar,   ///< one line that is redrawn, for a terminal
    lines, ///< a plain line every ten seconds, for a log file
};

/// The option --progress for the tables of commands.
Option progress_option();

/// The style that the options --progress and --quiet ask for: a bar if stderr is a terminal, lines otherwise. A run of
/// a few seconds prints no lines.
ProgressStyle progress_style(const CommandLine& line);

/// Shows on stderr how much of the work is done and how long the rest will take.
class Progress
{
public:
    Progress(std::string what, ProgressStyle style);
    ~Progress(); ///< clears the bar

    void show(double done); ///< share of the work, 0 ... 1

private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    ProgressStyle style_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_shown_ = start_;
    bool bar_drawn_ = false;
};

} // namespace multipath

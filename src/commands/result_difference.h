#pragma once

#include "commands/recorded_command.h"

#include <string>

namespace multipath {

/// How a file that a command has written again differs from the first one, apart from their records.
struct ResultDifference
{
    std::string text{};      ///< what differs, in one line of words; empty: nothing that has to be the same
    bool only_times = false; ///< nothing but what changes from run to run
};

/// `then` and `now` are the bytes of two files of one kind, `path` is what messages call the first. Throws InputError
/// for a table that is damaged.
ResultDifference result_difference(RecordedFile kind, const std::string& then, const std::string& now,
                                   const std::string& path);

// The same for single kinds.

/// Cell by cell; those of a column `seconds` are times.
ResultDifference table_difference(const std::string& then, const std::string& now, const std::string& path);
ResultDifference ppm_difference(const std::string& then, const std::string& now);
ResultDifference png_difference(const std::string& then, const std::string& now);
ResultDifference drawing_difference(const std::string& then, const std::string& now);
ResultDifference ply_difference(const std::string& then, const std::string& now);
ResultDifference glb_difference(const std::string& then, const std::string& now);
ResultDifference obj_difference(const std::string& then, const std::string& now);

/// The data of two pages of a room; how these look is no result.
ResultDifference page_difference(const std::string& then, const std::string& now);

/// What report_html() marks as changing from run to run, and figures with seconds across, are times.
ResultDifference report_difference(const std::string& then, const std::string& now);

} // namespace multipath

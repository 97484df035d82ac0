#pragma once

#include <string>
#include <vector>

namespace multipath {

/// One command of the reproduction.
struct PaperStep
{
    /// Words of the command line from the name of the command on, without outputs and without options that do not
    /// change the result.
    std::vector<std::string> words;
    std::vector<std::string> outputs; ///< names of the files that the command makes, without a folder
};

/// The command line as a user would type it, from "multipath" on, with one `-o` for each output. Words are not quoted.
std::string typed(const PaperStep& step);

/// The commands for all tables and figures of the paper, and for the results beyond it, in the order in which they must
/// be run: a later step may read a file that an earlier one has written into `folder`. The scenes are the bundled ones.
/// The quick set differs from the full one only in the numbers of lines and executions.
std::vector<PaperStep> paper_steps(bool quick, const std::string& folder);

} // namespace multipath

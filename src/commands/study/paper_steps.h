#pragma once

#include <string>
#include <vector>

namespace multipath {

/// One command of the paper's reproduction.
struct PaperStep
{
    std::vector<std::string> words;   ///< of the command, without outputs and what does not change the result
    std::vector<std::string> outputs; ///< names of the files that it makes
};

/// The words as a user would type them, outputs included.
std::string typed(const PaperStep& step);

/// All tables and figures of the paper and what goes beyond it, in the order in which they are made: a later step may
/// read what an earlier one has written into `folder`. `scenes` is the folder of the bundled scenes. The quick set
/// differs in the numbers of lines and executions alone.
std::vector<PaperStep> paper_steps(bool quick, const std::string& scenes, const std::string& folder);

} // namespace multipath

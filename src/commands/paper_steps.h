#pragma once

#include <string>
#include <vector>

namespace multipath {

/// The command lines for all tables and figures of the paper, and for the results beyond it, in the order in which they
/// must be run, each from the name of the command on, with one "-o NAME" for each file that it makes. FOLDER/NAME is a
/// file that an earlier one has made. Options that do not change the result are left out. The scenes are the bundled
/// ones. The quick set differs from the full one only in the numbers of lines and executions.
std::vector<std::string> paper_steps(bool quick);

} // namespace multipath

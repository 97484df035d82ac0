#pragma once

#include "cli/help_text.h"

#include <vector>

namespace multipath {

/// All topics of `multipath help`, in the order in which they are best read.
std::vector<HelpTopic> help_topics();

} // namespace multipath

#pragma once

#include "commands/picture_options.h"
#include "commands/story_text.h"
#include "radiosity/solve.h"

#include <string>
#include <vector>

namespace multipath {

/// The page (.html) to walk through a solved room: the solution, what fewer lines would have given, for which it solves
/// again, and the first lines of the run. `comments` say where it comes from.
std::string solution_page(const ToldRun& run, const Solution& solution, const PictureOptions& picture_options,
                          const std::vector<std::string>& comments, const ProgressCallback& progress);

} // namespace multipath

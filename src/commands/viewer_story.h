#pragma once

#include "commands/story_text.h"
#include "viewer/viewer_content.h"

#include <vector>

namespace multipath {

/// The first hundred lines of every kind that the run casts, or fewer where it has not so many: rays of the first shot
/// and global lines, or particles. For the method `reuse`, which only counts its lines, those of the method `extended`.
std::vector<ViewerChapter> viewer_story(const ToldRun& run);

} // namespace multipath

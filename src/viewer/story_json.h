#pragma once

#include "export/json.h"
#include "viewer/viewer_content.h"

namespace multipath {

/// A chapter of the story as the page reads it: every line as a chain of points, with the power that goes along its
/// stretches. Numbers have six digits: they are looked at, not computed with.
JsonObject story_json(const ViewerChapter& chapter);

} // namespace multipath

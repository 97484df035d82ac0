#pragma once

#include "scene/scene.h"
#include "viewer/viewer_content.h"

#include <string>

namespace multipath {

/// Everything that the page shows, as the JSON document that its scripts read (docs/viewer.md). It holds surfaces, not
/// patches: the page cuts them as Tessellation does.
std::string room_json(const Scene& scene, const ViewerContent& content);

} // namespace multipath

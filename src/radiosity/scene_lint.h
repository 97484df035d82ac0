#pragma once

#include "radiosity/scene_report.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// Something about a scene that its owner should know.
struct Finding
{
    std::string kind;        ///< one word for programs, such as "behind" or "leak"
    bool makes_wrong_result; ///< otherwise a remark
    std::string place;       ///< "room.obj:12" or "room.mtl:3"; the scene's file when it has no place
    std::string message;     ///< one line: what it is and what helps
};

/// All that is suspicious about the physics of a scene: light that is lost, sources that light nothing, faces that hide
/// each other, materials and scale that are not of this world. Wrong results first.
std::vector<Finding> lint(const Scene& scene, const SceneReport& report);

} // namespace multipath

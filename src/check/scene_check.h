#pragma once

#include "check/scene_report.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// A finding that concerns at least this share of the power of the sources, or of the area of the surfaces, makes the
/// result wrong. Smaller ones change less than one step of an 8-bit picture, and less than the noise of most runs.
constexpr double share_that_matters = 0.005;

/// A diagnostic about a scene. Findings of the same cause are merged into one, with their number in the message.
struct Finding
{
    std::string kind;        ///< one word for programs, such as "behind" or "leak"
    bool makes_wrong_result; ///< true for an error, false for a remark
    std::string place;   ///< file and line of the first case, such as "room.obj:12"; the file alone if it has no line
    std::string message; ///< one line: the fault and its remedy
    double power_share = 0.0; ///< share [1] of the source power concerned; 0 for a finding without a power
    double area_share = 0.0;  ///< share [1] of the area of all surfaces; 0 for a finding without an area
};

/// Diagnoses what is suspicious about the physics of a scene: lost light, sources that light nothing, faces that hide
/// each other, implausible materials and scale. Errors come first, then larger shares of power, then of area.
std::vector<Finding> findings_of(const Scene& scene, const SceneReport& report);

/// True if no emitter lights anything, but some would if all faces were flipped: a room modelled inside out.
bool is_inside_out(const Scene& scene, const LineSurvey& survey);

} // namespace multipath

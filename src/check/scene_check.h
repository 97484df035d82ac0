#pragma once

#include "check/scene_report.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// Least share [1] of the power of the sources, or of the area of the surfaces, at which a finding is an error: the
/// fault makes the result wrong. A fault with a smaller share changes the result by less than one step of an 8-bit
/// picture, and by less than the noise of most runs. The share does not matter for some kinds: "trapped" is always an
/// error, while "open", "reflectance" and findings without a share are always remarks.
constexpr double share_that_matters = 0.005;

/// A diagnostic about a scene. Findings of the same cause are merged into one, whose message says how many there are.
struct Finding
{
    std::string kind;        ///< identifier for programs, such as "behind" or "unused-material"
    bool makes_wrong_result; ///< true for an error, false for a remark
    std::string place; ///< file and line of the first or worst case ("room.obj:12"); the file alone if no line is known
    std::string message;      ///< one line: the fault, and its remedy if it needs one
    double power_share = 0.0; ///< share [1] of the source power that is concerned; 0 if the finding is not about power
    double area_share = 0.0;  ///< share [1] of the total surface area that is concerned; 0 if not about area
};

/// Diagnoses what is suspicious about the physics of a scene: lost light, sources that light nothing, faces that hide
/// each other, implausible materials and scale. `report` must be the result of report_on for this scene. Errors come
/// before remarks; within each group, findings are sorted by descending share of power, then of area.
std::vector<Finding> findings_of(const Scene& scene, const SceneReport& report);

/// True if no emitter lights anything, but some emitter would if all faces were flipped: a room modelled inside out.
/// Always false for a two-sided scene.
bool is_inside_out(const Scene& scene, const LineSurvey& survey);

} // namespace multipath

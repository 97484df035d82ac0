#pragma once

#include "check/scene_report.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// The share of the power of the sources, or of the area for a finding without a power, from which a finding makes a
/// wrong result: less than one step of an 8-bit picture, and than what most runs leave as noise.
constexpr double share_that_matters = 0.005;

/// Something about a scene that its owner should know. Equal findings are one, with a count in the message.
struct Finding
{
    std::string kind;         ///< one word for programs, such as "behind" or "leak"
    bool makes_wrong_result;  ///< otherwise a remark
    std::string place;        ///< "room.obj:12" or "room.mtl:3", the first; the scene's file when it has no place
    std::string message;      ///< one line: what it is and what helps
    double power_share = 0.0; ///< [1] of the power of the sources that it concerns; 0 for a finding without a power
    double area_share = 0.0;  ///< [1] of the area of all surfaces; 0 for a finding without an area
};

/// All that is suspicious about the physics of a scene: light that is lost, sources that light nothing, faces that hide
/// each other, materials and scale that are not of this world. Wrong results first, then by shares of power and area.
std::vector<Finding> findings_of(const Scene& scene, const SceneReport& report);

/// True if no emitter lights anything, but some would with all faces turned over: a room modelled inside out.
bool is_inside_out(const Scene& scene, const LineSurvey& survey);

} // namespace multipath

#pragma once

#include "base/errors.h"
#include "check/scene_report.h"
#include "geometry/surface.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

struct CoincidentPairs
{
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs; ///< indices of surfaces; first < second in each pair
    /// False if find_coincident_faces() found more than `most` pairs, or tested only some of the surfaces.
    bool complete = true;
};

/// Finds overlapping coplanar surfaces that face the same way, of which lines meet the smaller one, a convention of
/// this program. Tests sample points of each surface; returns at most `most` pairs. Small overlaps between the sample
/// points are missed. If very many surfaces lie close together, only some of them are tested.
CoincidentPairs find_coincident_faces(const Scene& scene, std::size_t most);

/// Indices, ascending, of the surfaces with an open edge: one that no other surface has in the opposite direction.
/// Light can leak through such an edge out of a room that is meant to be closed. A long edge along several shorter ones
/// (a T-junction) counts as open. Corners are equal if they snap to the same grid point (snapped()).
std::vector<std::uint32_t> surfaces_with_open_edges(const SurfaceList& surfaces);

/// A diagnostic about a scene. Findings of the same cause are merged into one, whose message says how many there are.
struct Finding
{
    std::string kind;  ///< identifier for programs, such as "behind" or "unused-material"
    std::string place; ///< file and line of the first or worst case ("room.obj:12"); the file alone if no line is known
    std::string message;      ///< one line: the fault, and what to change in the file if that is needed
    double power_share = 0.0; ///< share [1] of the source power that is concerned; 0 if the finding is not about power
    double area_share = 0.0;  ///< share [1] of the total surface area that is concerned; 0 if not about area
    std::vector<Advice> advice = {}; ///< what helps without a change in the file
    bool makes_wrong_result = false; ///< true for an error, false for a remark
};

/// Diagnoses what is suspicious about the physics of a scene: lost light, sources that light nothing, faces that hide
/// each other, implausible materials and scale. `report` must be the result of report_on for this scene. Errors come
/// before remarks; within each group, findings are sorted by descending share of power, then of area.
std::vector<Finding> findings_of(const Scene& scene, const SceneReport& report);

} // namespace multipath

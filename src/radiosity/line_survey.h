#pragma once

#include "geometry/convex_hull.h"
#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// What global lines meet in a scene, counted.
struct LineSurvey
{
    std::uint64_t lines = 0;           ///< chords of the sphere around the scene
    std::uint64_t hull_tests = 0;      ///< of them, those compared with the convex hull of the scene
    std::uint64_t lines_into_hull = 0; ///< of these, those that meet it
    std::uint64_t crossings = 0;       ///< of lines with surfaces

    /// Per surface, in both directions of every line:
    std::vector<std::uint64_t> departures; ///< the line leaves a patch of it
    std::vector<std::uint64_t> arrivals;   ///< of the departures, those that reach another patch
    std::vector<std::uint64_t> escapes;    ///< of the departures, those that meet nothing
    std::vector<std::uint64_t> met_behind; ///< departures from anywhere that meet this surface where it has no patch
    std::vector<std::uint64_t>
        back_to_back; ///< the line leaves its back, which has no patch, and meets another such back
};

/// Casts `lines` random chords, always the same. `hull`: of the scene.
LineSurvey survey_lines(const Scene& scene, const ConvexHull& hull, std::uint64_t lines, int threads);

} // namespace multipath

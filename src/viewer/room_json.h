#pragma once

#include "export/json.h"
#include "scene/scene.h"
#include "viewer/viewer_content.h"

#include <cstdint>
#include <string>
#include <vector>

namespace multipath {

/// Smooth values at the corners of all patches, as pictures interpolate them (SmoothShading). Most patches agree on the
/// value at a point of their surface's grid; those that do not, as on both sides of a wall that stands there, have one
/// of their own.
struct CornerValues
{
    std::vector<Rgb> shared;           ///< at every grid point, surface by surface, fronts first; row by row with j
    std::vector<std::uint32_t> places; ///< 4 * patch + number of its corner, in the order of Scene::corners()
    std::vector<Rgb> own;              ///< at these places
};

/// Sources have none of their own: they are never shown smooth.
CornerValues corner_values(const Scene& scene, const std::vector<Rgb>& values_per_patch, int threads);

/// A chapter of the story as the page reads it: every line as a chain of points, with the power that goes along its
/// stretches. Numbers have six digits: they are looked at, not computed with.
JsonObject story_json(const ViewerChapter& chapter);

/// Everything that the page shows, as the JSON document that its scripts read (docs/viewer.md). It holds surfaces, not
/// patches: the page cuts them as Tessellation does.
std::string room_json(const Scene& scene, const ViewerContent& content);

} // namespace multipath

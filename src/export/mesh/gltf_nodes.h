#pragma once

#include "export/json.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// A pinhole camera.
struct GlbCamera
{
    std::string name;
    Vec3 eye;             ///< [m]
    Vec3 target;          ///< [m] point in the middle of the picture
    Vec3 up;              ///< upward direction, not parallel to the viewing direction
    double field_of_view; ///< [degrees] vertical
};

/// The nodes of a glTF file and what they refer to.
struct GlbNodes
{
    std::vector<JsonObject> nodes;   ///< the meshes, then the cameras, then the node that moves all of them, if any
    std::vector<JsonObject> cameras; ///< their near planes depend on the size of the scene
    std::vector<double> roots;       ///< indices of the nodes that have no parent
};

/// The nodes for meshes with these names, whose positions are relative to mesh_origin(), and for cameras. One more node
/// moves all of them back from there and turns `up` to y, as glTF wants it; there is none if it would change nothing.
GlbNodes glb_nodes(const Scene& scene, const std::vector<std::string>& mesh_names,
                   const std::vector<GlbCamera>& cameras, Vec3 up);

} // namespace multipath

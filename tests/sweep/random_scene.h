#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <string>

namespace multipath {

/// A scene made at random, and how finely it is to be solved.
struct RandomScene
{
    Scene scene;
    std::uint64_t lines; ///< 1 to 100 for each patch, and at least 64
    std::string kind;    ///< what it is, in words: "open room, sky, two-sided, white, far"
    /// True if every surface sees nothing but a uniform sky, so that B = rho E.
    bool convex;
};

/// The scene of a number. Numbers in a row go through closed and open rooms, bodies on the ground, streets, sheets,
/// single bodies, terrain of triangles and rooms with a window, lit by lamps, the sky, the sun or several of them; at
/// random they are two-sided, turned, tiny, huge or far from the origin, and have white, dark and textured surfaces,
/// faces that coincide, and boxes that stand on each other or cross. There are 1 to `most_patches` patches, if the
/// surfaces allow it.
RandomScene random_scene(std::uint64_t key, std::uint32_t most_patches);

} // namespace multipath

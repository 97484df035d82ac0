#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <string>

// Words for what is traced.

namespace multipath {

/// "0.7", or "(0.7, 0.6, 0.5)" where the channels differ.
std::string colour_text(Rgb colour);
/// "0.7 W", or "(0.7, 0.6, 0.5) W" where the channels differ.
std::string watts(Rgb power);
/// "(1.234, 0.500, -2.000)"
std::string point_text(Vec3 point);
/// "1 patch", "1,400 patches"
std::string counted(std::uint64_t count, const char* one, const char* many);

/// "table_top (line 12)": the group, or the material if the group has no name, and the line of the scene file.
std::string surface_name(const Scene& scene, std::uint32_t surface);
/// "patch 12 of table_top (line 12)", with ", its back" for a patch on the back of a surface.
std::string patch_name(const Scene& scene, std::uint32_t patch);
/// Fate of power that no patch receives: `where` is Segment::behind or Segment::outside.
std::string loss(std::uint32_t where);
/// " to patch 3 of floor (line 4)", or the fate of the power if `to` is no patch.
std::string destination(const Scene& scene, std::uint32_t to);

} // namespace multipath

#pragma once

#include <string>

namespace multipath {

/// Lines and rays through scenes of several sizes: every kernel, in blocks and one by one, beside Embree where it is at
/// hand. Few rectangles; many triangles; the surfaces of a file.
void compare_rooms();
void compare_soups();
void compare_file(const std::string& path);

} // namespace multipath

#pragma once

namespace multipath {

/// Lines and rays through scenes of several sizes: every kernel, in blocks and one by one, beside Embree where it is at
/// hand.
void compare_crossings();

} // namespace multipath

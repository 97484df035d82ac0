// The maps in plain C++, for any processor: one point after the other.

#include "parallel/double_lanes_plain.h"
#include "sampling/warp_kernel.h"

#include "sampling/lane_warp.inl"

namespace multipath {

const WarpKernel plain_warp_kernel = {"plain", uniform_sphere, cosine_hemisphere};

} // namespace multipath

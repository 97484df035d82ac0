#include "geometry/filter_line.h"

#include <algorithm>

namespace multipath {

FilterFrame::FilterFrame(const Bounds& box)
    : centre_(box.centre()),
      radius_(0.5 * box.diagonal()),
      scale_(1.0 / radius_),
      reach_(std::clamp(100.0 * scale_ * length(centre_), 1e4, 1e7)),
      centre_square_(dot(scale_ * centre_, scale_ * centre_)),
      half_size_(0.5 * scale_ * box.size())
{
}

} // namespace multipath

#pragma once

#include "export/svg_plot.h"

namespace multipath {

/// An axis whose values are decimal logarithms, around data within [low, high] with a little room at both ends. Powers
/// of ten have ticks with labels; so have 2 and 5 times these if there is at most one power. The minor ticks stand at
/// the others of 2, 3, ... 9 times them or, where there are too many powers for all to have labels, at those without.
/// An empty interval, low > high, counts as [0, 1].
PlotAxis log_axis(const std::string& title, double low, double high);

} // namespace multipath

#pragma once

#include "export/svg_element.h"

#include <vector>

// Where there is room for what a drawing needs besides its data. Shapes and obstacles are given as points close to each
// other compared with the distance that should stay free.

namespace multipath {

/// [px]
struct SvgBox
{
    double left;
    double top;
    double right;
    double bottom;
};

/// Points of a box's edges and inside, at most `step` px apart.
std::vector<SvgPoint> points_of_box(const SvgBox& box, double step);

/// Points of the straight line, both ends included, at most `step` px apart.
std::vector<SvgPoint> points_of_line(SvgPoint from, SvgPoint to, double step);

struct ClearPlace
{
    SvgPoint shift;   ///< [px] by which to move the shape
    double clearance; ///< [px] least distance from an obstacle there
};

/// [px] from the shape to the nearest obstacle; infinite without obstacles.
double clearance(const std::vector<SvgPoint>& shape, const std::vector<SvgPoint>& obstacles);

/// Of a grid of shifts that keep the shape within `room`, the one that leaves it farthest from the obstacles. A shape
/// larger than the room stays at its left or top edge.
ClearPlace clear_place(const std::vector<SvgPoint>& shape, const std::vector<SvgPoint>& obstacles, const SvgBox& room);

} // namespace multipath

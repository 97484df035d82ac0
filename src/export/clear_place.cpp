#include "export/clear_place.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath {

namespace {

constexpr int grid_size = 24; // shifts per direction
constexpr double infinite = std::numeric_limits<double>::infinity();

int pieces_of(double length, double step)
{
    return std::max(1, static_cast<int>(std::ceil(length / step)));
}

/// The square of the clearance of the moved shape, or any smaller one than `best` if it is smaller than that.
double square_clearance(const std::vector<SvgPoint>& shape, SvgPoint shift, const std::vector<SvgPoint>& obstacles,
                        double best)
{
    double least = infinite;
    for (const SvgPoint p : shape)
        for (const SvgPoint q : obstacles) {
            const double across = p.x + shift.x - q.x;
            const double down = p.y + shift.y - q.y;
            least = std::min(least, across * across + down * down);
            if (least < best)
                return least;
        }
    return least;
}

SvgBox box_around(const std::vector<SvgPoint>& shape)
{
    SvgBox box{infinite, infinite, -infinite, -infinite};
    for (const SvgPoint p : shape)
        box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x), std::max(box.bottom, p.y)};
    return box;
}

} // namespace

std::vector<SvgPoint> points_of_box(const SvgBox& box, double step)
{
    const int pieces = pieces_of(box.bottom - box.top, step);
    std::vector<SvgPoint> points;
    for (int i = 0; i <= pieces; ++i) {
        const double y = box.top + (box.bottom - box.top) * i / pieces;
        const std::vector<SvgPoint> row = points_of_line({box.left, y}, {box.right, y}, step);
        points.insert(points.end(), row.begin(), row.end());
    }
    return points;
}

std::vector<SvgPoint> points_of_line(SvgPoint from, SvgPoint to, double step)
{
    const int pieces = pieces_of(std::hypot(to.x - from.x, to.y - from.y), step);
    std::vector<SvgPoint> points;
    for (int i = 0; i <= pieces; ++i)
        points.push_back({from.x + (to.x - from.x) * i / pieces, from.y + (to.y - from.y) * i / pieces});
    return points;
}

double clearance(const std::vector<SvgPoint>& shape, const std::vector<SvgPoint>& obstacles)
{
    return std::sqrt(square_clearance(shape, {0.0, 0.0}, obstacles, 0.0));
}

ClearPlace clear_place(const std::vector<SvgPoint>& shape, const std::vector<SvgPoint>& obstacles, const SvgBox& room)
{
    const SvgBox box = box_around(shape);
    const double play_across = std::max(0.0, room.right - room.left - (box.right - box.left));
    const double play_down = std::max(0.0, room.bottom - room.top - (box.bottom - box.top));
    SvgPoint place{};
    double best = -1.0;
    for (int row = 0; row <= grid_size; ++row)
        for (int column = 0; column <= grid_size; ++column) {
            const SvgPoint shift = {room.left - box.left + play_across * column / grid_size,
                                    room.top - box.top + play_down * row / grid_size};
            const double square = square_clearance(shape, shift, obstacles, best);
            if (square > best) {
                best = square;
                place = shift;
            }
        }
    return {place, std::sqrt(best)};
}

} // namespace multipath

// Ear clipping. A corner of a simple polygon is an ear if it is convex and no other part of the polygon reaches into
// the triangle of the corner and its two neighbours. The triangle of an ear can be cut off. Every simple polygon has an
// ear (Meisters 1975), so n - 2 cuts are enough. Only reflex corners have to be tested against a triangle, and cutting
// off an ear affects only its two neighbours, so each corner is tested about three times. The polygon is projected
// along the largest component of its normal: coordinates are copied, not computed, so corners that are straight or
// equal in space stay so in the projection.

#include "scene/obj/polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace multipath {

namespace {

struct Point2
{
    double x = 0.0;
    double y = 0.0;
};

bool operator==(Point2 a, Point2 b)
{
    return a.x == b.x && a.y == b.y;
}

/// Twice the area of the triangle, positive if it is counter-clockwise.
double turn(Point2 a, Point2 b, Point2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Drops the coordinate of the largest component of the normal; front faces stay counter-clockwise.
std::vector<Point2> project(const std::vector<Vec3>& corners, Vec3 normal)
{
    const double x = std::abs(normal.x);
    const double y = std::abs(normal.y);
    const double z = std::abs(normal.z);
    const bool along_x = x >= y && x >= z;
    const bool along_y = !along_x && y >= z;
    const bool turned_away = (along_x ? normal.x : along_y ? normal.y : normal.z) < 0.0;

    std::vector<Point2> points;
    points.reserve(corners.size());
    for (const Vec3 p : corners) {
        const Point2 q = along_x ? Point2{p.y, p.z} : along_y ? Point2{p.z, p.x} : Point2{p.x, p.y};
        points.push_back(turned_away ? Point2{q.y, q.x} : q);
    }
    return points;
}

class EarClipper
{
public:
    EarClipper(std::vector<Point2> points, double smallest_turn);
    Triangulation clip();

private:
    enum class State : char { untested, ear, no_ear };

    double turn_at(std::uint32_t i) const { return turn(points_[previous_[i]], points_[i], points_[next_[i]]); }
    bool is_ear(std::uint32_t i);
    bool contains_reflex_corner(std::uint32_t i) const;
    void cut_off(std::uint32_t i);
    void neighbour_changed(std::uint32_t i);
    void fan_rest(std::uint32_t first);

    std::vector<Point2> points_;
    double smallest_turn_;
    std::vector<std::uint32_t> next_, previous_; ///< circular list of the remaining corners
    std::vector<State> state_;
    std::vector<std::uint32_t> reflex_;
    bool touching_counts_ = true; ///< a corner on the border of a triangle counts as inside
    Triangulation result_;
};

EarClipper::EarClipper(std::vector<Point2> points, double smallest_turn)
    : points_(std::move(points)),
      smallest_turn_(smallest_turn),
      next_(points_.size()),
      previous_(points_.size()),
      state_(points_.size(), State::untested)
{
    const std::uint32_t count = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        next_[i] = (i + 1) % count;
        previous_[i] = (i + count - 1) % count;
    }
    for (std::uint32_t i = 0; i < count; ++i)
        if (turn_at(i) < -smallest_turn_)
            reflex_.push_back(i);
    result_.triangles.reserve(count - 2);
}

Triangulation EarClipper::clip()
{
    std::uint32_t i = 0;
    std::size_t left = points_.size();
    for (std::size_t tested = 0; left >= 3;) {
        if (is_ear(i)) {
            cut_off(i);
            // Skipping the neighbour until the next round avoids slivers in round polygons.
            i = next_[next_[i]];
            --left;
            tested = 0;
        } else if (++tested <= left) {
            i = next_[i];
        } else if (touching_counts_) {
            touching_counts_ = false;
            std::fill(state_.begin(), state_.end(), State::untested);
            tested = 0;
        } else {
            fan_rest(i);
            break;
        }
    }
    return std::move(result_);
}

bool EarClipper::is_ear(std::uint32_t i)
{
    if (state_[i] == State::untested) {
        const double size = turn_at(i);
        const bool straight = std::abs(size) <= smallest_turn_;
        state_[i] = straight || (size > 0.0 && !contains_reflex_corner(i)) ? State::ear : State::no_ear;
    }
    return state_[i] == State::ear;
}

bool EarClipper::contains_reflex_corner(std::uint32_t i) const
{
    const Point2 a = points_[previous_[i]];
    const Point2 b = points_[i];
    const Point2 c = points_[next_[i]];
    for (const std::uint32_t r : reflex_) {
        const Point2 p = points_[r];
        const double least = std::min({turn(a, b, p), turn(b, c, p), turn(c, a, p)});
        // Corners at the same point are the ends of a bridge that joins a hole to the outline.
        if ((touching_counts_ ? least >= 0.0 : least > smallest_turn_) && !(p == a || p == b || p == c))
            return true;
    }
    return false;
}

void EarClipper::cut_off(std::uint32_t i)
{
    const std::uint32_t before = previous_[i];
    const std::uint32_t after = next_[i];
    if (turn_at(i) > smallest_turn_)
        result_.triangles.push_back({before, i, after});
    next_[before] = after;
    previous_[after] = before;
    reflex_.erase(std::remove(reflex_.begin(), reflex_.end(), i), reflex_.end());
    neighbour_changed(before);
    neighbour_changed(after);
}

void EarClipper::neighbour_changed(std::uint32_t i)
{
    state_[i] = State::untested;
    if (turn_at(i) >= -smallest_turn_)
        reflex_.erase(std::remove(reflex_.begin(), reflex_.end(), i), reflex_.end());
}

/// Covers a rest without ears, which intersects itself, by a fan of triangles.
void EarClipper::fan_rest(std::uint32_t first)
{
    result_.crosses_itself = true;
    for (std::uint32_t i = next_[first]; next_[i] != first; i = next_[i])
        if (std::abs(turn(points_[first], points_[i], points_[next_[i]])) > smallest_turn_)
            result_.triangles.push_back({first, i, next_[i]});
}

} // namespace

Vec3 area_vector(const std::vector<Vec3>& corners)
{
    // Relative to a corner, to keep precision in a scene far from the origin.
    Vec3 sum;
    for (std::size_t i = 2; i < corners.size(); ++i)
        sum = sum + cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return 0.5 * sum;
}

double distance_from_plane(const std::vector<Vec3>& corners, Vec3 area_vector)
{
    const Vec3 normal = normalized(area_vector);
    double mean_height = 0.0;
    for (const Vec3 p : corners)
        mean_height += dot(normal, p - corners[0]) / static_cast<double>(corners.size());
    double largest = 0.0;
    for (const Vec3 p : corners)
        largest = std::max(largest, std::abs(dot(normal, p - corners[0]) - mean_height));
    return largest;
}

std::size_t reflex_corner_count(const std::vector<Vec3>& corners, Vec3 area_vector)
{
    std::size_t count = 0;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 corner = corners[i];
        const Vec3 turn_here = cross(corner - corners[(i + n - 1) % n], corners[(i + 1) % n] - corner);
        count += dot(turn_here, area_vector) < 0.0 ? 1 : 0;
    }
    return count;
}

Triangulation clip_ears(const std::vector<Vec3>& corners, Vec3 area_vector, double smallest_area)
{
    return EarClipper(project(corners, area_vector), 2.0 * smallest_area).clip();
}

} // namespace multipath

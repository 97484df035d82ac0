// Quickhull (Barber, Dobkin, Huhdanpaa 1996). Every face keeps a list of points outside of it. The farthest of them
// becomes a corner of the hull, and the faces that it sees are replaced by a cone from this apex over the horizon, the
// border of the visible region. The visible faces are connected, so they are found from neighbour to neighbour. Points
// outside by less than a tolerance are ignored, which makes nearly coplanar faces harmless.
//
// The points are first transformed to width and thickness 1 (see thicken), so that in a nearly flat set the tolerance
// applies to the thickness. Points in one plane have a polygon as their hull, found by the monotone chain algorithm
// (Andrew 1979).

#include "geometry/convex_hull.h"

#include "geometry/polygon.h"
#include "geometry/vec3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace multipath {

namespace {

using Corner = std::uint32_t;

struct Face
{
    std::array<Corner, 3> corners;              ///< counter-clockwise as seen from outside
    Vec3 normal;                                ///< unit normal, of the thickened points
    double offset;                              ///< likewise: dot(normal, p) in the plane of the face
    std::array<std::size_t, 3> neighbours = {}; ///< face i is across the edge from corner i to the next one
    std::vector<Corner> outside;                ///< points in front of this face; each point is in one list only
    bool alive = true;
};

/// An edge of the horizon: between a face that the apex sees and one that it does not see.
struct HorizonEdge
{
    Corner from, to;    ///< in the direction of the visible face
    std::size_t beyond; ///< the invisible face
};

using PlanePoint = std::pair<double, double>;

/// Twice the signed area of the triangle, positive if it is counter-clockwise.
double turn(PlanePoint a, PlanePoint b, PlanePoint c)
{
    return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
}

/// Twice the area between the straight line from the first to the last point and the half of the hull to the right of
/// it, which turns left (monotone chain). The points must be sorted in either direction.
template <class Iterator>
double chain_area(Iterator first, Iterator last)
{
    std::vector<PlanePoint> chain;
    for (; first != last; ++first) {
        while (chain.size() >= 2 && turn(chain[chain.size() - 2], chain.back(), *first) <= 0.0)
            chain.pop_back();
        chain.push_back(*first);
    }
    double area = 0.0;
    for (std::size_t i = 2; i < chain.size(); ++i)
        area += turn(chain[0], chain[i - 1], chain[i]);
    return area;
}

Vec3 unit_or_zero(Vec3 v)
{
    return v == Vec3{} ? v : normalized(v);
}

class HullBuilder
{
public:
    /// `tolerance`: distance below which points count as in a plane, as a share of the extent of the points.
    HullBuilder(const LargeVector<Vec3>& points, double tolerance) : points_(points), tolerance_(tolerance) {}

    /// The triangles of the hull; none if all points lie in one plane.
    std::vector<Face> faces()
    {
        if (!start())
            return {};
        for (std::size_t f = 0; f < faces_.size(); ++f)
            if (faces_[f].alive && !faces_[f].outside.empty())
                add_corner(farthest(faces_[f]), f);
        std::vector<Face> result;
        for (const Face& face : faces_)
            if (face.alive)
                result.push_back(face);
        return result;
    }

    /// Area of both sides of the hull if all points lie in one plane. Call faces() first.
    double flat_area() const
    {
        if (points_.size() < 3)
            return 0.0;
        const Vec3 origin = points_[a_];
        const Vec3 along = unit_or_zero(points_[b_] - origin);
        const Vec3 height = points_[c_] - origin;
        const Vec3 across = unit_or_zero(height - dot(height, along) * along);
        std::vector<PlanePoint> points;
        points.reserve(points_.size());
        for (const Vec3 p : points_)
            points.push_back({dot(along, p - origin), dot(across, p - origin)});
        std::sort(points.begin(), points.end());
        const double below = chain_area(points.begin(), points.end());
        return below + chain_area(points.rbegin(), points.rend()); // both sides of the polygon
    }

private:
    /// Signed distance of a thickened point from the plane of a face, positive outside.
    double distance(const Face& face, Corner p) const { return dot(face.normal, thick_[p]) - face.offset; }

    Face make_face(Corner a, Corner b, Corner c) const
    {
        const Vec3 normal = unit_or_zero(cross(thick_[b] - thick_[a], thick_[c] - thick_[a]));
        return {{a, b, c}, normal, dot(normal, thick_[a]), {}, {}, true};
    }

    /// The point with the largest measure(p).
    template <class Measure>
    Corner argmax(const Measure& measure) const
    {
        Corner best = 0;
        for (Corner p = 1; p < points_.size(); ++p)
            if (measure(p) > measure(best))
                best = p;
        return best;
    }

    /// Builds the first tetrahedron. Returns false if all points lie in one plane.
    bool start()
    {
        if (points_.size() < 3)
            return false;
        const Vec3 first = points_[0];
        a_ = argmax([&](Corner p) { return length(points_[p] - first); });
        const Vec3 origin = points_[a_];
        b_ = argmax([&](Corner p) { return length(points_[p] - origin); });
        const Vec3 axis = points_[b_] - origin;
        c_ = argmax([&](Corner p) { return length(cross(axis, points_[p] - origin)); });
        const Vec3 normal = unit_or_zero(cross(axis, points_[c_] - origin));
        const auto height = [&](Corner p) { return dot(normal, points_[p] - origin); };
        const Corner d = argmax([&](Corner p) { return std::abs(height(p)); });
        if (std::abs(height(d)) <= tolerance_ * length(axis))
            return false;
        thicken(origin, axis, cross(normal, axis), std::abs(height(d)) * normal);
        if (height(d) > 0.0)
            std::swap(b_, c_);
        faces_ = {make_face(a_, b_, c_), make_face(a_, d, b_), make_face(b_, d, c_), make_face(c_, d, a_)};
        faces_[0].neighbours = {1, 2, 3};
        faces_[1].neighbours = {3, 2, 0};
        faces_[2].neighbours = {1, 3, 0};
        faces_[3].neighbours = {2, 1, 0};
        std::vector<Corner> all(points_.size());
        for (Corner p = 0; p < all.size(); ++p)
            all[p] = p;
        distribute(all, 0);
        return true;
    }

    /// Transforms the points affinely to coordinates in which the widest triangle and the height above it have size 1.
    void thicken(Vec3 origin, Vec3 axis, Vec3 across, Vec3 height)
    {
        const double width = dot(across, points_[c_] - origin);
        thick_.reserve(points_.size());
        for (const Vec3 point : points_) {
            const Vec3 p = point - origin;
            thick_.push_back(
                {dot(axis, p) / dot(axis, axis), dot(across, p) / width, dot(height, p) / dot(height, height)});
        }
    }

    /// Adds each point to the list of the first face, from `first_face` on, that has it outside. Points inside of all
    /// of them are dropped.
    void distribute(const std::vector<Corner>& points, std::size_t first_face)
    {
        for (const Corner p : points)
            for (std::size_t f = first_face; f < faces_.size(); ++f)
                if (distance(faces_[f], p) > tolerance_) {
                    faces_[f].outside.push_back(p);
                    break;
                }
    }

    /// The point of a face's list that is farthest outside.
    Corner farthest(const Face& face) const
    {
        return *std::max_element(face.outside.begin(), face.outside.end(),
                                 [&](Corner p, Corner q) { return distance(face, p) < distance(face, q); });
    }

    /// Replaces the faces that the apex sees, one of which is `first_visible`, by a cone over the horizon.
    void add_corner(Corner apex, std::size_t first_visible)
    {
        std::vector<HorizonEdge> horizon;
        const std::vector<std::size_t> visible = remove_visible(apex, first_visible, horizon);
        const std::size_t first_new = faces_.size();
        for (const HorizonEdge& edge : horizon)
            faces_.push_back(make_face(edge.from, edge.to, apex));
        link_cone(horizon, first_new);
        std::vector<Corner> orphans;
        for (const std::size_t f : visible) {
            orphans.insert(orphans.end(), faces_[f].outside.begin(), faces_[f].outside.end());
            faces_[f].outside = {};
        }
        distribute(orphans, first_new);
    }

    /// Marks the faces that the apex sees as dead; returns their indices and stores the horizon. Both lists are sorted,
    /// so that the result does not depend on the order of the search through the neighbours.
    std::vector<std::size_t> remove_visible(Corner apex, std::size_t first, std::vector<HorizonEdge>& horizon)
    {
        std::vector<std::size_t> visible = {first};
        faces_[first].alive = false;
        for (std::size_t k = 0; k < visible.size(); ++k)
            for (const std::size_t neighbour : faces_[visible[k]].neighbours)
                if (faces_[neighbour].alive && distance(faces_[neighbour], apex) > tolerance_) {
                    faces_[neighbour].alive = false;
                    visible.push_back(neighbour);
                }
        for (const std::size_t f : visible)
            for (std::size_t i = 0; i < 3; ++i)
                if (faces_[faces_[f].neighbours[i]].alive)
                    horizon.push_back({faces_[f].corners[i], faces_[f].corners[(i + 1) % 3], faces_[f].neighbours[i]});
        std::sort(visible.begin(), visible.end());
        std::sort(horizon.begin(), horizon.end(), [](const HorizonEdge& a, const HorizonEdge& b) {
            return std::tie(a.from, a.to) < std::tie(b.from, b.to);
        });
        return visible;
    }

    /// Links the new faces, one for each edge of the horizon in order, with each other and with the faces beyond.
    void link_cone(const std::vector<HorizonEdge>& horizon, std::size_t first_new)
    {
        std::vector<std::size_t> by_end(horizon.size());
        std::iota(by_end.begin(), by_end.end(), std::size_t{0});
        std::sort(by_end.begin(), by_end.end(), [&](std::size_t k, std::size_t l) {
            return std::tie(horizon[k].to, horizon[k].from) < std::tie(horizon[l].to, horizon[l].from);
        });
        for (std::size_t next = 0; next < horizon.size(); ++next) { // by_end[next] ends where `next` begins
            faces_[first_new + by_end[next]].neighbours[1] = first_new + next;
            faces_[first_new + next].neighbours[2] = first_new + by_end[next];
        }
        for (std::size_t k = 0; k < horizon.size(); ++k) {
            faces_[first_new + k].neighbours[0] = horizon[k].beyond;
            Face& beyond = faces_[horizon[k].beyond];
            for (std::size_t i = 0; i < 3; ++i)
                if (beyond.corners[i] == horizon[k].to && beyond.corners[(i + 1) % 3] == horizon[k].from)
                    beyond.neighbours[i] = first_new + k;
        }
    }

    const LargeVector<Vec3>& points_;
    double tolerance_;
    LargeVector<Vec3> thick_; ///< the points, thickened
    std::vector<Face> faces_;
    Corner a_ = 0, b_ = 0, c_ = 0; ///< the widest triangle found at the start
};

} // namespace

ConvexHull::ConvexHull(const LargeVector<Vec3>& points)
{
    HullBuilder builder(points, 1e-7);
    const std::vector<Face> faces = builder.faces();
    for (const Face& face : faces) {
        const Vec3 corner = points[face.corners[0]];
        const Vec3 normal = cross(points[face.corners[1]] - corner, points[face.corners[2]] - corner);
        area_ += 0.5 * length(normal);
        if (normal != Vec3{})
            sides_.push_back({normalized(normal), dot(normalized(normal), corner)});
    }
    if (faces.empty())
        area_ = builder.flat_area();
}

bool ConvexHull::meets(const Line& line) const
{
    double entry = -std::numeric_limits<double>::infinity();
    double exit = std::numeric_limits<double>::infinity();
    for (const HalfSpace& side : sides_) {
        const double height = dot(side.normal, line.origin) - side.offset;
        const double climb = dot(side.normal, line.direction);
        if (climb < 0.0)
            entry = std::max(entry, -height / climb);
        else if (climb > 0.0)
            exit = std::min(exit, -height / climb);
        else if (height > 0.0)
            return false;
        if (entry > exit)
            return false;
    }
    return !sides_.empty();
}

bool ConvexHull::is_separated_from(const std::vector<Vec3>& points, double overlap) const
{
    return std::any_of(sides_.begin(), sides_.end(), [&](const HalfSpace& side) {
        return std::all_of(points.begin(), points.end(),
                           [&](Vec3 point) { return dot(side.normal, point) - side.offset >= -overlap; });
    });
}

ConvexHull hull_of(const SurfaceList& surfaces)
{
    LargeVector<Vec3> corners;
    for (const Surface& surface : surfaces) {
        const FlatPolygon polygon = polygon_of(surface);
        corners.insert(corners.end(), polygon.corners.begin(),
                       polygon.corners.begin() + static_cast<std::ptrdiff_t>(polygon.size));
    }
    return ConvexHull(corners);
}

} // namespace multipath

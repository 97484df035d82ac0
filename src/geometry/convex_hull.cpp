// Quickhull (Barber, Dobkin, Huhdanpaa 1996). Every face keeps a list of points outside of it. The farthest of them
// becomes a corner of the hull, and the faces that it sees are replaced by a cone from this apex over the horizon, the
// border of the visible region. The visible faces are connected, so they are found from neighbour to neighbour. Points
// outside by less than a tolerance are ignored, which makes nearly coplanar faces harmless.
//
// The points are first transformed to width and thickness 1 (see thicken), so that in a nearly flat set the tolerance
// applies to the thickness. Points in one plane get an apex above them: the other faces of this pyramid are their hull.

#include "geometry/convex_hull.h"

#include "geometry/polygon.h"
#include "geometry/vec3.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace multipath {

namespace {

using Corner = std::uint32_t;

struct Face
{
    std::array<Corner, 3> corners; ///< counter-clockwise as seen from outside
    Vec3 normal;                   ///< unit normal, of the thickened points
    double offset;                 ///< likewise: dot(normal, p) in the plane of the face
    std::vector<Corner> outside;   ///< points in front of this face; each point is in one list only
    bool alive = true;
};

/// An edge of a face, in its direction.
using Edge = std::pair<Corner, Corner>;

Vec3 unit_or_zero(Vec3 v)
{
    return v == Vec3{} ? v : normalized(v);
}

class HullBuilder
{
public:
    /// `tolerance`: distance below which points count as in a plane, as a share of the extent of the points.
    HullBuilder(const LargeVector<Vec3>& points, double tolerance) : points_(points), tolerance_(tolerance) {}

    /// The triangles of the hull: of one side of it if all points lie in one plane, none if they lie on a line.
    std::vector<Face> faces()
    {
        if (!start())
            return {};
        for (std::size_t f = 0; f < faces_.size(); ++f)
            if (faces_[f].alive && !faces_[f].outside.empty())
                add_corner(farthest(faces_[f]), f);
        std::vector<Face> result;
        for (const Face& face : faces_)
            if (face.alive && *std::max_element(face.corners.begin(), face.corners.end()) < points_.size())
                result.push_back(face);
        return result;
    }

    /// True if all points lie in one plane. Call faces() first.
    bool is_flat() const { return thick_.size() > points_.size(); }

private:
    /// Signed distance of a thickened point from the plane of a face, positive outside.
    double distance(const Face& face, Corner p) const { return dot(face.normal, thick_[p]) - face.offset; }

    void add_face(Corner a, Corner b, Corner c)
    {
        for (const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{c, a}})
            face_with_[key_of(edge)] = faces_.size();
        const Vec3 normal = unit_or_zero(cross(thick_[b] - thick_[a], thick_[c] - thick_[a]));
        faces_.push_back({{a, b, c}, normal, dot(normal, thick_[a]), {}, true});
    }

    static std::uint64_t key_of(const Edge& edge) { return std::uint64_t{edge.first} << 32 | edge.second; }
    static Edge edge_of(const Face& face, std::size_t i) { return {face.corners[i], face.corners[(i + 1) % 3]}; }
    /// The face on the other side of an edge.
    std::size_t across(const Edge& edge) const { return face_with_.at(key_of({edge.second, edge.first})); }

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

    /// Builds the first tetrahedron. If all points lie in one plane, its apex is an additional point above them.
    /// Returns false if they lie on a line.
    bool start()
    {
        if (points_.size() < 3)
            return false;
        const Vec3 first = points_[0];
        const Corner a = argmax([&](Corner p) { return length(points_[p] - first); });
        const Vec3 origin = points_[a];
        Corner b = argmax([&](Corner p) { return length(points_[p] - origin); });
        const Vec3 axis = points_[b] - origin;
        Corner c = argmax([&](Corner p) { return length(cross(axis, points_[p] - origin)); });
        const Vec3 normal = unit_or_zero(cross(axis, points_[c] - origin));
        if (normal == Vec3{})
            return false;
        const auto height = [&](Corner p) { return dot(normal, points_[p] - origin); };
        Corner d = argmax([&](Corner p) { return std::abs(height(p)); });
        const double thickness = std::abs(height(d));
        const bool is_flat = thickness <= tolerance_ * length(axis);
        const Vec3 across = cross(normal, axis);
        const double width = dot(across, points_[c] - origin);
        thicken(origin, axis, across, width, (is_flat ? length(axis) : thickness) * normal);
        if (is_flat) {
            tolerance_ = 1e-12;
            for (Vec3& point : thick_)
                point.z = 0.0;
            d = static_cast<Corner>(points_.size());
            thick_.push_back({0.0, 0.0, 1.0});
        }
        if (thick_[d].z > 0.0)
            std::swap(b, c);
        add_face(a, b, c);
        add_face(a, d, b);
        add_face(b, d, c);
        add_face(c, d, a);
        std::vector<Corner> all(points_.size());
        for (Corner p = 0; p < all.size(); ++p)
            all[p] = p;
        distribute(all, 0);
        return true;
    }

    /// Transforms the points affinely to coordinates in which the widest triangle and the height above it have size 1.
    void thicken(Vec3 origin, Vec3 axis, Vec3 across, double width, Vec3 height)
    {
        thick_.reserve(points_.size() + 1);
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
        std::vector<Edge> horizon;
        const std::vector<std::size_t> visible = remove_visible(apex, first_visible, horizon);
        const std::size_t first_new = faces_.size();
        for (const auto& [from, to] : horizon)
            add_face(from, to, apex);
        std::vector<Corner> orphans;
        for (const std::size_t f : visible) {
            orphans.insert(orphans.end(), faces_[f].outside.begin(), faces_[f].outside.end());
            faces_[f].outside = {};
        }
        distribute(orphans, first_new);
    }

    /// Marks the faces that the apex sees as dead; returns their indices and stores the horizon. Both lists are sorted,
    /// so that the result does not depend on the order of the search through the neighbours.
    std::vector<std::size_t> remove_visible(Corner apex, std::size_t first, std::vector<Edge>& horizon)
    {
        std::vector<std::size_t> visible = {first};
        faces_[first].alive = false;
        for (std::size_t k = 0; k < visible.size(); ++k)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t neighbour = across(edge_of(faces_[visible[k]], i));
                if (faces_[neighbour].alive && distance(faces_[neighbour], apex) > tolerance_) {
                    faces_[neighbour].alive = false;
                    visible.push_back(neighbour);
                }
            }
        for (const std::size_t f : visible)
            for (std::size_t i = 0; i < 3; ++i)
                if (faces_[across(edge_of(faces_[f], i))].alive)
                    horizon.push_back(edge_of(faces_[f], i));
        std::sort(visible.begin(), visible.end());
        std::sort(horizon.begin(), horizon.end());
        return visible;
    }

    const LargeVector<Vec3>& points_;
    double tolerance_;
    LargeVector<Vec3> thick_; ///< the points, thickened, and of a flat set one point above them
    std::vector<Face> faces_;
    std::unordered_map<std::uint64_t, std::size_t> face_with_; ///< the face of each edge
};

} // namespace

ConvexHull::ConvexHull(const LargeVector<Vec3>& points)
{
    HullBuilder builder(points, 1e-7);
    for (const Face& face : builder.faces()) {
        const Vec3 corner = points[face.corners[0]];
        const Vec3 normal = cross(points[face.corners[1]] - corner, points[face.corners[2]] - corner);
        area_ += 0.5 * length(normal);
        if (!builder.is_flat() && normal != Vec3{})
            sides_.push_back({normalized(normal), dot(normalized(normal), corner)});
    }
    area_ *= builder.is_flat() ? 2.0 : 1.0;
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

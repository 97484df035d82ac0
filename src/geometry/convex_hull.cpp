// Quickhull (Barber, Dobkin, Huhdanpaa 1996): every face keeps the points outside of it; the farthest of them becomes a
// corner of the hull, the faces that it sees are replaced by a cone over their rim. Points less than a tolerance
// outside are ignored, which keeps nearly coplanar faces harmless.

#include "geometry/convex_hull.h"

#include "geometry/bounds.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

namespace multipath {

namespace {

using Corner = std::uint32_t;

struct Face
{
    std::array<Corner, 3> corners; ///< counter-clockwise seen from outside
    Vec3 normal;                   ///< unit
    double offset;
    std::vector<Corner> outside; ///< points in front of this face, each in the list of one face only
    bool alive = true;
};

class HullBuilder
{
public:
    HullBuilder(const std::vector<Vec3>& points, double tolerance) : points_(points), tolerance_(tolerance) {}

    /// Triangles that cover the hull; none when all points lie in one plane.
    std::vector<Face> faces()
    {
        if (!start())
            return {};
        for (std::size_t f = 0; f < faces_.size(); ++f)
            while (faces_[f].alive && !faces_[f].outside.empty())
                add_corner(farthest(faces_[f]));
        std::vector<Face> result;
        for (const Face& face : faces_)
            if (face.alive)
                result.push_back(face);
        return result;
    }

    double area_of(const Face& face) const
    {
        const std::array<Corner, 3>& c = face.corners;
        return 0.5 * length(cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]]));
    }

    /// All points in one plane: their hull is a polygon, whose corners are found by walking around it (gift wrapping).
    double flat_area() const
    {
        if (points_.size() < 3)
            return 0.0;
        const Vec3 normal = make_face(a_, b_, c_).normal;
        Vec3 twice_area;
        Corner corner = a_; // the farthest from some point, so a corner of the hull
        for (std::size_t step = 0; step < points_.size(); ++step) {
            Corner next = corner == 0 ? 1 : 0;
            for (Corner p = 0; p < points_.size(); ++p) {
                const Vec3 to_next = points_[next] - points_[corner];
                const Vec3 to_p = points_[p] - points_[corner];
                const double turn = dot(normal, cross(to_next, to_p));
                if (turn < 0.0 || (turn == 0.0 && length(to_p) > length(to_next)))
                    next = p;
            }
            twice_area = twice_area + cross(points_[corner] - points_[a_], points_[next] - points_[a_]);
            corner = next;
            if (points_[corner] == points_[a_])
                break;
        }
        return length(twice_area);
    }

private:
    double distance(const Face& face, Corner p) const { return dot(face.normal, points_[p]) - face.offset; }

    Face make_face(Corner a, Corner b, Corner c) const
    {
        const Vec3 n = cross(points_[b] - points_[a], points_[c] - points_[a]);
        const double size = length(n);
        const Vec3 normal = size > 0.0 ? (1.0 / size) * n : Vec3{};
        return {{a, b, c}, normal, dot(normal, points_[a]), {}, true};
    }

    template <class Measure>
    Corner argmax(const Measure& measure) const
    {
        Corner best = 0;
        for (Corner p = 1; p < points_.size(); ++p)
            if (measure(p) > measure(best))
                best = p;
        return best;
    }

    /// The first tetrahedron; false when all points lie in one plane.
    bool start()
    {
        if (points_.size() < 3)
            return false;
        const Vec3 first = points_[0];
        a_ = argmax([&](Corner p) { return length(points_[p] - first); });
        b_ = argmax([&](Corner p) { return length(points_[p] - points_[a_]); });
        const Vec3 axis = points_[b_] - points_[a_];
        c_ = argmax([&](Corner p) { return length(cross(axis, points_[p] - points_[a_])); });
        const Face base = make_face(a_, b_, c_);
        const Corner d = argmax([&](Corner p) { return std::abs(distance(base, p)); });
        if (std::abs(distance(base, d)) <= tolerance_)
            return false;
        if (distance(base, d) > 0.0)
            std::swap(b_, c_);
        faces_ = {make_face(a_, b_, c_), make_face(a_, d, b_), make_face(b_, d, c_), make_face(c_, d, a_)};
        std::vector<Corner> all(points_.size());
        for (Corner p = 0; p < all.size(); ++p)
            all[p] = p;
        distribute(all, 0);
        return true;
    }

    /// Gives each point to the first face from `first_face` on that has it outside; points inside all are dropped.
    void distribute(const std::vector<Corner>& points, std::size_t first_face)
    {
        for (const Corner p : points)
            for (std::size_t f = first_face; f < faces_.size(); ++f)
                if (distance(faces_[f], p) > tolerance_) {
                    faces_[f].outside.push_back(p);
                    break;
                }
    }

    Corner farthest(const Face& face) const
    {
        return *std::max_element(face.outside.begin(), face.outside.end(),
                                 [&](Corner p, Corner q) { return distance(face, p) < distance(face, q); });
    }

    void add_corner(Corner apex)
    {
        std::set<std::pair<Corner, Corner>> rim; // edges of seen faces, without those shared by two of them
        std::vector<Corner> orphans;
        for (Face& face : faces_) {
            if (!face.alive || distance(face, apex) <= tolerance_)
                continue;
            face.alive = false;
            for (std::size_t i = 0; i < 3; ++i) {
                const Corner from = face.corners[i];
                const Corner to = face.corners[(i + 1) % 3];
                if (rim.erase({to, from}) == 0)
                    rim.insert({from, to});
            }
            orphans.insert(orphans.end(), face.outside.begin(), face.outside.end());
            face.outside = {};
        }
        const std::size_t first_new = faces_.size();
        for (const auto& [from, to] : rim)
            faces_.push_back(make_face(from, to, apex));
        distribute(orphans, first_new);
    }

    const std::vector<Vec3>& points_;
    double tolerance_;
    std::vector<Face> faces_;
    Corner a_ = 0, b_ = 0, c_ = 0; ///< the widest triangle found at the start
};

} // namespace

ConvexHull::ConvexHull(const std::vector<Vec3>& points)
{
    Bounds bounds;
    for (const Vec3 p : points)
        bounds.include(p);
    HullBuilder builder(points, 1e-7 * bounds.diagonal());
    const std::vector<Face> faces = points.empty() ? std::vector<Face>{} : builder.faces();
    for (const Face& face : faces) {
        area_ += builder.area_of(face);
        sides_.push_back({face.normal, face.offset});
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
    }
    return !sides_.empty() && entry <= exit;
}

bool ConvexHull::is_beside(const std::vector<Vec3>& points, double overlap) const
{
    return std::any_of(sides_.begin(), sides_.end(), [&](const HalfSpace& side) {
        return std::all_of(points.begin(), points.end(),
                           [&](Vec3 point) { return dot(side.normal, point) - side.offset >= -overlap; });
    });
}

} // namespace multipath

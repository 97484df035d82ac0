// The winding number of a part of the scene around a point is the sum of the solid angles of its surfaces, over 4 pi,
// with a sign: positive for a surface seen from behind (Jacobson, Kavan and Sorkine-Hornung 2013 generalise the winding
// number to meshes with holes). Around a point inside a closed part it is 1 if the part faces outward and -1 if the
// part faces inward; around a point outside it is 0. So the winding numbers around the emitters show which closed parts
// surround them and face the wrong way.

#include "scene/room_shell.h"

#include "geometry/elementary.h"
#include "geometry/polygon.h"
#include "scene/vertex_weld.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

namespace multipath {

namespace {

/// [sr] Solid angle of a triangle at the origin, positive if it is seen from behind (van Oosterom and Strackee 1983).
double solid_angle(Vec3 a, Vec3 b, Vec3 c)
{
    const double la = length(a), lb = length(b), lc = length(c);
    return 2.0 *
           elementary::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

double solid_angle(const Surface& surface, Vec3 from)
{
    const Vec3 a = surface.origin - from;
    const Vec3 b = a + surface.edge_u;
    const Vec3 d = a + surface.edge_v;
    if (surface.shape == Shape::triangle)
        return solid_angle(a, b, d);
    const Vec3 c = b + surface.edge_v;
    return solid_angle(a, b, c) + solid_angle(a, c, d);
}

bool emits(const SceneFile& file, std::size_t surface)
{
    return file.materials[file.material[surface]].emittance != Rgb{};
}

/// The connected parts of a scene: for each surface the index of the first surface of its part (union-find). Surfaces
/// are connected if exactly two of them have an edge, in opposite directions. An object that touches a wall either
/// shares no edge with it or is a third surface at an edge, so it is not connected to the wall.
std::vector<std::uint32_t> connected_parts(const SurfaceList& surfaces, const Bounds& bounds)
{
    LargeVector<Vec3> corners;
    std::vector<std::size_t> first_corner;
    for (const Surface& surface : surfaces) {
        first_corner.push_back(corners.size());
        for (const Vec3 corner : corners_of(surface))
            corners.push_back(snapped(corner, bounds));
    }
    first_corner.push_back(corners.size());
    const LargeVector<std::uint32_t> welded = weld(corners);

    struct Edge
    {
        std::uint32_t low, high; ///< corners
        std::uint32_t surface;
        bool upward;
    };
    std::vector<Edge> edges;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s)
        for (std::size_t k = first_corner[s]; k < first_corner[s + 1]; ++k) {
            const std::uint32_t from = welded[k];
            const std::uint32_t to = welded[k + 1 < first_corner[s + 1] ? k + 1 : first_corner[s]];
            edges.push_back({std::min(from, to), std::max(from, to), s, from < to});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.surface) < std::tie(b.low, b.high, b.surface);
    });

    std::vector<std::uint32_t> parent(surfaces.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t s) {
        while (parent[s] != s)
            s = parent[s] = parent[parent[s]];
        return s;
    };
    for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
        while (end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high)
            ++end;
        if (end - first != 2 || edges[first].upward == edges[first + 1].upward)
            continue;
        const std::uint32_t a = root(edges[first].surface);
        const std::uint32_t b = root(edges[first + 1].surface);
        parent[std::max(a, b)] = std::min(a, b);
    }
    for (std::uint32_t s = 0; s < parent.size(); ++s)
        parent[s] = root(s);
    return parent;
}

/// The connected parts of a scene. A part is named by the index of its first surface.
class Parts
{
public:
    explicit Parts(const SceneFile& file) : file_(file)
    {
        for (const Surface& surface : file.surfaces)
            all_.include(surface.bounds());
        part_ = connected_parts(file.surfaces, all_);
        bounds_.resize(part_.size());
        areas_.resize(part_.size());
        for (std::uint32_t s = 0; s < part_.size(); ++s) {
            bounds_[part_[s]].include(file.surfaces[s].bounds());
            areas_[part_[s]] += file.surfaces[s].area();
        }
    }

    std::uint32_t of(std::uint32_t surface) const { return part_[surface]; }
    double area(std::uint32_t part) const { return areas_[part]; }

    /// The closed parts that face outward and surround a point: their winding number is 1 there.
    std::vector<std::uint32_t> around(Vec3 point) const
    {
        std::vector<double> angles(part_.size());
        for (std::uint32_t s = 0; s < part_.size(); ++s)
            angles[part_[s]] += solid_angle(file_.surfaces[s], point);
        std::vector<std::uint32_t> found;
        for (std::uint32_t p = 0; p < angles.size(); ++p)
            if (angles[p] > 0.99 * 4.0 * pi)
                found.push_back(p);
        return found;
    }

    bool reaches_all_sides(std::uint32_t part) const
    {
        const double tolerance = 1e-3 * all_.diagonal();
        return length(bounds_[part].low - all_.low) <= tolerance && length(bounds_[part].high - all_.high) <= tolerance;
    }

    bool is_convex(std::uint32_t part) const
    {
        constexpr std::size_t most = 4096; // surfaces; the time is proportional to their square
        std::vector<std::uint32_t> own;
        for (std::uint32_t s = 0; s < part_.size(); ++s)
            if (part_[s] == part)
                own.push_back(s);
        if (own.size() > most)
            return false;
        const double tolerance = 1e-6 * all_.diagonal();
        for (const std::uint32_t s : own) {
            const Surface& face = file_.surfaces[s];
            const Vec3 normal = face.normal();
            for (const std::uint32_t other : own)
                for (const Vec3 corner : corners_of(file_.surfaces[other]))
                    if (dot(normal, corner - face.origin) > tolerance)
                        return false;
        }
        return true;
    }

private:
    const SceneFile& file_;
    Bounds all_;
    std::vector<std::uint32_t> part_;
    std::vector<Bounds> bounds_; ///< indexed by part
    std::vector<double> areas_;
};

/// The winding number of the whole scene around a point.
double winding_number(const SceneFile& file, Vec3 point)
{
    double sum = 0.0;
    for (const Surface& surface : file.surfaces)
        sum += solid_angle(surface, point);
    return sum / (4.0 * pi);
}

} // namespace

std::size_t turn_shells_inward(SceneFile& file)
{
    std::vector<std::uint32_t> emitters;
    Bounds all;
    for (std::uint32_t s = 0; s < file.surfaces.size(); ++s) {
        all.include(file.surfaces[s].bounds());
        if (emits(file, s))
            emitters.push_back(s);
    }
    if (emitters.empty() || emitters.size() == file.surfaces.size())
        return 0;
    const std::size_t tested = std::clamp<std::size_t>(1'000'000 / file.surfaces.size(), 1, 16);
    const std::size_t step = (emitters.size() + tested - 1) / tested;
    const double aside = 1e-5 * all.diagonal();
    const auto in_front = [&](std::uint32_t s) {
        return file.surfaces[s].centre() + aside * file.surfaces[s].normal();
    };
    const auto behind = [&](std::uint32_t s) { return file.surfaces[s].centre() - aside * file.surfaces[s].normal(); };

    // In a room that faces inward the winding number is -1, or 0 inside its lamps and outside of it. Most scenes are
    // done here.
    bool any = false;
    for (std::size_t k = 0; k < emitters.size() && !any; k += step)
        any = std::max(winding_number(file, in_front(emitters[k])), winding_number(file, behind(emitters[k]))) > 0.4;
    if (!any)
        return 0;

    const Parts parts(file);
    std::vector<char> turned(file.surfaces.size());
    std::vector<double> lamps_within(file.surfaces.size()); // [m^2] of emitters surrounded by each part
    bool all_own = true;
    for (std::size_t k = 0; k < emitters.size(); k += step) {
        const std::uint32_t own = parts.of(emitters[k]);
        for (const std::uint32_t part : parts.around(in_front(emitters[k])))
            lamps_within[part] += part == own ? 0.0 : static_cast<double>(step) * file.surfaces[emitters[k]].area();
        all_own = all_own && own == parts.of(emitters[0]);
    }
    constexpr double spacious = 4.0; // a closed part less than this times as large is the housing of a lamp
    for (std::uint32_t p = 0; p < turned.size(); ++p)
        turned[p] = lamps_within[p] > 0.0 && parts.area(p) > spacious * lamps_within[p] ? 1 : 0;
    const std::uint32_t first = parts.of(emitters[0]);
    const auto surrounds = [&](const std::vector<std::uint32_t>& found) {
        return std::find(found.begin(), found.end(), first) != found.end();
    };
    if (all_own && parts.reaches_all_sides(first) && surrounds(parts.around(behind(emitters[0]))) &&
        parts.is_convex(first))
        turned[first] = 1;

    std::size_t count = 0;
    for (std::uint32_t s = 0; s < file.surfaces.size(); ++s)
        if (turned[parts.of(s)]) {
            turn_over(file, s);
            ++count;
        }
    return count;
}

} // namespace multipath

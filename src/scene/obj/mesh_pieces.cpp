#include "scene/obj/mesh_pieces.h"

#include "geometry/bounds.h"
#include "scene/text/text_lines.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace multipath {

// Ear clipping. A corner of a simple polygon is an ear if it is convex and no other part of the polygon reaches into
// the triangle of the corner and its two neighbours. The triangle of an ear can be cut off. Every simple polygon has an
// ear (Meisters 1975), so n - 2 cuts are enough. Only reflex corners have to be tested against a triangle, and cutting
// off an ear affects only its two neighbours, so each corner is tested about three times. The polygon is projected
// along the largest component of its normal: coordinates are copied, not computed, so corners that are straight or
// equal in space stay so in the projection.

namespace {

/// A corner in the plane of projection; z is 0.
using FlatPoint = Vec3;

/// Twice the area of the triangle, positive if it is counter-clockwise.
double turn(FlatPoint a, FlatPoint b, FlatPoint c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Drops the coordinate of the largest component of the normal; front faces stay counter-clockwise.
std::vector<FlatPoint> project(const std::vector<Vec3>& corners, Vec3 normal)
{
    const double x = std::abs(normal.x);
    const double y = std::abs(normal.y);
    const double z = std::abs(normal.z);
    const bool along_x = x >= y && x >= z;
    const bool along_y = !along_x && y >= z;
    const bool turned_away = (along_x ? normal.x : along_y ? normal.y : normal.z) < 0.0;

    std::vector<FlatPoint> points;
    for (const Vec3 p : corners) {
        const FlatPoint q = along_x ? FlatPoint{p.y, p.z} : along_y ? FlatPoint{p.z, p.x} : FlatPoint{p.x, p.y};
        points.push_back(turned_away ? FlatPoint{q.y, q.x} : q);
    }
    return points;
}

class EarClipper
{
public:
    EarClipper(std::vector<FlatPoint> points, double smallest_turn)
        : points_(std::move(points)),
          smallest_turn_(smallest_turn),
          next_(points_.size()),
          previous_(points_.size()),
          is_no_ear_(points_.size())
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

    Triangulation clip()
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
                std::fill(is_no_ear_.begin(), is_no_ear_.end(), false);
                tested = 0;
            } else {
                fan_rest(i);
                break;
            }
        }
        return std::move(result_);
    }

private:
    double turn_at(std::uint32_t i) const { return turn(points_[previous_[i]], points_[i], points_[next_[i]]); }

    bool is_ear(std::uint32_t i)
    {
        if (is_no_ear_[i])
            return false;
        const double size = turn_at(i);
        const bool straight = std::abs(size) <= smallest_turn_;
        is_no_ear_[i] = !straight && (size <= 0.0 || contains_reflex_corner(i)) ? 1 : 0;
        return !is_no_ear_[i];
    }

    bool contains_reflex_corner(std::uint32_t i) const
    {
        const FlatPoint a = points_[previous_[i]];
        const FlatPoint b = points_[i];
        const FlatPoint c = points_[next_[i]];
        return std::any_of(reflex_.begin(), reflex_.end(), [&](std::uint32_t r) {
            const FlatPoint p = points_[r];
            const double least = std::min({turn(a, b, p), turn(b, c, p), turn(c, a, p)});
            // Corners at the same point are the ends of a bridge that joins a hole to the outline.
            return (touching_counts_ ? least >= 0.0 : least > smallest_turn_) && !(p == a || p == b || p == c);
        });
    }

    void cut_off(std::uint32_t i)
    {
        const std::uint32_t before = previous_[i];
        const std::uint32_t after = next_[i];
        if (turn_at(i) > smallest_turn_)
            result_.triangles.push_back({before, i, after});
        next_[before] = after;
        previous_[after] = before;
        is_no_ear_[before] = is_no_ear_[after] = false;
        const auto is_reflex_no_more = [&](std::uint32_t r) {
            return r == i || ((r == before || r == after) && turn_at(r) >= -smallest_turn_);
        };
        reflex_.erase(std::remove_if(reflex_.begin(), reflex_.end(), is_reflex_no_more), reflex_.end());
    }

    /// Covers a rest without ears, which intersects itself, by a fan of triangles.
    void fan_rest(std::uint32_t first)
    {
        result_.crosses_itself = true;
        for (std::uint32_t i = next_[first]; next_[i] != first; i = next_[i])
            if (std::abs(turn(points_[first], points_[i], points_[next_[i]])) > smallest_turn_)
                result_.triangles.push_back({first, i, next_[i]});
    }

    std::vector<FlatPoint> points_;
    double smallest_turn_;
    std::vector<std::uint32_t> next_, previous_; ///< circular list of the remaining corners
    std::vector<char> is_no_ear_;                ///< known since its neighbours changed last
    std::vector<std::uint32_t> reflex_;
    bool touching_counts_ = true; ///< a corner on the border of a triangle counts as inside
    Triangulation result_;
};

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

// How a face is cut: corners on straight sides are removed first. Three remaining corners are a triangle. A convex quad
// stays whole if it is a parallelogram, and is cut along a diagonal otherwise. Ear clipping cuts all other polygons.
// Polygons that are not planar or intersect themselves are cut, too, but counted for a warning.

namespace {

/// Limit of corners times reflex corners of a polygon: about a second of ear clipping.
constexpr double largest_clipping_work = 1e8;

constexpr std::string_view crosses_itself =
    "polygon crosses itself and its triangles overlap, mend it in the modelling program";

class FaceCutter
{
public:
    FaceCutter(const ObjMesh& mesh, const SceneScale& scale) : mesh_(mesh), scale_(scale) {}

    MeshPieces cut()
    {
        result_.pieces.reserve(mesh_.faces.size());
        for (std::uint32_t face = 0; face < mesh_.faces.size(); ++face) {
            const std::size_t pieces_before = result_.pieces.size();
            const ObjCorner* const first = &mesh_.corners[mesh_.faces[face].first_corner];
            if (mesh_.faces[face].corner_count == 3) {
                add_triangle(face, first[0], first[1], first[2]);
            } else {
                polygon_.assign(first, first + mesh_.faces[face].corner_count);
                cut_polygon(face);
            }
            if (result_.pieces.size() == pieces_before)
                flaws_.add("a face without an area is dropped", mesh_.faces[face].line);
        }
        result_.warnings = flaws_.warnings(mesh_.path);
        return std::move(result_);
    }

private:
    void cut_polygon(std::uint32_t face)
    {
        skip_straight_corners();
        if (polygon_.size() < 3)
            return;
        positions_.clear();
        for (const ObjCorner corner : polygon_)
            positions_.push_back(mesh_.at(corner));
        const Vec3 area = area_vector(positions_);
        const bool lobes_cancel = polygon_.size() > 3 && length(area) <= scale_.smallest_area();
        if (lobes_cancel)
            flaws_.add(crosses_itself, mesh_.faces[face].line);
        if (lobes_cancel || polygon_.size() == 3) {
            for (std::size_t i = 2; i < polygon_.size(); ++i)
                add_triangle(face, polygon_[0], polygon_[i - 1], polygon_[i]);
            return;
        }
        const double bend = distance_from_plane(positions_, area);
        if (bend > scale_.widest_crack() && bend * bend > 1e-8 * length(area))
            flaws_.add("polygon is not planar and was cut into triangles", mesh_.faces[face].line);
        const std::size_t reflex_corners = reflex_corner_count(positions_, area);
        if (polygon_.size() == 4 && reflex_corners == 0)
            cut_quad(face);
        else
            clip(face, area, reflex_corners);
    }

    void cut_quad(std::uint32_t face)
    {
        const std::array quad = {polygon_[0], polygon_[1], polygon_[2], polygon_[3]};
        const bool one_frame = !mesh_.is_textured(mesh_.faces[face]) || is_texture_parallelogram(quad, mesh_);
        if (one_frame && is_parallelogram(positions_[0], positions_[1], positions_[2], positions_[3], scale_)) {
            result_.pieces.push_back({quad, face});
            return;
        }
        add_triangle(face, quad[0], quad[1], quad[2]);
        add_triangle(face, quad[0], quad[2], quad[3]);
    }

    void clip(std::uint32_t face, Vec3 area, std::size_t reflex_corners)
    {
        if (static_cast<double>(polygon_.size()) * static_cast<double>(reflex_corners) > largest_clipping_work)
            refuse({mesh_.path, mesh_.faces[face].line}, "concave polygon of " + std::to_string(polygon_.size()) +
                                                             " corners, expected at most about 10,000: divide it");
        const Triangulation cut = clip_ears(positions_, area, scale_.smallest_area());
        if (cut.crosses_itself)
            flaws_.add(crosses_itself, mesh_.faces[face].line);
        for (const auto& [a, b, c] : cut.triangles)
            add_triangle(face, polygon_[a], polygon_[b], polygon_[c]);
    }

    /// Removes corners on a straight side from polygon_; also corners at the same point as a neighbour, and spikes.
    void skip_straight_corners()
    {
        std::vector<ObjCorner>& p = polygon_;
        std::size_t kept = 0;
        for (const ObjCorner corner : p) {
            while (kept >= 2 && is_straight(p[kept - 2], p[kept - 1], corner))
                --kept;
            p[kept++] = corner;
        }
        std::size_t first = 0;
        for (bool changed = true; changed;) {
            changed = false;
            while (kept - first >= 3 && is_straight(p[kept - 2], p[kept - 1], p[first])) {
                --kept;
                changed = true;
            }
            while (kept - first >= 3 && is_straight(p[kept - 1], p[first], p[first + 1])) {
                ++first;
                changed = true;
            }
        }
        p.resize(kept);
        p.erase(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(first));
    }

    bool is_straight(ObjCorner a, ObjCorner b, ObjCorner c) const
    {
        return scale_.is_degenerate(mesh_.at(a), mesh_.at(b), mesh_.at(c));
    }

    void add_triangle(std::uint32_t face, ObjCorner a, ObjCorner b, ObjCorner c)
    {
        if (!is_straight(a, b, c))
            result_.pieces.push_back({{a, b, c}, face});
    }

    const ObjMesh& mesh_;
    const SceneScale scale_;
    MeshPieces result_;
    Flaws flaws_;
    std::vector<ObjCorner> polygon_; ///< corners of the current face
    std::vector<Vec3> positions_;    ///< of polygon_
};

} // namespace

SceneScale scale_of(const ObjMesh& mesh)
{
    Bounds box;
    for (const ObjFace& face : mesh.faces)
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            box.include(mesh.at(mesh.corners[face.first_corner + k]));
    const Vec3 size = box.size();
    return {std::max({size.x, size.y, size.z})};
}

bool Piece::has_texture_points() const
{
    return std::all_of(corners.begin(), corners.begin() + (is_triangle() ? 3 : 4),
                       [](ObjCorner corner) { return corner.point != ObjCorner::none; });
}

bool is_parallelogram(Vec3 v0, Vec3 v1, Vec3 v2, Vec3 v3, const SceneScale& scale)
{
    const auto square = [](Vec3 a) { return dot(a, a); };
    const double gap = square((v1 - v0) - (v2 - v3));
    return gap <= scale.widest_crack() * scale.widest_crack() &&
           gap <= 1e-6 * std::min(square(v1 - v0), square(v3 - v0));
}

bool is_texture_parallelogram(const std::array<ObjCorner, 4>& corners, const ObjMesh& mesh)
{
    const auto has_none = [](ObjCorner corner) { return corner.point == ObjCorner::none; };
    if (std::any_of(corners.begin(), corners.end(), has_none))
        return std::all_of(corners.begin(), corners.end(), has_none);
    const auto at = [&](std::size_t k) { return mesh.texture_points[corners[k].point]; };
    const auto square = [](double s, double t) { return s * s + t * t; };
    const double gap = square(at(1).s - at(0).s - (at(2).s - at(3).s), at(1).t - at(0).t - (at(2).t - at(3).t));
    const double side =
        std::min(square(at(1).s - at(0).s, at(1).t - at(0).t), square(at(3).s - at(0).s, at(3).t - at(0).t));
    return gap <= 1e-6 * side;
}

namespace {

void colour_pieces(const ObjMesh& mesh, MeshPieces& cut)
{
    std::array<double, 255> borders = {}; // linear light half way between each sRGB value from 0 to 254 and the next
    for (std::size_t level = 0; level < borders.size(); ++level)
        borders[level] = srgb_decoded((static_cast<double>(level) + 0.5) / 255.0);
    const auto level = [&](double linear) {
        return static_cast<std::uint8_t>(std::upper_bound(borders.begin(), borders.end(), linear) - borders.begin());
    };
    std::map<std::array<std::uint8_t, 3>, std::uint32_t> numbers;
    for (Piece& piece : cut.pieces) {
        Rgb sum;
        double count = 0.0;
        for (std::size_t k = 0; k < piece.corner_count(); ++k)
            if (const Rgb colour = mesh.colours[piece.corners[k].vertex]; colour.r >= 0.0) {
                sum += colour;
                count += 1.0;
            }
        if (count == 0.0 || mesh.is_textured(mesh.faces[piece.face]))
            continue;
        const std::array levels = {level(sum.r / count), level(sum.g / count), level(sum.b / count)};
        const auto [entry, is_new] = numbers.emplace(levels, static_cast<std::uint32_t>(cut.colours.size()));
        if (is_new)
            cut.colours.push_back(levels);
        piece.colour = entry->second;
    }
}

} // namespace

MeshPieces cut_into_pieces(const ObjMesh& mesh, const SceneScale& scale)
{
    MeshPieces cut = FaceCutter(mesh, scale).cut();
    if (!mesh.colours.empty())
        colour_pieces(mesh, cut);
    return cut;
}

} // namespace multipath

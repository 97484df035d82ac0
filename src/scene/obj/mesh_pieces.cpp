#include "scene/obj/mesh_pieces.h"

#include "geometry/bounds.h"
#include "scene/text/text_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace multipath {

// Ear clipping. A corner of a simple polygon is an ear if it is convex and no other part of the polygon reaches into
// the triangle of the corner and its two neighbours. The triangle of an ear can be cut off. Every simple polygon has an
// ear (Meisters 1975), so n - 2 cuts are enough. Only reflex corners have to be tested against a triangle, and cutting
// off an ear affects only its two neighbours, so each corner is tested about three times. The polygon is projected
// along the largest component of its normal: coordinates are copied, not computed, so corners that are straight or
// equal in space stay so in the projection.

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

// How a face is cut: corners on straight sides are removed first. Three remaining corners are a triangle. A convex quad
// stays whole if it is a parallelogram, and is cut along a diagonal otherwise. Ear clipping cuts all other polygons.
// Polygons that are not planar or intersect themselves are cut, too, but counted for a warning.

namespace {

/// Limit of corners times reflex corners of a polygon: about a second of ear clipping.
constexpr double largest_clipping_work = 1e8;

double area_of(Vec3 a, Vec3 b, Vec3 c)
{
    return 0.5 * length(cross(b - a, c - a));
}

double diameter_of(const std::vector<Vec3>& points)
{
    Bounds box;
    for (const Vec3 p : points)
        box.include(p);
    return box.diagonal();
}

class FaceCutter
{
public:
    FaceCutter(const ObjMesh& mesh, const SceneScale& scale) : mesh_(mesh), scale_(scale) {}
    MeshPieces cut();

private:
    void cut_face(std::uint32_t face, std::size_t first_corner);
    void cut_polygon(std::uint32_t face);
    void cut_quad(std::uint32_t face);
    void clip(std::uint32_t face, Vec3 area);
    void skip_straight_corners();
    bool is_straight(std::size_t a, std::size_t b, std::size_t c) const;
    void load_positions();
    void add_triangle(std::uint32_t face, std::size_t a, std::size_t b, std::size_t c);
    std::uint32_t vertex(std::size_t corner) const { return mesh_.corners[corner]; }
    std::uint32_t point(std::size_t corner) const
    {
        return mesh_.corner_points.empty() ? ObjMesh::no_point : mesh_.corner_points[corner];
    }
    void add_warning(const FlawCount& flaw, const std::string& what);
    Vec3 at(std::size_t corner) const { return mesh_.vertices[vertex(corner)]; }

    const ObjMesh& mesh_;
    const SceneScale scale_;
    MeshPieces result_;
    FlawCount bent_, crossed_;
    std::vector<std::size_t> polygon_; ///< corners of the current face
    std::vector<Vec3> positions_;      ///< of polygon_
};

MeshPieces FaceCutter::cut()
{
    result_.pieces.reserve(mesh_.faces.size());
    std::size_t first_corner = 0;
    for (std::uint32_t face = 0; face < mesh_.faces.size(); ++face) {
        cut_face(face, first_corner);
        first_corner += mesh_.faces[face].corner_count;
    }
    add_warning(bent_, "polygon is not planar and was cut into triangles");
    add_warning(crossed_, "polygon crosses itself and its triangles overlap, mend it in the modelling program");
    return std::move(result_);
}

void FaceCutter::cut_face(std::uint32_t face, std::size_t first_corner)
{
    const std::uint32_t count = mesh_.faces[face].corner_count;
    const std::size_t pieces_before = result_.pieces.size();
    if (count == 3) {
        add_triangle(face, first_corner, first_corner + 1, first_corner + 2);
    } else {
        polygon_.resize(count);
        std::iota(polygon_.begin(), polygon_.end(), first_corner);
        cut_polygon(face);
    }
    if (result_.pieces.size() == pieces_before)
        ++result_.zero_area_faces;
}

void FaceCutter::cut_polygon(std::uint32_t face)
{
    skip_straight_corners();
    if (polygon_.size() < 3)
        return;
    if (polygon_.size() == 3) {
        add_triangle(face, polygon_[0], polygon_[1], polygon_[2]);
        return;
    }
    load_positions();
    const Vec3 area = area_vector(positions_);
    const bool lobes_cancel = length(area) <= scale_.smallest_area();
    if (lobes_cancel) {
        crossed_.add(mesh_.faces[face].line);
        for (std::size_t i = 2; i < polygon_.size(); ++i)
            add_triangle(face, polygon_[0], polygon_[i - 1], polygon_[i]);
        return;
    }
    const double bend = distance_from_plane(positions_, area);
    if (bend > scale_.widest_crack() && bend > 1e-4 * diameter_of(positions_))
        bent_.add(mesh_.faces[face].line);
    if (polygon_.size() == 4 && reflex_corner_count(positions_, area) == 0)
        cut_quad(face);
    else
        clip(face, area);
}

void FaceCutter::cut_quad(std::uint32_t face)
{
    const auto [v0, v1, v2, v3] = std::array{polygon_[0], polygon_[1], polygon_[2], polygon_[3]};
    const std::array points = {point(v0), point(v1), point(v2), point(v3)};
    const bool one_frame = !mesh_.is_textured(mesh_.faces[face]) || is_parallelogram(points, mesh_);
    if (one_frame && is_parallelogram(at(v0), at(v1), at(v2), at(v3), scale_)) {
        result_.pieces.push_back({{vertex(v0), vertex(v1), vertex(v2), vertex(v3)}, face, points});
        return;
    }
    add_triangle(face, v0, v1, v2);
    add_triangle(face, v0, v2, v3);
}

void FaceCutter::clip(std::uint32_t face, Vec3 area)
{
    const double work =
        static_cast<double>(polygon_.size()) * static_cast<double>(reflex_corner_count(positions_, area));
    if (work > largest_clipping_work)
        refuse({mesh_.path, mesh_.faces[face].line}, "concave polygon of " + std::to_string(polygon_.size()) +
                                                         " corners, expected at most about 10,000: divide it");
    const Triangulation cut = clip_ears(positions_, area, scale_.smallest_area());
    if (cut.crosses_itself)
        crossed_.add(mesh_.faces[face].line);
    for (const auto& [a, b, c] : cut.triangles)
        add_triangle(face, polygon_[a], polygon_[b], polygon_[c]);
}

/// Removes corners on a straight side from polygon_; also corners at the same point as a neighbour, and spikes.
void FaceCutter::skip_straight_corners()
{
    std::vector<std::size_t>& p = polygon_;
    std::size_t kept = 0;
    for (const std::size_t corner : p) {
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
    if (p.size() == 3 && is_straight(p[0], p[1], p[2]))
        p.clear();
}

bool FaceCutter::is_straight(std::size_t a, std::size_t b, std::size_t c) const
{
    return area_of(at(a), at(b), at(c)) <= scale_.smallest_area();
}

void FaceCutter::load_positions()
{
    positions_.clear();
    for (const std::size_t corner : polygon_)
        positions_.push_back(at(corner));
}

void FaceCutter::add_triangle(std::uint32_t face, std::size_t a, std::size_t b, std::size_t c)
{
    if (!is_straight(a, b, c))
        result_.pieces.push_back({{vertex(a), vertex(b), vertex(c), Piece::no_vertex},
                                  face,
                                  {point(a), point(b), point(c), ObjMesh::no_point}});
}

void FaceCutter::add_warning(const FlawCount& flaw, const std::string& what)
{
    if (flaw.count == 0)
        return;
    const std::string others = flaw.count == 1 ? "" : " (and " + std::to_string(flaw.count - 1) + " more)";
    result_.warnings.push_back(name_of({mesh_.path, flaw.first_line}) + ": " + what + others);
}

} // namespace

SceneScale scale_of(const ObjMesh& mesh)
{
    Bounds box;
    for (const std::uint32_t corner : mesh.corners)
        box.include(mesh.vertices[corner]);
    const Vec3 size = box.size();
    return {std::max({size.x, size.y, size.z})};
}

bool has_texture_points(const Piece& piece, const ObjMesh& mesh)
{
    const auto end = piece.points.begin() + (piece.is_triangle() ? 3 : 4);
    return !mesh.corner_points.empty() && std::find(piece.points.begin(), end, ObjMesh::no_point) == end;
}

bool is_parallelogram(Vec3 v0, Vec3 v1, Vec3 v2, Vec3 v3, const SceneScale& scale)
{
    const auto square = [](Vec3 a) { return dot(a, a); };
    const double gap = square((v1 - v0) - (v2 - v3));
    return gap <= scale.widest_crack() * scale.widest_crack() &&
           gap <= 1e-6 * std::min(square(v1 - v0), square(v3 - v0));
}

bool is_parallelogram(const std::array<std::uint32_t, 4>& points, const ObjMesh& mesh)
{
    const auto has_none = [](std::uint32_t point) { return point == ObjMesh::no_point; };
    if (std::any_of(points.begin(), points.end(), has_none))
        return std::all_of(points.begin(), points.end(), has_none);
    const auto at = [&](std::size_t k) { return mesh.texture_points[points[k]]; };
    const auto square = [](double s, double t) { return s * s + t * t; };
    const double gap = square(at(1).s - at(0).s - (at(2).s - at(3).s), at(1).t - at(0).t - (at(2).t - at(3).t));
    const double side =
        std::min(square(at(1).s - at(0).s, at(1).t - at(0).t), square(at(3).s - at(0).s, at(3).t - at(0).t));
    return gap <= 1e-6 * side;
}

namespace {

/// Linear light half way between each sRGB value from 0 to 254 and the next.
std::array<double, 255> borders_of_levels()
{
    std::array<double, 255> borders = {};
    for (std::size_t level = 0; level < borders.size(); ++level)
        borders[level] = srgb_decoded((static_cast<double>(level) + 0.5) / 255.0);
    return borders;
}

void colour_pieces(const ObjMesh& mesh, MeshPieces& cut)
{
    const std::array<double, 255> borders = borders_of_levels();
    const auto level = [&](double linear) {
        return static_cast<std::uint8_t>(std::upper_bound(borders.begin(), borders.end(), linear) - borders.begin());
    };
    std::map<std::array<std::uint8_t, 3>, std::uint32_t> numbers;
    for (Piece& piece : cut.pieces) {
        Rgb sum;
        double count = 0.0;
        for (const std::uint32_t corner : piece.corners)
            if (corner != Piece::no_vertex && mesh.colours[corner].r >= 0.0) {
                sum += mesh.colours[corner];
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

#include "geometry/exchange_area.h"

#include "geometry/contour_integral.h"
#include "geometry/exchange_quadrature.h"
#include "geometry/flat_polygon.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace multipath {

namespace {

// Distances of the centres, in radii of the larger piece, from which on a rule errs by less than 1e-5 (root mean square
// over the pairs of a furnished room): nearest the contour integral, then points, then the expansion about the centres.
// Each costs five to ten times as much as the next.
constexpr double far_radii = 18.0;
constexpr double points_radii = 4.5;

bool apart_by(double radii, const FlatPiece& a, const FlatPiece& b)
{
    const Vec3 d = b.centre - a.centre;
    const double distance = radii * std::max(a.radius, b.radius);
    return dot(d, d) > distance * distance;
}

/// An order of pieces, so that a pair is computed one way round whichever is named first.
bool before(const FlatPiece& a, const FlatPiece& b)
{
    const auto key = [](const Surface& s) {
        return std::tie(s.shape, s.origin.x, s.origin.y, s.origin.z, s.edge_u.x, s.edge_u.y, s.edge_u.z, s.edge_v.x,
                        s.edge_v.y, s.edge_v.z);
    };
    return key(a.surface) < key(b.surface);
}

/// Of two pieces in one plane, face to face across a gap of no width.
double overlap(const FlatPiece& a, const FlatPolygon& a_polygon, const FlatPiece& b, const FlatPolygon& b_polygon)
{
    if (length(b.centre - a.centre) > a.radius + b.radius)
        return 0.0;
    const double area = contour_integral(a_polygon, projected(b_polygon, a.centre, a.normal));
    constexpr double rounding = 1e-9; // of the smaller: what is left where they only share an edge
    return area > rounding * std::min(a.area, b.area) ? area : 0.0;
}

/// By points on the triangles that make up a polygon and on those that make up the other.
double exchange_by_triangles(const FlatPolygon& a, const FlatPolygon& b)
{
    const auto triangle = [](const FlatPolygon& p, std::size_t k) {
        return Surface{Shape::triangle, p.corners[0], p.corners[k] - p.corners[0], p.corners[k + 1] - p.corners[0]};
    };
    double sum = 0.0;
    for (std::size_t k = 1; k + 1 < a.size; ++k)
        for (std::size_t l = 1; l + 1 < b.size; ++l) {
            const Surface s = triangle(a, k);
            const Surface t = triangle(b, l);
            if (s.area() > 0.0 && t.area() > 0.0)
                sum += exchange_by_points(piece_of(s), piece_of(t));
        }
    return sum;
}

/// Of pieces of which a part lies behind the other's plane. The plane of a is the horizon of all its points, so one
/// cut is enough.
double exchange_of_parts(const FlatPiece& a, const FlatPolygon& a_polygon, const FlatPiece& b,
                         const FlatPolygon& b_polygon, double touching)
{
    const FlatPolygon a_part = part_in_front(a_polygon, b.centre, b.normal, touching);
    const FlatPolygon b_part = part_in_front(b_polygon, a.centre, a.normal, touching);
    if (a_part.size == 0 || b_part.size == 0)
        return 0.0;
    return apart_by(points_radii, a, b) ? exchange_by_triangles(a_part, b_part) : contour_integral(a_part, b_part);
}

/// Of pieces whose circumscribed circles the planes may cut, or that are near each other.
double exchange_of_near(const FlatPiece& a, const FlatPiece& b, double touching)
{
    const FlatPolygon a_polygon = polygon_of(a.surface);
    const FlatPolygon b_polygon = polygon_of(b.surface);
    const HeightRange a_heights = heights(a_polygon, b.centre, b.normal);
    const HeightRange b_heights = heights(b_polygon, a.centre, a.normal);
    if (a_heights.high <= touching || b_heights.high <= touching) {
        const bool face_to_face = dot(a.normal, b.normal) < 0.0;
        const bool in_one_plane = a_heights.within(touching) || b_heights.within(touching);
        return face_to_face && in_one_plane ? overlap(a, a_polygon, b, b_polygon) : 0.0;
    }
    if (a_heights.low < -touching || b_heights.low < -touching)
        return exchange_of_parts(a, a_polygon, b, b_polygon, touching);
    if (apart_by(far_radii, a, b))
        return exchange_of_far(a, b);
    return apart_by(points_radii, a, b) ? exchange_by_points(a, b) : contour_integral(a_polygon, b_polygon);
}

} // namespace

double exchange_area(const FlatPiece& a, const FlatPiece& b, double touching)
{
    const Vec3 d = b.centre - a.centre;
    const double b_height = dot(d, a.normal);
    const double a_height = -dot(d, b.normal);
    if (b_height < -b.radius - touching || a_height < -a.radius - touching)
        return 0.0;
    if (b_height > b.radius && a_height > a.radius && apart_by(far_radii, a, b))
        return exchange_of_far(a, b);
    const double exchange = before(a, b) ? exchange_of_near(a, b, touching) : exchange_of_near(b, a, touching);
    return std::max(0.0, exchange); // the contour integral of a pair that sees next to nothing may round below
}

double exchange_area(const Surface& a, const Surface& b, double touching)
{
    return exchange_area(piece_of(a), piece_of(b), touching);
}

} // namespace multipath

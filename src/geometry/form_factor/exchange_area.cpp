// The exchange area of two planar surfaces is computed by the cheapest method that is accurate at their distance. From
// far to near:
// 1. the kernel cos cos' / (pi r^2) between the centres with its second-order expansion (exchange_of_far),
// 2. a quadrature rule on each surface (exchange_by_points),
// 3. Lambert's formula at the points of the smaller surface, or of its quarters (exchange_by_views),
// 4. the double contour integral, which is exact (contour_integral).
// A surface that crosses the plane of the other surface is first clipped to the front of this plane. Faces that lie in
// one plane and face each other exchange light through the area of their overlap.

#include "geometry/form_factor/exchange_area.h"

#include "base/elementary.h"
#include "geometry/form_factor/gauss_legendre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

namespace multipath {

namespace {

constexpr double inverse_pi = 1.0 / pi;

/// A F [m^2] of distant pieces that lie wholly in front of each other's planes: the kernel cos cos' / (pi r^2) between
/// the centres plus its second-order term. The relative error falls with the fourth power of distance / size and is
/// about 2e-5 at 18 radii of the larger piece.
double exchange_of_far(const FlatPiece& a, const FlatPiece& b)
{
    // The kernel is p q / (pi r^4) with the heights p = d.n_a and q = -d.n_b. A step t along an edge e of a changes d
    // to d - t e and leaves p as it is. The mean of t^2 is 1/12 for -1/2 < t < 1/2; its coefficient is
    //     p / r^4 (q (12 (d.e)^2 / r^4 - 2 e.e / r^2) + 4 (n_b.e) (d.e) / r^2).
    const Vec3 d = b.centre - a.centre;
    const double r2 = dot(d, d);
    const double p = dot(d, a.normal);
    const double q = -dot(d, b.normal);
    const double d_a_u = dot(d, a.spread_u);
    const double d_a_v = dot(d, a.spread_v);
    const double d_b_u = dot(d, b.spread_u);
    const double d_b_v = dot(d, b.spread_v);
    const double squares = (d_a_u * d_a_u + d_a_v * d_a_v) + (d_b_u * d_b_u + d_b_v * d_b_v);
    const double sizes = a.squared_spread + b.squared_spread;
    const double tilt_a = d_a_u * dot(b.normal, a.spread_u) + d_a_v * dot(b.normal, a.spread_v);
    const double tilt_b = d_b_u * dot(a.normal, b.spread_u) + d_b_v * dot(a.normal, b.spread_v);
    const double inverse_r2 = 1.0 / r2;
    const double curvature =
        p * q * (squares * inverse_r2 - sizes * (1.0 / 6.0)) + (p * tilt_a - q * tilt_b) * (1.0 / 3.0);
    return a.area * b.area * inverse_pi * (inverse_r2 * inverse_r2) * (p * q + curvature * inverse_r2);
}

/// Point of a quadrature rule on the unit square, or on the triangle u, v >= 0, u + v <= 1. The weights sum to 1.
struct RulePoint
{
    double u;
    double v;
    double weight;
};

/// Product of a rule in u and the same rule in v.
template <std::size_t n>
constexpr std::array<RulePoint, n * n> square_rule(const GaussRule<n>& rule)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i)
        sum += rule[i].weight;
    std::array<RulePoint, n * n> points{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            points[n * i + j] = {rule[i].place, rule[j].place, rule[i].weight * rule[j].weight / (sum * sum)};
    return points;
}

constexpr std::array<RulePoint, 4> coarse_square_rule = square_rule(gauss_2); // exact up to degree 3 in u and in v
constexpr std::array<RulePoint, 9> fine_square_rule = square_rule(gauss_3);   // up to degree 5

/// Four points on the triangle, exact up to degree 3.
constexpr std::array<RulePoint, 4> coarse_triangle_rule = {
    {{1.0 / 3, 1.0 / 3, -27.0 / 48}, {0.2, 0.2, 25.0 / 48}, {0.6, 0.2, 25.0 / 48}, {0.2, 0.6, 25.0 / 48}}};

/// Radon's seven points on the triangle, exact up to degree 5.
constexpr double radon_a = 0.1012865073234563;        // (6 - sqrt 15) / 21
constexpr double radon_b = 0.4701420641051151;        // (6 + sqrt 15) / 21
constexpr double radon_weight_a = 0.1259391805448271; // (155 - sqrt 15) / 1200
constexpr double radon_weight_b = 0.1323941527885062; // (155 + sqrt 15) / 1200
constexpr std::array<RulePoint, 7> fine_triangle_rule = {{{1.0 / 3, 1.0 / 3, 9.0 / 40},
                                                          {radon_a, radon_a, radon_weight_a},
                                                          {1.0 - 2.0 * radon_a, radon_a, radon_weight_a},
                                                          {radon_a, 1.0 - 2.0 * radon_a, radon_weight_a},
                                                          {radon_b, radon_b, radon_weight_b},
                                                          {1.0 - 2.0 * radon_b, radon_b, radon_weight_b},
                                                          {radon_b, 1.0 - 2.0 * radon_b, radon_weight_b}}};

constexpr std::size_t most_points = 9;

/// Quadrature points of a piece as a structure of arrays, so that compilers can vectorise loops over them.
struct PiecePoints
{
    std::size_t size = 0;
    std::array<double, most_points> x, y, z, weight;

    Vec3 point(std::size_t k) const { return {x[k], y[k], z[k]}; }
};

template <std::size_t n>
PiecePoints points_by_rule(const FlatPiece& piece, const std::array<RulePoint, n>& rule)
{
    PiecePoints points;
    for (const RulePoint& r : rule) {
        const Vec3 p = piece.surface.at(r.u, r.v);
        points.x[points.size] = p.x;
        points.y[points.size] = p.y;
        points.z[points.size] = p.z;
        points.weight[points.size++] = r.weight;
    }
    return points;
}

/// Quadrature points of the piece, fewer if the other piece is distant.
PiecePoints points_of(const FlatPiece& piece, double squared_distance)
{
    constexpr double coarse_radii = 12.0;
    const bool coarse = squared_distance > coarse_radii * coarse_radii * piece.radius * piece.radius;
    if (piece.surface.shape == Shape::triangle)
        return coarse ? points_by_rule(piece, coarse_triangle_rule) : points_by_rule(piece, fine_triangle_rule);
    return coarse ? points_by_rule(piece, coarse_square_rule) : points_by_rule(piece, fine_square_rule);
}

/// Weighted sum of p q / r^4 between one point of a and all points of b.
double sum_over_points(Vec3 from, Vec3 a_normal, Vec3 b_normal, const PiecePoints& b)
{
    std::array<double, most_points> kernel;
    for (std::size_t k = 0; k < b.size; ++k) {
        const double x = b.x[k] - from.x;
        const double y = b.y[k] - from.y;
        const double z = b.z[k] - from.z;
        const double r2 = x * x + y * y + z * z;
        const double p = x * a_normal.x + y * a_normal.y + z * a_normal.z;
        const double q = -(x * b_normal.x + y * b_normal.y + z * b_normal.z);
        kernel[k] = b.weight[k] * p * q / (r2 * r2);
    }
    double sum = 0.0;
    for (std::size_t k = 0; k < b.size; ++k)
        sum += kernel[k];
    return sum;
}

/// The same by quadrature over both pieces; the relative error is about 1e-5 at 4.5 radii of the larger one.
double exchange_by_points(const FlatPiece& a, const FlatPiece& b)
{
    const Vec3 d = b.centre - a.centre;
    const PiecePoints a_points = points_of(a, dot(d, d));
    const PiecePoints b_points = points_of(b, dot(d, d));
    double sum = 0.0;
    for (std::size_t k = 0; k < a_points.size; ++k)
        sum += a_points.weight[k] * sum_over_points(a_points.point(k), a.normal, b.normal, b_points);
    return a.area * b.area * inverse_pi * sum;
}

} // namespace

FlatPiece::FlatPiece(const Surface& whole)
    : surface(whole), normal(whole.normal()), centre(whole.centre()), area(whole.area())
{
    const Vec3 u = whole.edge_u;
    const Vec3 v = whole.edge_v;
    if (whole.shape == Shape::parallelogram) {
        radius = 0.5 * std::max(length(u + v), length(u - v));
        spread_u = u;
        spread_v = v;
    } else {
        radius = std::max({length(u + v), length(2.0 * u - v), length(2.0 * v - u)}) / 3.0;
        // The covariance (u u^T + v v^T + (u - v)(u - v)^T) / 36 as a sum of two squares.
        spread_u = (1.0 / std::sqrt(6.0)) * (u + v);
        spread_v = (1.0 / std::sqrt(2.0)) * (u - v);
    }
    squared_spread = dot(spread_u, spread_u) + dot(spread_v, spread_v);
}

namespace {

// Smallest distances of the centres, in radii of the larger piece, at which a method has an error below 1e-5 (root mean
// square over the pairs of a furnished room). The contour integral, quadrature and the expansion about the centres each
// cost five to ten times as much as the next. For Lambert's formula at points of the smaller piece, the limit is the
// distance from the other polygon in radii of the smaller one.
constexpr double far_radii = 18.0;
constexpr double points_radii = 4.5;
constexpr double views_radii = 3.0;

/// True if the centres are more than so many radii of the larger piece apart.
bool apart_by(double radii, const FlatPiece& a, const FlatPiece& b)
{
    const Vec3 d = b.centre - a.centre;
    const double distance = radii * std::max(a.radius, b.radius);
    return dot(d, d) > distance * distance;
}

/// Divides the surface into four similar ones of half the size.
std::vector<FlatPiece> quarters(const Surface& s)
{
    const Vec3 u = 0.5 * s.edge_u;
    const Vec3 v = 0.5 * s.edge_v;
    const double turn = s.shape == Shape::triangle ? -1.0 : 1.0;
    return {Surface{s.shape, s.origin, u, v}, Surface{s.shape, s.origin + u, u, v},
            Surface{s.shape, s.origin + v, u, v}, Surface{s.shape, s.origin + u + v, turn * u, turn * v}};
}

/// Exchange area of surfaces and a polygon that their fronts see wholly, by Lambert's formula at quadrature points of
/// the surfaces or of their quarters. std::nullopt if the polygon is too near.
std::optional<double> exchange_by_views(const std::vector<FlatPiece>& pieces, const FlatPolygon& seen, bool may_cut)
{
    double sum = 0.0;
    for (const FlatPiece& piece : pieces) {
        const double away = distance(piece.centre, seen);
        double of_piece = 0.0;
        if (away >= views_radii * piece.radius) {
            const PiecePoints points = points_of(piece, away * away);
            for (std::size_t k = 0; k < points.size; ++k)
                of_piece += points.weight[k] * irradiance_from(seen, points.point(k), piece.normal);
            of_piece *= piece.area;
        } else if (may_cut && away >= 0.5 * views_radii * piece.radius) {
            const std::optional<double> of_quarters = exchange_by_views(quarters(piece.surface), seen, false);
            if (!of_quarters)
                return std::nullopt;
            of_piece = *of_quarters;
        } else {
            return std::nullopt;
        }
        sum += of_piece;
    }
    return sum;
}

/// Arbitrary but fixed order of pieces: (a, b) and (b, a) are computed in the same order and give the same bits.
bool before(const FlatPiece& a, const FlatPiece& b)
{
    const auto key = [](const Surface& s) {
        return std::tie(s.shape, s.origin.x, s.origin.y, s.origin.z, s.edge_u.x, s.edge_u.y, s.edge_u.z, s.edge_v.x,
                        s.edge_v.y, s.edge_v.z);
    };
    return key(a.surface) < key(b.surface);
}

/// Area of the overlap of two pieces that lie in one plane and face each other.
double overlap(const FlatPiece& a, const FlatPolygon& a_polygon, const FlatPiece& b, const FlatPolygon& b_polygon)
{
    if (length(b.centre - a.centre) > a.radius + b.radius)
        return 0.0;
    const double area = contour_integral(a_polygon, projected(b_polygon, a.centre, a.normal));
    constexpr double rounding = 1e-9; // share of the smaller area: residue of pieces that only share an edge
    return area > rounding * std::min(a.area, b.area) ? area : 0.0;
}

/// A triangle fan from the first corner of the polygon, without triangles of area zero.
std::vector<FlatPiece> triangles_of(const FlatPolygon& polygon)
{
    std::vector<FlatPiece> triangles;
    triangles.reserve(polygon.size);
    for (std::size_t k = 1; k + 1 < polygon.size; ++k) {
        const Vec3 corner = polygon.corners[0];
        const Surface triangle = {Shape::triangle, corner, polygon.corners[k] - corner,
                                  polygon.corners[k + 1] - corner};
        if (triangle.area() > 0.0)
            triangles.push_back(triangle);
    }
    return triangles;
}

/// Exchange area by quadrature over the triangles of both polygons.
double exchange_by_triangles(const FlatPolygon& a, const FlatPolygon& b)
{
    const std::vector<FlatPiece> b_triangles = triangles_of(b);
    double sum = 0.0;
    for (const FlatPiece& s : triangles_of(a))
        for (const FlatPiece& t : b_triangles)
            sum += exchange_by_points(s, t);
    return sum;
}

/// Exchange area of pieces that are near each other or may cross each other's planes.
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
    const bool wholly = a_heights.low >= -touching && b_heights.low >= -touching;
    if (wholly && apart_by(far_radii, a, b))
        return exchange_of_far(a, b);
    if (wholly && apart_by(points_radii, a, b))
        return exchange_by_points(a, b);
    // The plane of each piece is the horizon of all its points, so clipping the other one once is enough.
    const FlatPolygon a_part = part_in_front(a_polygon, b.centre, b.normal, touching);
    const FlatPolygon b_part = part_in_front(b_polygon, a.centre, a.normal, touching);
    if (a_part.empty() || b_part.empty())
        return 0.0;
    if (!wholly && apart_by(points_radii, a, b))
        return exchange_by_triangles(a_part, b_part);
    const bool a_is_small = a.radius < b.radius;
    const bool small_is_whole = (a_is_small ? a_heights : b_heights).low >= -touching;
    const FlatPolygon& seen = a_is_small ? b_part : a_part;
    const std::vector<FlatPiece> small =
        small_is_whole ? std::vector{a_is_small ? a : b} : triangles_of(a_is_small ? a_part : b_part);
    const std::optional<double> exchange = exchange_by_views(small, seen, true);
    return exchange ? *exchange : contour_integral(a_part, b_part);
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
    return std::max(0.0, exchange); // rounding may make a tiny contour integral negative
}

} // namespace multipath

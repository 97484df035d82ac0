// A pair of edges at the angle alpha contributes cos(alpha) times the double integral of ln r over s along the first
// edge and t along the second. With s and t measured from the feet of the common perpendicular, whose length is h,
//     r^2 = h^2 + s^2 + t^2 - 2 s t cos(alpha),
//     d(s ln r)/ds + d(t ln r)/dt = 2 ln r + 1 - h^2 / r^2.
// The divergence theorem in the rectangle of (s, t) therefore leaves two kinds of integrals: those of ln r from a
// corner to an edge, which are elementary, and that of h^2 / r^2. The latter is not elementary, but it vanishes if the
// edges meet, where ln r is singular. The substitution s = h sinh(x) / sin(alpha) turns it into an integral over x of
// the angle that the second edge subtends, which is smooth and left to Gauss-Legendre quadrature.
//
// For parallel edges everything is elementary; perpendicular edges contribute nothing. For nearly parallel edges, which
// rounded coordinates produce, the feet are so far away that digits cancel: there the integral of ln r from a point of
// the first edge to the second edge is integrated by Gauss-Legendre quadrature.

#include "geometry/form_factor/exchange_area.h"

#include "base/elementary.h"
#include "geometry/form_factor/gauss_legendre.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace multipath {

namespace {

struct Edge
{
    Vec3 from;
    Vec3 direction; ///< unit vector
    double length;
};

std::vector<Edge> edges_of(const FlatPolygon& polygon)
{
    std::vector<Edge> edges;
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vec3 along = polygon.next(k) - polygon.corners[k];
        const double l = length(along);
        edges.push_back({polygon.corners[k], l > 0.0 ? (1.0 / l) * along : Vec3{}, l});
    }
    return edges;
}

/// ln r, or 0 at r = 0, where its factor is a length that vanishes.
double log_distance(double squared_distance)
{
    return squared_distance > 0.0 ? 0.5 * elementary::log(squared_distance) : 0.0;
}

/// Integral of ln r from a point to an edge.
double point_to_edge(Vec3 point, const Edge& edge)
{
    const Vec3 to = edge.from - point;
    const double begin = dot(to, edge.direction);
    const double end = begin + edge.length;
    const Vec3 across = to - begin * edge.direction;
    const double w2 = dot(across, across);
    const double w = std::sqrt(w2);
    return end * log_distance(end * end + w2) - begin * log_distance(begin * begin + w2) - edge.length +
           w * elementary::atan2(w * edge.length, w2 + begin * end);
}

/// Second antiderivative in u of ln r, with r^2 = u^2 + h^2: for two parallel lines at distance h.
double parallel_term(double u, double h)
{
    return 0.5 * (u * u - h * h) * log_distance(u * u + h * h) - 0.75 * u * u + h * u * elementary::atan2(u, h);
}

/// Integral of ln r over two parallel edges.
double parallel_edges(const Edge& a, const Edge& b, double cosine, double)
{
    const Vec3 to = b.from - a.from;
    const double begin = dot(to, a.direction);
    const Vec3 across = to - begin * a.direction;
    const double h = length(across);
    const double end = begin + std::copysign(b.length, cosine);
    const double sum = parallel_term(end, h) - parallel_term(end - a.length, h) - parallel_term(begin, h) +
                       parallel_term(begin - a.length, h);
    return std::copysign(1.0, cosine) * sum;
}

/// Integral of a function by Gauss-Legendre quadrature with ten nodes, with bisection until is_smooth(begin, end).
template <class Function, class IsSmooth>
double integral(const Function& function, const IsSmooth& is_smooth, double begin, double end)
{
    const double middle = 0.5 * (begin + end);
    if (!is_smooth(begin, end))
        return integral(function, is_smooth, begin, middle) + integral(function, is_smooth, middle, end);
    const double half = 0.5 * (end - begin);
    double sum = 0.0;
    for (const GaussNode& node : half_gauss_10)
        sum += node.weight * (function(middle - half * node.place) + function(middle + half * node.place));
    return half * sum;
}

/// Two edges that are not parallel, with s and t measured from the feet of the common perpendicular of their lines.
struct SkewEdges
{
    double s_begin, s_end;
    double t_begin, t_end;
    double h; ///< distance of the lines
    double sine, cosine;
};

/// The angle that the second edge subtends at the point s = h sinh(x) / sin(alpha) of the first line.
double subtended_angle(const SkewEdges& e, double x)
{
    const double up = elementary::exp(x);
    const double down = 1.0 / up;
    const double foot = e.h * e.cosine / e.sine * 0.5 * (up - down);
    const double distance = e.h * 0.5 * (up + down);
    return elementary::atan2(distance * (e.t_end - e.t_begin),
                             distance * distance + (e.t_end - foot) * (e.t_begin - foot));
}

/// True if ten nodes suffice for this interval. As a function of a complex x the angle is singular where r = 0 at an
/// end of the second edge: at asinh(t sin(alpha) / h) plus or minus i times the acute angle of the edges.
bool is_smooth(const SkewEdges& e, double begin, double end)
{
    const double half = 0.5 * (end - begin);
    constexpr double negligible = 1e-9;
    if (e.h * e.h / e.sine * half < negligible * (e.s_end - e.s_begin) * (e.t_end - e.t_begin))
        return true;
    const double sine = std::min(e.sine, 1.0);
    const double height = elementary::atan2(sine, std::sqrt((1.0 - sine) * (1.0 + sine)));
    for (const double t : {e.t_begin, e.t_end}) {
        const double position = elementary::asinh(std::copysign(t, t * e.cosine) * e.sine / e.h);
        const double gap = std::max({0.0, begin - position, position - end});
        if (gap * gap + height * height < half * half)
            return false;
    }
    return true;
}

/// Integral of h^2 / r^2 over both edges.
double apart_term(const SkewEdges& e)
{
    constexpr double meeting = 1e-10;
    if (e.h < meeting * std::min(e.s_end - e.s_begin, e.t_end - e.t_begin))
        return 0.0;
    const double x_begin = elementary::asinh(e.s_begin * e.sine / e.h);
    const double x_end = elementary::asinh(e.s_end * e.sine / e.h);
    const auto angle = [&](double x) { return subtended_angle(e, x); };
    const auto smooth = [&](double begin, double end) { return is_smooth(e, begin, end); };
    return e.h * e.h / e.sine * integral(angle, smooth, x_begin, x_end);
}

/// Integral of ln r over two edges that are not parallel.
double skew_edges(const Edge& a, const Edge& b, double cosine, double squared_sine)
{
    const Vec3 to = b.from - a.from;
    const double along_a = dot(to, a.direction);
    const double along_b = dot(to, b.direction);
    const double sine = std::sqrt(squared_sine);
    const double s_begin = (cosine * along_b - along_a) / squared_sine;
    const double t_begin = (along_b - cosine * along_a) / squared_sine;
    const double h = std::abs(dot(to, cross(a.direction, b.direction))) / sine;
    const SkewEdges e = {s_begin, s_begin + a.length, t_begin, t_begin + b.length, h, sine, cosine};

    const Vec3 a_end = a.from + a.length * a.direction;
    const Vec3 b_end = b.from + b.length * b.direction;
    const double border = e.s_end * point_to_edge(a_end, b) - e.s_begin * point_to_edge(a.from, b) +
                          e.t_end * point_to_edge(b_end, a) - e.t_begin * point_to_edge(b.from, a);
    return 0.5 * (border - a.length * b.length + apart_term(e));
}

/// Complex position along the line of an edge where the integral of ln r to another edge is singular.
struct Singularity
{
    double position; ///< real part, from the beginning of the edge
    double height;   ///< imaginary part
};

/// Singularity because of a point: where the distance to it is 0.
Singularity singularity_at(Vec3 point, const Edge& edge)
{
    const Vec3 to = point - edge.from;
    const double position = dot(to, edge.direction);
    return {position, length(to - position * edge.direction)};
}

/// Integral of ln r over two edges that are nearly parallel: of point_to_edge(., b) over a.
double nearly_parallel_edges(const Edge& a, const Edge& b, double cosine, double squared_sine)
{
    const Vec3 to = b.from - a.from;
    const double foot = (dot(to, a.direction) - cosine * dot(to, b.direction)) / squared_sine;
    const double h = std::abs(dot(to, cross(a.direction, b.direction))) / squared_sine;
    const std::array<Singularity, 3> singularities = {
        {singularity_at(b.from, a), singularity_at(b.from + b.length * b.direction, a), {foot, h}}};
    const auto smooth = [&](double begin, double end) {
        constexpr double negligible = 1e-10;
        constexpr double away = 2.0; // in half intervals; then the error of ten nodes is 1e-11
        const double middle = 0.5 * (begin + end);
        const double half = 0.5 * (end - begin);
        return half <= negligible * a.length ||
               std::none_of(singularities.begin(), singularities.end(), [&](const Singularity& at) {
                   return elementary::hypot(at.position - middle, at.height) < away * half;
               });
    };
    return integral([&](double s) { return point_to_edge(a.from + s * a.direction, b); }, smooth, 0.0, a.length);
}

} // namespace

double contour_integral(const FlatPolygon& a, const FlatPolygon& b)
{
    constexpr double perpendicular = 1e-12;
    constexpr double parallel = 1e-9;
    constexpr double nearly_parallel = 1e-3;
    const std::vector<Edge> b_edges = edges_of(b);
    double sum = 0.0;
    for (const Edge& e : edges_of(a))
        for (const Edge& f : b_edges) {
            const double cosine = dot(e.direction, f.direction);
            if (std::abs(cosine) < perpendicular)
                continue;
            const Vec3 turn = cross(e.direction, f.direction);
            const double squared_sine = dot(turn, turn);
            const auto integral = squared_sine < parallel * parallel                 ? parallel_edges
                                  : squared_sine < nearly_parallel * nearly_parallel ? nearly_parallel_edges
                                                                                     : skew_edges;
            sum += cosine * integral(e, f, cosine, squared_sine);
        }
    return sum / (2.0 * pi);
}

} // namespace multipath

#include "radiosity/reuse/light_pair.h"

#include "geometry/form_factor/contour_integral.h"
#include "geometry/pi.h"
#include "sampling/warp.h"

#include <algorithm>

namespace multipath {

FlatRegion::FlatRegion(const Surface& whole)
{
    append(whole);
}

FlatRegion::FlatRegion(const FlatPolygon& polygon)
{
    const Vec3 first = polygon.corners[0];
    for (std::size_t k = 1; k + 1 < polygon.size; ++k)
        append({Shape::triangle, first, polygon.corners[k] - first, polygon.corners[k + 1] - first});
}

void FlatRegion::append(const Surface& piece)
{
    const double area_before = count_ > 0 ? area_end_[count_ - 1] : 0.0;
    area_end_[count_] = area_before + piece.area();
    pieces_[count_++] = piece;
}

Vec3 FlatRegion::uniform_point(double a, double b) const
{
    // A point on the very border could be put outside by rounding.
    const auto inside = [](double x) { return std::clamp(x, 0x1p-30, 1.0 - 0x1p-30); };
    const double area = a * area_end_[count_ - 1];
    std::size_t k = 0;
    while (k + 1 < count_ && area >= area_end_[k])
        ++k;
    const double area_before = k > 0 ? area_end_[k - 1] : 0.0;
    const double share = inside((area - area_before) / (area_end_[k] - area_before));
    if (pieces_[k].shape == Shape::parallelogram)
        return pieces_[k].at(share, inside(b));
    const Barycentric place = square_to_uniform_triangle(share, inside(b));
    return pieces_[k].at(place.u, place.v);
}

namespace {

/// Gauss-Legendre rules on [-1, 1]: the positive places and their weights.
struct GaussRule
{
    std::size_t half;
    std::array<double, 4> place;
    std::array<double, 4> weight;

    std::size_t size() const { return 2 * half; }
    double at(std::size_t k) const { return 0.5 + (k < half ? -0.5 * place[k] : 0.5 * place[k - half]); } // in [0, 1]
    double share(std::size_t k) const { return 0.5 * weight[k < half ? k : k - half]; }                   // sum is 1
};

constexpr GaussRule two_points = {1, {0.57735026918962576}, {1.0}};
constexpr GaussRule four_points = {
    2, {0.33998104358485626, 0.86113631159405258}, {0.65214515486254614, 0.34785484513745386}};
constexpr GaussRule eight_points = {
    4,
    {0.18343464249564980, 0.52553240991632899, 0.79666647741362674, 0.96028985649753623},
    {0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626}};

/// Integral of f over the piece.
template <class Function>
double integral(const Surface& piece, const GaussRule& rule, const Function& f)
{
    double mean = 0.0;
    for (std::size_t i = 0; i < rule.size(); ++i)
        for (std::size_t j = 0; j < rule.size(); ++j) {
            double u = rule.at(i);
            double v = rule.at(j);
            double weight = rule.share(i) * rule.share(j);
            if (piece.shape == Shape::triangle) { // the square with one side drawn together to a corner
                weight *= 2.0 * (1.0 - u);
                v *= 1.0 - u;
            }
            mean += weight * f(piece.at(u, v));
        }
    return piece.area() * mean;
}

double radius(const Surface& piece)
{
    return 0.5 * std::max(length(piece.edge_u + piece.edge_v), length(piece.edge_u - piece.edge_v));
}

/// [radii of the piece] Between its circumscribed circle and the light; less than 0 where the light may touch it.
double gap(const Surface& piece, const FlatPolygon& light)
{
    return distance(piece.centre(), light) / radius(piece) - 1.0;
}

/// Irradiance bends most near the light: points as dense as the distance asks for.
template <class Function>
double integral_near(const Surface& piece, const FlatPolygon& light, const Function& f)
{
    const double radii = gap(piece, light);
    return integral(piece, radii > 6.0 ? two_points : radii > 1.0 ? four_points : eight_points, f);
}

FlatRegion region(const Surface& whole, const FlatPolygon& part)
{
    const FlatPolygon uncut = polygon_of(whole);
    const bool is_whole =
        part.size == uncut.size && std::equal(uncut.corners.begin(), uncut.corners.begin() + 3, part.corners.begin());
    return is_whole ? FlatRegion(whole) : FlatRegion(part);
}

} // namespace

LightPair::LightPair(const Surface& receiver, const Surface& light, double clamp_area)
    : receiver_surface_(receiver),
      receiver_normal_(receiver.normal()),
      light_normal_(light.normal()),
      light_outline_(part_above_horizon(light, receiver.origin, receiver_normal_)),
      receiver_outline_(part_above_horizon(receiver, light.origin, light_normal_)),
      receiver_(region(receiver, receiver_outline_)),
      light_(region(light, light_outline_)),
      clamp_area_(clamp_area),
      faces_(!light_outline_.empty() && !receiver_outline_.empty())
{
}

double LightPair::exchange() const
{
    // Where they may touch, no points are dense enough. Rounding must not make the integral impossible.
    if (std::any_of(receiver_.begin(), receiver_.end(),
                    [this](const Surface& piece) { return gap(piece, light_outline_) <= 0.0; }))
        return std::clamp(contour_integral(receiver_outline_, light_outline_), 0.0,
                          std::min(receiver_.area(), light_.area()));
    double sum = 0.0;
    for (const Surface& piece : receiver_)
        sum += integral_near(piece, light_outline_,
                             [&](Vec3 x) { return irradiance_from(light_outline_, x, receiver_normal_); });
    return sum;
}

LightPair::Points LightPair::points(const Item& item) const
{
    return {receiver_.uniform_point(item[0], item[1]), light_.uniform_point(item[2], item[3])};
}

bool LightPair::is_near() const
{
    return distance(receiver_surface_.centre(), light_outline_) < radius(receiver_surface_);
}

std::optional<Vec3> LightPair::target(const Line& ray) const
{
    const double towards = -dot(light_normal_, ray.direction);
    const double height = dot(light_normal_, ray.origin - light_outline_.corners[0]);
    if (!(towards > 0.0 && height > 0.0))
        return std::nullopt;
    const Vec3 target = ray.at(height / towards);
    return contains(light_outline_, target) ? std::optional<Vec3>(target) : std::nullopt;
}

double LightPair::kernel(const Points& points) const
{
    const Vec3 way = points.on_light - points.on_receiver;
    const double square = dot(way, way);
    const double cosines = dot(receiver_normal_, way) * -dot(light_normal_, way); // times r^2
    const double most = 1.0 / clamp_area_;
    return square > 0.0 ? std::clamp(cosines / (pi * square * square), 1e-12 * most, most) : most;
}

} // namespace multipath

#include "selftest/known_scenes.h"

#include "base/elementary.h"
#include "scene/scene_builder.h"

#include <cmath>

namespace multipath {

namespace {

/// The closed forms sum term(i, j, k, l), with the sign (-1)^(i + j + k + l), over both ends of four intervals.
template <class Term>
double sum_over_ends(const Term& term)
{
    double sum = 0.0;
    for (int bits = 0; bits < 16; ++bits) {
        const int i = bits & 1, j = bits >> 1 & 1, k = bits >> 2 & 1, l = bits >> 3;
        sum += ((i + j + k + l) % 2 == 0 ? 1.0 : -1.0) * term(i, j, k, l);
    }
    return sum;
}

} // namespace

double parallel_rectangles(Interval x1, Interval y1, Interval x2, Interval y2, double z)
{
    const auto term = [&](double u, double v) {
        const double p = std::sqrt(u * u + z * z);
        const double q = std::sqrt(v * v + z * z);
        return v * p * elementary::atan(v / p) + u * q * elementary::atan(u / q) -
               0.5 * z * z * elementary::log(u * u + v * v + z * z);
    };
    return sum_over_ends([&](int i, int j, int k, int l) { return term(x1[i] - x2[k], y1[j] - y2[l]); }) / (2.0 * pi);
}

double perpendicular_rectangles(Interval x1, Interval y, Interval x2, Interval z)
{
    const auto term = [](double u, double c2) {
        const double c = std::sqrt(c2);
        const double square = u * u + c2;
        return (c > 0.0 ? u * c * elementary::atan(u / c) : 0.0) -
               (square > 0.0 ? 0.25 * (c2 - u * u) * elementary::log(square) : 0.0);
    };
    const auto ends = [&](int i, int j, int k, int l) { return term(x1[i] - x2[k], y[j] * y[j] + z[l] * z[l]); };
    return sum_over_ends(ends) / (2.0 * pi);
}

// Scenes so simple that the light in them is known from a formula: reflections in a closed room sum to a geometric
// series, a few surfaces that see each other give equations that are solved by hand, and the light between two
// rectangles has a closed form. The comment of each scene derives its answers.

namespace {

constexpr Vec3 x_axis = {1, 0, 0};
constexpr Vec3 y_axis = {0, 1, 0};
constexpr Vec3 z_axis = {0, 0, 1};

/// The radiosity B of a patch in one channel. A watt left unshot would arrive, over all reflections, as at most
/// 1 / (1 - highest_reflectance) watts, and the patch would reflect `reflectance` of it.
KnownAnswer radiosity_of(const std::string& what, std::uint32_t patch, double Rgb::*channel, double value,
                         double highest_reflectance, double reflectance, double area)
{
    return {"B of " + what + " [W/m^2]", value,
            [=](const Scene&, const Solution& solution) { return solution.radiosity[patch].*channel; },
            reflectance / (1.0 - highest_reflectance) / area};
}

/// The exchange area A F between the only lamp, which is black and has radiosity 1, and a patch that is lit by it
/// alone.
KnownAnswer exchange_with(std::uint32_t patch, double reflectance, double value)
{
    return {"A F [m^2]", value,
            [=](const Scene& scene, const Solution& solution) {
                return scene.area(patch) * solution.radiosity[patch].g / reflectance;
            },
            1.0};
}

KnownAnswer escaping(double value)
{
    return {"power that escapes [W]", value,
            [](const Scene&, const Solution& solution) { return solution.balance.escaped.g; }, 1.0};
}

/// Furnace: a closed room with a box on its floor; all surfaces have the same E and rho. Every reflection returns the
/// share rho of the light, so B = E (1 + rho + rho^2 + ...) = E / (1 - rho) on every patch, also on the floor under the
/// box. Nothing escapes.
KnownScene furnace()
{
    constexpr Rgb reflectance = {0.2, 0.4, 0.6};
    constexpr Rgb emittance = {0.8, 1.2, 1.2};
    SceneBuilder builder;
    const std::uint32_t wall = builder.material(reflectance, emittance);
    builder.room({0, 0, 0}, {1, 2, 3}, wall).box({0.2, 0, 0.5}, {0.7, 0.8, 1.5}, wall);
    const auto answer = [&](const std::string& what, std::uint32_t patch, double Rgb::*channel, double area) {
        const double rho = reflectance.*channel;
        return radiosity_of(what, patch, channel, emittance.*channel / (1.0 - rho), rho, rho, area);
    };
    return {"furnace",
            builder.file(),
            {answer("the floor, red", 0, &Rgb::r, 3.0), answer("a wall, green", 3, &Rgb::g, 6.0),
             answer("the box's top, blue", 7, &Rgb::b, 0.5), escaping(0.0)}};
}

/// Two unit squares that face each other at distance 1: B_1 = E + rho_1 F B_2, B_2 = rho_2 F B_1. The share 1 - F of
/// the power that leaves them escapes.
KnownScene facing_squares()
{
    constexpr double emittance = 2.0;
    constexpr double rho_1 = 0.4;
    constexpr double rho_2 = 0.7;
    constexpr Interval unit = {0.0, 1.0};
    const double f = parallel_rectangles(unit, unit, unit, unit, 1.0);
    const double b_1 = emittance / (1.0 - rho_1 * rho_2 * f * f);
    const double b_2 = rho_2 * f * b_1;
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, z_axis, x_axis, builder.grey(rho_1, emittance));
    builder.rectangle({0, 1, 0}, x_axis, z_axis, builder.grey(rho_2, 0.0));
    return {"facing-squares",
            builder.file(),
            {radiosity_of("the lamp", 0, &Rgb::g, b_1, rho_2, rho_1, 1.0),
             radiosity_of("the other", 1, &Rgb::g, b_2, rho_2, rho_2, 1.0), escaping((1.0 - f) * (b_1 + b_2))}};
}

/// A lamp and a perpendicular wall that have a part of an edge in common.
KnownScene perpendicular()
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, x_axis, y_axis, builder.grey(0.0, 1.0));
    builder.rectangle({0.25, 0, 0}, 0.5 * z_axis, 1.75 * x_axis, builder.grey(0.5, 0.0));
    const double exchange = perpendicular_rectangles({0.0, 1.0}, {0.0, 1.0}, {0.25, 2.0}, {0.0, 0.5});
    return {"perpendicular", builder.file(), {exchange_with(1, 0.5, exchange)}};
}

/// The facing squares with a black screen that joins their middle lines: each half sees only the half on its own side,
/// so A F = 2 (A F of two halves).
KnownScene screened()
{
    SceneBuilder builder;
    const std::uint32_t black = builder.grey(0.0, 0.0);
    builder.rectangle({0, 0, 0}, z_axis, x_axis, builder.grey(0.0, 1.0));
    builder.rectangle({0, 1, 0}, x_axis, z_axis, builder.grey(0.5, 0.0));
    builder.rectangle({0.5, 0, 0}, y_axis, z_axis, black);
    builder.rectangle({0.5, 0, 0}, z_axis, y_axis, black);
    const double half = parallel_rectangles({0.0, 0.5}, {0.0, 1.0}, {0.0, 0.5}, {0.0, 1.0}, 1.0);
    return {"screened", builder.file(), {exchange_with(1, 0.5, 2.0 * half)}};
}

/// A glowing cube in the middle of a closed one. All light of the inner cube i reaches the outer cube o, so reciprocity
/// gives F_oi = A_i / A_o, and the share 1 - F_oi of the light of the outer cube returns to it: B_i = E + rho_i B_o,
/// B_o = rho_o (F_oi B_i + (1 - F_oi) B_o). By symmetry the six faces of each cube are alike.
KnownScene nested_cubes()
{
    constexpr double emittance = 3.0;
    constexpr double rho_i = 0.6;
    constexpr double rho_o = 0.5;
    constexpr double f_oi = 0.4 * 0.4;
    constexpr double b_i = emittance / (1.0 - rho_i * rho_o * f_oi / (1.0 - rho_o * (1.0 - f_oi)));
    constexpr double b_o = (b_i - emittance) / rho_i;
    SceneBuilder builder;
    builder.room({0, 0, 0}, {1, 1, 1}, builder.grey(rho_o, 0.0));
    builder.box({0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}, builder.grey(rho_i, emittance));
    return {"nested-cubes",
            builder.file(),
            {radiosity_of("the outer", 1, &Rgb::g, b_o, rho_i, rho_o, 1.0),
             radiosity_of("the inner", 8, &Rgb::g, b_i, rho_i, rho_i, 0.16)}};
}

} // namespace

std::vector<KnownScene> known_scenes()
{
    return {furnace(), facing_squares(), perpendicular(), screened(), nested_cubes()};
}

} // namespace multipath

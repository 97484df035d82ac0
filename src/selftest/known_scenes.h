#pragma once

#include "geometry/elementary.h"
#include "geometry/surface.h"
#include "geometry/vec3.h"
#include "radiosity/solve.h"
#include "scene/scene_file.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace multipath {

// Closed forms of the exchange area A F [m^2] of two rectangles, the area of one times its form factor to the other:
// A F = A_1 F_12 = A_2 F_21. From Howell, A Catalog of Radiation Heat Transfer Configuration Factors.

/// The coordinates [m] at which a rectangle begins and ends along one axis.
struct Interval
{
    double low;
    double high;
    /// `low` for k = 0, `high` for k = 1.
    double operator[](int k) const { return k == 0 ? low : high; }
};

/// The sign of a term of the closed forms, which sum over both ends of four intervals: (-1)^(i + j + k + l).
inline double sign_of(int i, int j, int k, int l)
{
    return (i + j + k + l) % 2 == 0 ? 1.0 : -1.0;
}

/// [m^2] A F of the rectangles x1 * y1 and x2 * y2 in parallel planes at the distance z > 0 [m] (Howell C-13).
inline double parallel_rectangles(Interval x1, Interval y1, Interval x2, Interval y2, double z)
{
    const auto term = [&](double u, double v) {
        const double p = std::sqrt(u * u + z * z);
        const double q = std::sqrt(v * v + z * z);
        return v * p * elementary::atan(v / p) + u * q * elementary::atan(u / q) -
               0.5 * z * z * elementary::log(u * u + v * v + z * z);
    };
    double sum = 0.0;
    for (int bits = 0; bits < 16; ++bits) {
        const int i = bits & 1, j = bits >> 1 & 1, k = bits >> 2 & 1, l = bits >> 3;
        sum += sign_of(i, j, k, l) * term(x1[i] - x2[k], y1[j] - y2[l]);
    }
    return sum / (2.0 * pi);
}

/// [m^2] A F of the rectangles x1 * y in the plane z = 0 and x2 * z in the plane y = 0 (Howell C-15). Each rectangle
/// lies on the positive side of the other's plane: y.low, z.low >= 0.
inline double perpendicular_rectangles(Interval x1, Interval y, Interval x2, Interval z)
{
    const auto term = [](double u, double c2) {
        const double c = std::sqrt(c2);
        const double square = u * u + c2;
        return (c > 0.0 ? u * c * elementary::atan(u / c) : 0.0) -
               (square > 0.0 ? 0.25 * (c2 - u * u) * elementary::log(square) : 0.0);
    };
    double sum = 0.0;
    for (int bits = 0; bits < 16; ++bits) {
        const int i = bits & 1, j = bits >> 1 & 1, k = bits >> 2 & 1, l = bits >> 3;
        sum += sign_of(i, j, k, l) * term(x1[i] - x2[k], y[j] * y[j] + z[l] * z[l]);
    }
    return sum / (2.0 * pi);
}

/// [1] Exact irradiance at a point with this unit normal from a lamp of radiosity 1 that opaque surfaces occlude in
/// part; 0 behind the lamp, which emits at its front. The polygon of the lamp is clipped by the horizon (the plane
/// through the point with the normal) and by the shadow of every blocker, and the visible parts are integrated by
/// Lambert's formula. The point must not lie in the plane of a blocker.
double irradiance_past(const std::vector<Surface>& blockers, const Surface& lamp, Vec3 point, Vec3 normal);

/// A quantity of a solved scene whose value is known from a formula.
struct KnownAnswer
{
    std::string quantity; ///< name and unit, such as "B of the floor, red [W/m^2]"
    double value;
    /// Computes the quantity from a solution.
    std::function<double(const Scene& scene, const Solution& solution)> read;
    /// [unit / W] Largest amount by which the quantity can be too low, for each watt that is left unshot.
    double per_unshot_watt;
};

/// A scene with known answers, which are derived for one patch per surface.
struct KnownScene
{
    std::string name;
    SceneFile file;
    std::vector<KnownAnswer> answers;
};

/// All known scenes. known_scenes.cpp derives the answers.
std::vector<KnownScene> known_scenes();

} // namespace multipath

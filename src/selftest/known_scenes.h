#pragma once

#include "radiosity/run/solution.h"
#include "scene/scene_file.h"

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

/// [m^2] A F of the rectangles x1 * y1 and x2 * y2 in parallel planes at the distance z > 0 [m] (Howell C-13).
double parallel_rectangles(Interval x1, Interval y1, Interval x2, Interval y2, double z);

/// [m^2] A F of the rectangles x1 * y in the plane z = 0 and x2 * z in the plane y = 0 (Howell C-15). Each rectangle
/// lies on the positive side of the other's plane: y.low, z.low >= 0.
double perpendicular_rectangles(Interval x1, Interval y, Interval x2, Interval z);

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

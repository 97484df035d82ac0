#pragma once

#include "radiosity/solve.h"
#include "scene/scene_file.h"

#include <functional>
#include <string>
#include <vector>

namespace multipath {

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

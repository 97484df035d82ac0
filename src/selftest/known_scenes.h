#pragma once

#include "radiosity/solve.h"
#include "scene/scene_file.h"

#include <functional>
#include <string>
#include <vector>

namespace multipath {

/// A quantity of a solved scene whose value follows from a formula.
struct KnownAnswer
{
    std::string quantity; ///< with its unit
    double value;
    std::function<double(const Scene& scene, const Solution& solution)> read;
    /// [unit / W] By how much the quantity can be too low for every watt that is left unshot.
    double per_unshot_watt;
};

/// A scene whose light is known. Every surface is one patch.
struct KnownScene
{
    std::string name;
    SceneFile file;
    std::vector<KnownAnswer> answers;
};

/// Each with its derivation in the source.
std::vector<KnownScene> known_scenes();

} // namespace multipath

#pragma once

#include "sampling/sequence.h"
#include "scene/scene_file.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace multipath {

/// A law that the exam can be made to break, to show that it would notice. What is broken is what the solver is given,
/// never what is expected of it.
enum class BrokenLaw {
    bidirectional, ///< (M2) power flows along the lines one way, and all lines run the same way
    cosine,        ///< rays leave evenly over the hemisphere, without Lambert's cosine
    crossings,     ///< (G1) the starts of the global lines crowd around a pole of the sphere
    forecast,      ///< (G3) every second line never comes, but the share of the others is as if it did
    pairing,       ///< lines are made of two successive 2-D items
    reflectance,   ///< every surface reflects a tenth less
    replicates,    ///< the runs of a row repeat each other
    visibility,    ///< screens are left out
};

/// In the order of the enumeration.
inline const std::vector<std::string_view> broken_law_names = {
    "bidirectional", "cosine", "crossings", "forecast", "pairing", "reflectance", "replicates", "visibility"};

/// The name must be one of them.
BrokenLaw broken_law_named(std::string_view name);

/// Surfaces of the material with this name are screens.
constexpr const char* screen_material = "screen";

/// The scene that is solved under a broken law; without one, the scene itself.
SceneFile with_law_broken(SceneFile file, std::optional<BrokenLaw> broken);

/// The items that serve for rays from patches, and for global lines, under a broken law; without one, those of the
/// sequence.
std::unique_ptr<Sequence> items_of_rays(std::unique_ptr<Sequence> sequence, std::optional<BrokenLaw> broken);
std::unique_ptr<Sequence> items_of_lines(std::unique_ptr<Sequence> sequence, std::optional<BrokenLaw> broken);

} // namespace multipath

#pragma once

#include "radiosity/light_pair.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// A patch and an emitting surface whose fronts face each other.
struct GatherPair
{
    std::uint32_t light; ///< place in GatherPairs::lights
    float exchange;      ///< [m^2] if nothing stands between
};

/// All such pairs of the patches of a scene and some lights.
struct GatherPairs
{
    std::vector<std::uint32_t> lights;   ///< surfaces
    std::vector<GatherPair> pairs;       ///< patch by patch, each in the order of the lights
    std::vector<std::size_t> first_pair; ///< of each patch; one entry more than patches
    /// [W] Per patch: from lights in the same plane across a gap of no width, as under a box that stands on a lamp.
    /// They are no pairs: nothing can stand between.
    std::vector<Rgb> contact;

    /// The number of a pair.
    std::optional<std::size_t> find(std::uint32_t patch, std::uint32_t light) const;
};

GatherPairs find_gather_pairs(const Scene& scene, std::vector<std::uint32_t> lights, int threads);

/// The geometry of a patch and an emitting surface.
LightPair light_pair(const Scene& scene, std::uint32_t patch, std::uint32_t light_surface);

/// [W/m^2] Of a surface's front.
Rgb surface_emittance(const Scene& scene, std::uint32_t surface);

} // namespace multipath

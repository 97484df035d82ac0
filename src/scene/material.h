#pragma once

#include "scene/rgb.h"

#include <cstdint>
#include <string>

namespace multipath {

/// The statement of MTL files that holds the emittance: older exporters have no `Ke` and put lamps into `Ka`.
enum class EmissionFrom { ke, ka };

/// What a surface does with light: it reflects diffusely and may emit.
struct Material
{
    std::string name;
    Rgb reflectance; ///< [1] rho, 0 <= rho <= 1 in each channel; MTL `Kd`; of a textured one the mean of its surfaces
    Rgb emittance;   ///< [W/m^2] E, own emission per area (radiant exitance); MTL `Ke`
    std::string source; ///< "file:line" of its definition, for messages

    static constexpr std::uint32_t no_texture = 0xffffffffu;
    std::uint32_t texture = no_texture; ///< index into SceneFile::textures; MTL `map_Kd`
    Rgb texture_scale = {};             ///< [1] reflectance where the texture is white
};

} // namespace multipath

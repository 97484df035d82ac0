#pragma once

#include "scene/rgb.h"

#include <cstdint>
#include <string>

namespace multipath {

/// The MTL statement that gives the emittance. Older exporters have no `Ke` and describe lamps by `Ka`.
enum class EmissionFrom { ke, ka };

/// A diffuse (Lambertian) material that may emit light.
struct Material
{
    std::string name;
    Rgb reflectance;    ///< [1] rho, 0 <= rho <= 1 in each channel; MTL `Kd`; if textured, the mean over its surfaces
    Rgb emittance;      ///< [W/m^2] E, own emission per area (radiant exitance); MTL `Ke`
    std::string source; ///< "file:line" of its definition, for messages

    static constexpr std::uint32_t no_texture = 0xffffffffu;
    std::uint32_t texture = no_texture; ///< index into SceneFile::textures; MTL `map_Kd`
    Rgb texture_scale = {};             ///< [1] factor of the texture: the reflectance where it is white
};

} // namespace multipath

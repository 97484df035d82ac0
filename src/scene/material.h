#pragma once

#include "scene/rgb.h"

#include <cstdint>
#include <string>

namespace multipath {

/// The statement of an MTL file that gives the emittance of a material: `Ke`, or `Ka` for files of older exporters,
/// which have no `Ke` and describe lamps by `Ka`.
enum class EmissionFrom { ke, ka };

/// A diffuse (Lambertian) material that may emit light.
struct Material
{
    std::string name;
    /// [1] rho, 0 <= rho <= 1 in each channel; MTL `Kd`. If textured: mean over all surfaces of the material.
    Rgb reflectance;
    /// [W/m^2] E, emitted power per area (radiant exitance); MTL `Ke` (or `Ka`, see EmissionFrom), times the mean of
    /// `map_Ke`.
    Rgb emittance;
    std::string source; ///< "file:line" of the definition of the material, for messages

    static constexpr std::uint32_t no_texture = 0xffffffffu;
    std::uint32_t texture = no_texture; ///< index into SceneFile::textures, or no_texture; MTL `map_Kd`
    Rgb texture_scale = {};             ///< [1] multiplies the texture: the reflectance where the texture is white
};

} // namespace multipath

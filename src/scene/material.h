#pragma once

#include "scene/rgb.h"

#include <string>

namespace multipath {

/// The statement of MTL files that holds the emittance: older exporters have no `Ke` and put lamps into `Ka`.
enum class EmissionFrom { ke, ka };

/// What a surface does with light: it reflects diffusely and may emit.
struct Material
{
    std::string name;
    Rgb reflectance;    ///< [1] rho, 0 <= rho <= 1 in each channel; MTL `Kd`
    Rgb emittance;      ///< [W/m^2] E, own emission per area (radiant exitance); MTL `Ke`
    std::string source; ///< "file:line" of its definition, for messages
};

} // namespace multipath

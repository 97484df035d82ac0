#pragma once

#include "scene/rgb.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The exchange areas of a scene: a symmetric matrix G_ij = A_i F_ij [m^2], with A_i the area of patch i and F_ij the
/// form factor. G_ij is the power [W] that patch j receives from patch i of radiosity 1 W/m^2, and also the power that
/// i receives from j of this radiosity. Immutable. Products have the same bits for any number of threads.
class Exchange
{
public:
    virtual ~Exchange() = default;

    virtual std::uint32_t size() const = 0; ///< number of patches

    /// Returns G x: the power [W] that each patch receives if x is the radiosity [W/m^2]; x must have size() elements.
    virtual std::vector<Rgb> apply(const std::vector<Rgb>& x, int threads) const = 0;

    /// G_ii [m^2]. Flat patches do not see themselves: this is only what rounding and noise leave over in row i.
    virtual double self_exchange(std::uint32_t patch) const = 0;

    /// Exchange area [m^2] of the patch with the outside of the scene.
    virtual double escaping(std::uint32_t patch) const = 0;

    /// Exchange area [m^2] of the patch with backs (sides of surfaces that have no patches).
    virtual double behind(std::uint32_t patch) const = 0;

    /// Sum over all j of G_ij, plus escaping and behind [m^2]: the area of the patch, or an estimate of the area from
    /// the lines that give G. A row and its losses, divided by the row area, add up to 1, whatever the noise.
    virtual double row_area(std::uint32_t patch) const = 0;
};

} // namespace multipath

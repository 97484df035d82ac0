#pragma once

#include "parallel/memory.h"
#include "scene/rgb.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// How light is exchanged between the patches of a scene: symmetric areas G_ij = A_i F_ij [m^2], the power that goes
/// from i to j, and from j to i, for a radiosity of 1 W/m^2. Immutable; the same for any number of threads.
class Exchange
{
public:
    virtual ~Exchange() = default;

    virtual std::uint32_t size() const = 0;

    /// y_i = sum over j of G_ij x_j for every patch i; power [W] for a radiosity x.
    virtual void multiply(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const = 0;

    std::vector<Rgb> apply(const std::vector<Rgb>& x, int threads) const
    {
        std::vector<Rgb> y = large_vector<Rgb>(size());
        multiply(x, threads, y);
        return y;
    }

    /// [m^2] G_ii; not zero only where rounding or noise is put into it.
    virtual double self_exchange(std::uint32_t patch) const = 0;

    /// [m^2] Share of the patch's exchange that leaves the scene, and that meets surfaces from behind.
    virtual double escaping(std::uint32_t patch) const = 0;
    virtual double behind(std::uint32_t patch) const = 0;

    /// [m^2] Sum over j of G_ij + escaping + behind: the area of the patch, or an estimate of it from the same lines. A
    /// row divided by it adds up to one, whatever the noise.
    virtual double row_area(std::uint32_t patch) const = 0;
};

} // namespace multipath

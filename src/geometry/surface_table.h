#pragma once

#include "geometry/hit.h"
#include "geometry/line.h"
#include "geometry/shared_planes.h"
#include "geometry/surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// The surfaces in the form in which lines are tested against them: a plane for t and two affine functions for
/// (u, v), eight surfaces side by side, so that a compiler can test several at once.
class SurfaceTable
{
public:
    SurfaceTable(const std::vector<Surface>& surfaces, const SharedPlanes& planes);

    std::uint32_t size() const { return size_; }

    /// The hit of the line with one surface, borders included. The definition that all faster code must reproduce.
    std::optional<Hit> hit(const Line& line, std::uint32_t surface) const;

    /// Calls visit(surface) for every surface that the line may meet: all that it does and hardly any other.
    /// Tests all surfaces, several at a time.
    template <class Visit>
    void for_each_candidate(const Line& line, const Visit& visit) const;

    /// Where `point`, known to lie in the plane of the surface, is on it; empty when it lies outside.
    std::optional<Hit> hit_at_point(Vec3 point, Vec3 direction, std::uint32_t surface) const;

private:
    static constexpr std::uint32_t width = 8;
    using Lanes = std::array<double, width>;

    struct Block
    {
        Lanes normal_x, normal_y, normal_z, offset; ///< points p of the plane: dot(normal, p) = offset
        Lanes u_x, u_y, u_z, u_0;                   ///< u = dot(u_xyz, p) + u_0
        Lanes v_x, v_y, v_z, v_0;
        Lanes triangle; ///< 1 for a triangle (u + v <= 1), 0 for a parallelogram (u <= 1, v <= 1)
    };

    static Lanes margins(const Line& line, const Block& block);

    std::uint32_t size_ = 0;
    std::vector<Block> blocks_;
};

template <class Visit>
void SurfaceTable::for_each_candidate(const Line& line, const Visit& visit) const
{
    for (std::uint32_t first = 0; first < size_; first += width) {
        const Lanes margin = margins(line, blocks_[first / width]);
        const std::uint32_t count = std::min(width, size_ - first);
        for (std::uint32_t i = 0; i < count; ++i)
            if (!(margin[i] < 0.0))
                visit(first + i);
    }
}

} // namespace multipath

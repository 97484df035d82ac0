#pragma once

#include "scene/scene.h"
#include "transport/exchange/pair_counts.h"

#include <cstdint>
#include <mutex>

namespace multipath {

/// [1] For two patches of opposite orientation in one plane: the share of their overlap where their fronts face each
/// other across a gap of no width, like the bottom of a box and the floor below it, also where faces of other solids
/// lie between them. 0 if they are back to back, like the two faces of a thin sheet, or do not overlap. To decide, rays
/// leave the smaller patch at up to 16 points that both contain, or at up to 1024 if these do not agree.
double share_in_contact(const Scene& scene, std::uint32_t a, std::uint32_t b);

/// The exchange area A_i F_ij [m^2] of every pair of patches without regard to obstacles (exchange_area, (F1) in
/// docs/equations.md). It is zero for patches of the same surface, and for coincident patches
/// where they are not in contact. The bits do not depend on the number of threads.
PairMatrix<float> unoccluded_exchange(const Scene& scene, int threads);

/// The matrix of unoccluded_exchange, computed on first use, so that lines can be cast before it takes memory.
/// Thread-safe. The scene must outlive this object.
class UnoccludedExchange
{
public:
    UnoccludedExchange(const Scene& scene, int threads) : scene_(scene), threads_(threads) {}

    /// The matrix [m^2]; the first call computes it.
    const PairMatrix<float>& table() const
    {
        std::call_once(found_, [this] { table_ = unoccluded_exchange(scene_, threads_); });
        return table_;
    }

private:
    const Scene& scene_;
    int threads_;
    mutable std::once_flag found_;
    mutable PairMatrix<float> table_{0};
};

} // namespace multipath

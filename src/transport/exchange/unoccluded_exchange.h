#pragma once

#include "scene/scene.h"
#include "transport/exchange/pair_matrix.h"

#include <mutex>

namespace multipath {

/// A F [m^2] of every pair of patches as if nothing stood between them: see exchange_area. Zero for patches of one
/// surface, and of coincident ones that are turned away from each other. The same bits for any number of threads.
PairMatrix<float> unoccluded_exchange(const Scene& scene, int threads);

/// The same, found when it is first asked for, so that lines can be cast before. Safe to share between threads; the
/// scene must outlive it.
class UnoccludedExchange
{
public:
    UnoccludedExchange(const Scene& scene, int threads) : scene_(scene), threads_(threads) {}

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

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace multipath {

/// Distribution over the numbers 0, 1, ... in proportion to their weights, sampled by its cumulative sums.
class DiscreteDistribution
{
public:
    /// Adds the weight >= 0 of the next number.
    void add(double weight) { sums_.push_back(total() + weight); }

    double total() const { return sums_.empty() ? 0.0 : sums_.back(); } ///< sum of all weights

    /// The number for x uniform in [0, 1). The total must not be 0.
    std::size_t at(double x) const
    {
        const auto found = std::upper_bound(sums_.begin(), sums_.end() - 1, x * total());
        return static_cast<std::size_t>(found - sums_.begin());
    }

private:
    std::vector<double> sums_; ///< of the weights up to each number
};

} // namespace multipath

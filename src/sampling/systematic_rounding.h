#pragma once

#include <cmath>
#include <cstdint>

namespace multipath {

/// Systematic sampling (Madow and Madow 1944): items go to many recipients, and each recipient's expected number of
/// items is rounded at random to a whole number. The expected numbers are added up one after the other, starting from
/// an offset. A recipient's rounded number is how many integers the running sum reaches or passes when the recipient's
/// own term is added. If the offset is uniform in [0, 1), the mean of each rounded number is the expected number, and
/// the sums of all rounded and all expected numbers differ by less than 1.
class SystematicRounding
{
public:
    /// `begin`: the offset or, to continue at a later recipient, the running sum so far; at least 0.
    explicit SystematicRounding(double begin) : given_(whole(begin)) {}

    /// The rounded number of the next recipient. `sum`: the running sum including the recipient's own term; it must not
    /// be smaller than the sum before.
    std::uint64_t up_to(double sum)
    {
        const std::uint64_t before = given_;
        given_ = whole(sum);
        return given_ - before;
    }
    /// The whole part of the running sum: the sum of all rounded numbers, if `begin` was in [0, 1).
    std::uint64_t given() const { return given_; }

    /// The largest whole number not above `sum` >= 0.
    static std::uint64_t whole(double sum) { return static_cast<std::uint64_t>(std::floor(sum)); }

private:
    std::uint64_t given_;
};

} // namespace multipath

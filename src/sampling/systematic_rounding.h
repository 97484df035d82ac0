#pragma once

#include <cmath>
#include <cstdint>

namespace multipath {

/// Systematic sampling (Madow and Madow 1944): rounds many expected numbers to whole ones at random. A running sum of
/// the expected numbers starts at an offset; each recipient gets the whole numbers that the sum passes with its own
/// term. If the offset is uniform in [0, 1), each recipient gets its expected number on average, and the total is off
/// by less than 1.
class SystematicRounding
{
public:
    /// `begin`: the running sum before the first recipient, usually the offset.
    explicit SystematicRounding(double begin) : given_(whole(begin)) {}

    /// The rounded number of the next recipient, given the running sum with its own term included.
    std::uint64_t up_to(double sum)
    {
        const std::uint64_t before = given_;
        given_ = whole(sum);
        return given_ - before;
    }
    /// The whole part of the running sum: the sum of all rounded numbers, if it began in [0, 1).
    std::uint64_t given() const { return given_; }

    /// The largest whole number not above `sum` >= 0.
    static std::uint64_t whole(double sum) { return static_cast<std::uint64_t>(std::floor(sum)); }

private:
    std::uint64_t given_;
};

} // namespace multipath

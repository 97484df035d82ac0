#pragma once

#include <cmath>
#include <cstdint>

namespace multipath {

/// Rounds expected numbers to whole ones by systematic sampling (Madow and Madow 1944): a running sum of what each of
/// many expects passes whole numbers, and each gets those that are passed with it. With a uniform random offset in [0,
/// 1), at which the sum begins, all get what they expect on the average, and the whole is right to one.
class SystematicRounding
{
public:
    explicit SystematicRounding(double begin) : given_(whole(begin)) {}

    /// The number of the next one, for the sum up to and including it.
    std::uint64_t up_to(double sum)
    {
        const std::uint64_t before = given_;
        given_ = whole(sum);
        return given_ - before;
    }
    std::uint64_t given() const { return given_; } ///< to all so far

    static std::uint64_t whole(double sum) { return static_cast<std::uint64_t>(std::floor(sum)); }

private:
    std::uint64_t given_;
};

} // namespace multipath

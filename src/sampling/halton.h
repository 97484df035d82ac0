#pragma once

#include "sampling/sequence.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The digits of n in `base` (at least 2) mirrored at the point: n = 6 = 110 in base 2 gives 0.011 = 0.375.
/// Digits are handled as integers and divided once, so the result is the nearest double but for the last bit, in [0,
/// 1). Digits of n beyond the 63rd bit of base^k no longer change a double and are left out.
double radical_inverse(std::uint64_t base, std::uint64_t n);

/// Radical inverses of one base, many at a time: the low digits come from a table, the high ones change seldom.
/// Differs from radical_inverse by at most one unit in the last place.
class RadicalInverse
{
public:
    explicit RadicalInverse(std::uint64_t base);

    std::uint64_t base() const { return base_; }
    double operator()(std::uint64_t n) const { return sum(low_[n % low_.size()], high_part(n / low_.size())); }

    /// Calls put(k, value) with the radical inverses of first + k for k = 0 ... count - 1.
    template <class Put>
    void for_range(std::uint64_t first, std::uint64_t count, const Put& put) const;

private:
    static double sum(double low, double high)
    {
        const double value = low + high;
        return value < 1.0 ? value : 1.0 - 0x1p-53;
    }
    double high_part(std::uint64_t high_digits) const;

    std::uint64_t base_;
    std::vector<double> low_; ///< radical inverses of 0 ... base^k - 1
};

template <class Put>
void RadicalInverse::for_range(std::uint64_t first, std::uint64_t count, const Put& put) const
{
    const std::uint64_t period = low_.size();
    std::uint64_t done = 0;
    while (done < count) {
        const std::uint64_t low = (first + done) % period;
        const double high = high_part((first + done) / period);
        const std::uint64_t run = period - low < count - done ? period - low : count - done;
        for (std::uint64_t k = 0; k < run; ++k)
            put(done + k, sum(low_[low + k], high));
        done += run;
    }
}

/// How the points of Halton's sequence are made random.
enum class HaltonKind {
    plain,
    shift,    ///< one random number per dimension is added modulo 1 (Cranley and Patterson 1976)
    permuted, ///< at every place, the digits are permuted at random
};

/// Point n has as coordinates the radical inverses of n in the bases, which must be pairwise coprime and at least 2.
/// Throws std::invalid_argument otherwise.
std::unique_ptr<Sequence> make_halton_sequence(HaltonKind kind, const std::vector<std::uint64_t>& bases,
                                               std::uint64_t seed);

/// `count` points: the first coordinate is n / count, the others as in Halton's sequence, which fills space more evenly
/// when the number of points is known beforehand (Hammersley 1960).
std::unique_ptr<Sequence> make_hammersley_sequence(std::uint64_t count, const std::vector<std::uint64_t>& bases);

/// The bases that the paper's 4-D items use (2, 7, 3, 5) for four dimensions, else the first primes.
std::vector<std::uint64_t> default_bases(int dimensions);

} // namespace multipath

#pragma once

#include "sampling/sequence.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// Radical inverse, in [0, 1): the digits of n in `base` (at least 2) mirrored at the radix point. For example, 6 = 110
/// in base 2 gives 0.011 = 0.375. The reversed digits form an integer, which is divided once, by a power of the base,
/// so rounding affects only the last bits. Only the low k digits are used, where base^k is the largest power up to
/// 2^63; in bases up to 1024 the higher digits are worth less than 2^-53 together.
double radical_inverse(std::uint64_t base, std::uint64_t n);

/// Computes radical inverses in one base fast: a table holds the radical inverses of the low digits, to which the
/// contribution of the high digits is added. In bases up to 1024 the result differs from radical_inverse by less than
/// 2^-50. With a key the digits are permuted, each digit position by a random permutation of its own, up to the last
/// position that changes a double; the leading zeros of n are permuted too, or the points would not be uniform.
class RadicalInverse
{
public:
    explicit RadicalInverse(std::uint64_t base, std::optional<std::uint64_t> key = {}); ///< base >= 2

    std::uint64_t base() const { return base_; }
    double operator()(std::uint64_t n) const { return sum(low_[n % low_.size()], high_part(n / low_.size())); }

    /// Calls put(k, value) with the radical inverse of first + k for k = 0 ... count - 1, in this order. Faster than
    /// single values, since the high digits are evaluated only when they change.
    template <class Put>
    void for_range(std::uint64_t first, std::uint64_t count, const Put& put) const;

private:
    static double sum(double low, double high)
    {
        const double value = low + high;
        return value < 1.0 ? value : 1.0 - 0x1p-53;
    }
    double high_part(std::uint64_t high_digits) const;
    double sum_of_permuted(std::uint64_t digits, std::size_t first, std::size_t end) const;

    std::uint64_t base_;
    /// permuted_[k][digit] = permuted digit * base^-(k + 1), for digit position k from the lowest digit of n on; empty
    /// without a key.
    std::vector<std::vector<double>> permuted_;
    std::size_t low_digits_ = 1; ///< number of digits that the table covers
    std::vector<double> low_;    ///< radical inverses of all values of the low digits
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

/// Halton sequence: the coordinates of point n are the radical inverses of n in the bases, one base per dimension. It
/// is randomised by a shift, one random number per dimension that is added modulo 1 (Cranley and Patterson 1976), or by
/// a permutation of the digits for each digit position of each base. Throws std::invalid_argument unless the bases are
/// pairwise coprime and between 2 and 1,000,000.
std::unique_ptr<Sequence> make_halton_sequence(const SequenceRequest& request, const std::vector<std::uint64_t>& bases);

/// Hammersley point set (Hammersley 1960) of `count` points: the first coordinate of point n is n / count, the others
/// are the radical inverses of n in the bases. It is more uniform than the Halton sequence, but needs to know the
/// number of points beforehand. Throws std::invalid_argument for a count outside 1 ... 2^52, and for bases that
/// make_halton_sequence refuses.
std::unique_ptr<Sequence> make_hammersley_sequence(std::uint64_t count, const std::vector<std::uint64_t>& bases);

/// One base per dimension: for four dimensions those of the paper's 4-D items, 2, 7, 3, 5; otherwise the first primes.
std::vector<std::uint64_t> default_bases(int dimensions);

} // namespace multipath

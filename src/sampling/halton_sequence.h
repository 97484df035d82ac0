#pragma once

#include "sampling/sequence.h"

namespace multipath {

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

#pragma once

#include "sampling/sequence.h"

namespace multipath {

/// How the points of Sobol's sequence are made random; every kind keeps the elementary intervals that they fill.
enum class SobolKind {
    plain,
    shift, ///< one random number per dimension is added digit by digit (exclusive or)
    owen, ///< every digit is flipped at random depending on all digits before it (nested uniform scrambling, Owen 1995)
};

/// At most six dimensions. Throws std::invalid_argument for more.
std::unique_ptr<Sequence> make_sobol_sequence(SobolKind kind, std::uint64_t seed, int dimensions);

} // namespace multipath

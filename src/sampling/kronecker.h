#pragma once

#include "sampling/sequence.h"

namespace multipath {

/// Kronecker sequence, an additive recurrence: each coordinate advances by a fixed irrational step, modulo 1. The steps
/// are powers of the inverse of a generalised golden ratio (M. Roberts, The unreasonable effectiveness of quasirandom
/// sequences, 2018). It starts at the centre of the cube, or, if `shifted`, at a random point. Throws
/// std::invalid_argument for more than six dimensions.
std::unique_ptr<Sequence> make_kronecker_sequence(bool shifted, std::uint64_t seed, int dimensions);

} // namespace multipath

#pragma once

#include "sampling/sequence.h"

namespace multipath {

/// Kronecker sequence, an additive recurrence: each coordinate advances by a fixed irrational step, modulo 1. The steps
/// are powers of the inverse of a generalised golden ratio (M. Roberts, The unreasonable effectiveness of quasirandom
/// sequences, 2018). The first point is the centre of the cube; if `shifted`, it is a random point that depends on the
/// seed. Throws std::invalid_argument for more than six dimensions.
std::unique_ptr<Sequence> make_kronecker_sequence(bool shifted, std::uint64_t seed, int dimensions);

} // namespace multipath

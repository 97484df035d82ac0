#pragma once

#include "sampling/sequence.h"

namespace multipath {

/// An additive recurrence, the lattice of rank 1 that can be extended at will: every coordinate moves on by a fixed
/// irrational step, modulo 1. The steps are powers of a generalised golden ratio (M. Roberts, The unreasonable
/// effectiveness of quasirandom sequences, 2018). It starts in the centre, or, shifted, at a random point. At most six
/// dimensions; throws std::invalid_argument for more.
std::unique_ptr<Sequence> make_kronecker_sequence(bool shifted, std::uint64_t seed, int dimensions);

} // namespace multipath

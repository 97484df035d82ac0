#pragma once

#include "sampling/sequence.h"

namespace multipath {

/// Kronecker sequence, an additive recurrence: each coordinate advances by a fixed irrational step, modulo 1. The steps
/// are powers of the inverse of a generalised golden ratio (M. Roberts, The unreasonable effectiveness of quasirandom
/// sequences, 2018). The first point is the centre of the cube, or that of the shift. Throws std::invalid_argument for
/// more than six dimensions.
std::unique_ptr<Sequence> make_kronecker_sequence(const SequenceRequest& request);

} // namespace multipath

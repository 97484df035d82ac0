#pragma once

#include "base/elementary.h"

#include <cmath>

namespace multipath {

/// Two parallel unit squares at distance 1 (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11, X
/// = Y = 1): F = (2 / pi) (ln(2 / sqrt 3) + 2 sqrt 2 atan(1 / sqrt 2) - pi / 2) = 0.199825; by symmetry and closure the
/// four others get (1 - F) / 4.
inline double opposite_form_factor()
{
    return 2.0 / pi *
           (std::log(2.0 / std::sqrt(3.0)) + 2.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) - pi / 2.0);
}

} // namespace multipath

#pragma once

#include "study/curve.h"

#include <optional>
#include <string>

namespace multipath {

/// A number with so many decimals, with a minus sign and not a hyphen.
std::string fixed(double value, int decimals);

/// "1.2·10⁻⁴"
std::string scientific(double value);

/// "−1.10 ± 0.02", with the half width of the 95 % interval; "none" without a law.
std::string slope_words(const std::optional<PowerLaw>& law);

} // namespace multipath

#pragma once

#include "scene/rgb.h"

#include <optional>
#include <vector>

namespace multipath {

/// What the results of a study are measured against.
struct Reference
{
    std::vector<Rgb> radiosity;            ///< [W/m^2] per patch
    std::optional<double> relative_square; ///< [1] its own relative MSE (1), as its standard errors let expect
};

} // namespace multipath

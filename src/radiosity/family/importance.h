#pragma once

#include <vector>

namespace multipath {

/// Importance of the patches (Smits, Arvo, Salesin: An importance-driven radiosity algorithm, 1992). The goal is a
/// small weighted square error: the sum of w_i A_i (error of B_i)^2 over all patches i, where w_i [1] is the weight of
/// patch i, A_i its area and B_i its radiosity ((I1) in docs/equations.md).
struct Importance
{
    std::vector<double> weight; ///< w_i [1] per patch, >= 0, not all 0
};

} // namespace multipath

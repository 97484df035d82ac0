#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// Importance of the patches (Smits, Arvo, Salesin: An importance-driven radiosity algorithm, 1992). The goal is a
/// small weighted square error: the sum of w_i A_i (error of B_i)^2 over all patches i, where w_i [1] is the weight of
/// patch i, A_i its area and B_i its radiosity ((I1) in docs/equations.md).
struct Importance
{
    std::vector<double> weight; ///< w_i [1] per patch, >= 0, not all 0

    double weighted_area(const Scene& scene) const; ///< [m^2] sum of w A

    /// MeanOverRays: the mean of value(receiver) over some rays from the patch. Rays that meet no patch count as 0.
    using Value = std::function<double(std::uint32_t receiver)>;
    using MeanOverRays = std::function<double(std::uint32_t patch, const Value& value)>;

    /// [1] Influence Z_i that a watt leaving patch i has on the important patches, for every i: the solution of Z_i =
    /// sum over j of F_ij (rho_j sqrt(w_j) + rho_j Z_j), truncated after a few reflections. `mean` estimates the sum.
    std::vector<double> influence(const Scene& scene, const MeanOverRays& mean, int threads) const;
};

} // namespace multipath

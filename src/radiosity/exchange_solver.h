#pragma once

#include "transport/exchange.h"

#include <vector>

namespace multipath {

/// The solution of B_i = S_i + rho_i / a_i sum over j of G_ij B_j (R1), with a the row areas of the exchange G.
struct ExchangeSolution
{
    std::vector<Rgb> radiosity; ///< B [W/m^2]
    bool converged = false; ///< otherwise the exchange is too noisy for a solution to exist, or the steps did not do
};

/// Conjugate gradients, all channels together, from the first guess on until what one more bounce would change is below
/// `tolerance` of what the source and its first bounce give, or for most_steps.
ExchangeSolution solve_exchange(const Exchange& exchange, const std::vector<Rgb>& reflectance,
                                const std::vector<Rgb>& source, std::vector<Rgb> first_guess, double tolerance,
                                int most_steps, int threads);

/// The same as closely as any number of lines is worth.
ExchangeSolution solve_exchange(const Exchange& exchange, const std::vector<Rgb>& reflectance,
                                const std::vector<Rgb>& source, std::vector<Rgb> first_guess, int threads);

} // namespace multipath

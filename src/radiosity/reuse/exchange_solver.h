#pragma once

#include "radiosity/power_state.h"
#include "scene/input_error.h"
#include "transport/exchange/exchange.h"

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

/// The one line for a solution of (R1) that does not exist, or that the steps did not reach.
InputError no_solution(const Scene& scene);

std::vector<Rgb> reflectances(const Scene& scene);

/// U / A per patch [W/m^2].
std::vector<Rgb> unshot_radiosity(const Scene& scene, const PowerState& state);

/// Moves the power that a solution of (R1) for the unshot radiosity says: all of `radiosity` leaves, and is received,
/// escapes, or meets backs. What the patches then hold beyond what they sent is unshot: what the solution lacks.
/// Several solutions are averaged by their shares, which must add up to 1.
void distribute(const Scene& scene, const Exchange& exchange, const std::vector<Rgb>& radiosity, double share,
                int threads, PowerState& state);

/// Removes negative irradiance, which the noise of (R1) leaves in dark places: takes the irradiance that is nowhere
/// negative, of which the patches absorb the same power, and that is nearest to the one found, by squares weighted with
/// area. As the projection onto a convex set it does not increase the squared error of the irradiance, if the power
/// absorbed is right.
void remove_negative_light(const Scene& scene, PowerState& state);

} // namespace multipath

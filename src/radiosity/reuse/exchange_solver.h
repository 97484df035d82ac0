#pragma once

#include "radiosity/power_state.h"
#include "scene/input_error.h"
#include "transport/exchange/exchange.h"

#include <vector>

namespace multipath {

/// Solution of B_i = S_i + rho_i / A^_i sum over j of G_ij B_j (R1), where A^_i are the row areas of the exchange G.
struct ExchangeSolution
{
    std::vector<Rgb> radiosity; ///< B [W/m^2]
    /// False if no solution exists since the exchange is too noisy, or if the steps did not suffice.
    bool converged = false;
};

/// Preconditioned conjugate gradients for all channels at once, from the first guess on. Ends when the preconditioned
/// norm of the residual is at most `tolerance` times that of the right-hand side, or after most_steps.
ExchangeSolution solve_exchange(const Exchange& exchange, const std::vector<Rgb>& reflectance,
                                const std::vector<Rgb>& source, std::vector<Rgb> first_guess, double tolerance,
                                int most_steps, int threads);

/// The same with a tolerance far below the noise of any practical number of lines.
ExchangeSolution solve_exchange(const Exchange& exchange, const std::vector<Rgb>& reflectance,
                                const std::vector<Rgb>& source, std::vector<Rgb> first_guess, int threads);

/// The error to throw if (R1) has no solution, or the steps did not suffice.
InputError no_solution(const Scene& scene);

std::vector<Rgb> reflectances(const Scene& scene);

/// Unshot power per area, U / A, of each patch [W/m^2].
std::vector<Rgb> unshot_radiosity(const Scene& scene, const PowerState& state);

/// Moves the power of a solution of (R1) for the unshot radiosity: every patch sends its `radiosity`, which is
/// received, escapes, or arrives behind a surface. The difference between what a patch should send and what it sent
/// stays unshot: the residual of the solution. Several solutions are averaged by their shares, which must add up to 1.
void distribute(const Scene& scene, const Exchange& exchange, const std::vector<Rgb>& radiosity, double share,
                int threads, PowerState& state);

/// Removes negative irradiance, which the noise of (R1) causes in dark places. Replaces the irradiance by the nearest
/// one, in least squares weighted by area, that is nowhere negative and of which the patches absorb the same power. If
/// the absorbed power is right, this projection onto a convex set does not increase the squared error of the
/// irradiance.
void remove_negative_light(const Scene& scene, PowerState& state);

} // namespace multipath

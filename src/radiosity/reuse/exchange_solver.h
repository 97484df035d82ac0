#pragma once

#include "radiosity/run/solution.h"
#include "transport/exchange/exchange.h"

#include <vector>

namespace multipath {

/// Solution of the linear system B_i = S_i + rho_i / A^_i sum over j of G_ij B_j ((R1) in docs/equations.md). G_ij are
/// the exchange areas (exchange.h), A^_i the row areas of the exchange, rho the reflectances, S the radiosities of the
/// sources.
struct ExchangeSolution
{
    std::vector<Rgb> radiosity; ///< [W/m^2] B, per patch
    /// False if the system turned out to have no sound solution, since the exchange is too noisy, or if the steps did
    /// not suffice; `radiosity` is then no solution.
    bool converged = false;
};

/// Solves the system by preconditioned conjugate gradients for all channels at once, from `first_guess` [W/m^2] on.
/// `source` is S [W/m^2]; all lists have one entry per patch. Ends when the preconditioned norm of the residual is at
/// most `tolerance` times that of the right-hand side in every channel, or after most_steps. The default tolerance is a
/// tenth of the noise of 10^9 lines.
ExchangeSolution solve_exchange(const Exchange& exchange, const std::vector<Rgb>& reflectance,
                                const std::vector<Rgb>& source, std::vector<Rgb> first_guess, int threads,
                                double tolerance = 1e-6, int most_steps = 500);

/// The error to throw if ExchangeSolution::converged is false.
NoSolution no_solution(const Scene& scene);

/// [1] Reflectance of every patch.
std::vector<Rgb> reflectances(const Scene& scene);

/// [W/m^2] Unshot power per area of every patch: PowerState::unshot / A.
std::vector<Rgb> unshot_radiosity(const Scene& scene, const PowerState& state);

/// Updates the state by a solution of the system whose sources S were the unshot radiosity: every patch sends the power
/// of its `radiosity` [W/m^2], which other patches receive, or which escapes or arrives behind a surface. The residual
/// of the solution, what a patch should have sent minus what it sent, stays unshot. The powers are multiplied by
/// `share` [1]: 1 for a single solution; to average several solutions, call it for each, with shares that add up to 1.
void distribute(const Scene& scene, const Exchange& exchange, const std::vector<Rgb>& radiosity, double share,
                int threads, PowerState& state);

/// Removes negative irradiance, which the noise of the exchange causes in dark places. Replaces the irradiance by the
/// nearest one, in least squares weighted by area, that is nowhere negative and of which the patches absorb the same
/// power as before. If this power is right, the projection onto a convex set does not increase the squared error of the
/// irradiance. A channel without negative irradiance does not change. Negative escaped power, or power behind surfaces,
/// is taken from the other of the two, and what is left from the power that the patches absorb.
void remove_negative_light(const Scene& scene, PowerState& state);

} // namespace multipath

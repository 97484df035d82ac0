// With y = sqrt(rho) H, where H is the irradiance, (R1) becomes symmetric:
//
//   A^_i y_i - sqrt(rho_i) sum over j of G_ij sqrt(rho_j) y_j = sqrt(rho_i) sum over j of G_ij S_j
//
// Black patches need no special case. If the rows add up to A^ and all reflectances are below 1, the matrix is positive
// definite, and conjugate gradients apply, here with the diagonal as preconditioner.

#include "radiosity/reuse/exchange_solver.h"

#include "base/memory.h"
#include "parallel/blocks.h"
#include "transport/exchange/conjugate_gradients.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace multipath {

namespace {

using Field = std::vector<Rgb>;

} // namespace

ExchangeSolution solve_exchange(const Exchange& exchange, const std::vector<Rgb>& reflectance,
                                const std::vector<Rgb>& source, std::vector<Rgb> first_guess, int threads,
                                double tolerance, int most_steps)
{
    const std::uint32_t n = exchange.size();
    Field rho_root = large_vector<Rgb>(n);
    Field inverse_diagonal = large_vector<Rgb>(n);
    bool positive = true;
    for (std::uint32_t i = 0; i < n; ++i) {
        rho_root[i] = square_root(reflectance[i]);
        const double area = exchange.row_area(i);
        const Rgb diagonal = Rgb{area, area, area} - exchange.self_exchange(i) * reflectance[i];
        positive = positive && at_most({}, diagonal);
        inverse_diagonal[i] = quotient({1.0, 1.0, 1.0}, diagonal);
    }
    Field reflected = large_vector<Rgb>(n);
    const auto matrix = [&](const Field& y, Field& image) {
        parallel_numbers(n, threads, [&](std::uint32_t i) { reflected[i] = rho_root[i] * y[i]; });
        exchange.multiply(reflected, threads, image);
        parallel_numbers(n, threads,
                         [&](std::uint32_t i) { image[i] = exchange.row_area(i) * y[i] - rho_root[i] * image[i]; });
    };
    const auto precondition = [&](std::size_t i, Rgb residual) { return inverse_diagonal[i] * residual; };

    Field residual = large_vector<Rgb>(n);
    exchange.multiply(source, threads, residual);
    const Rgb norm = parallel_sum<Rgb>(n, threads, [&](std::uint32_t i) {
        residual[i] = rho_root[i] * residual[i];
        return residual[i] * precondition(i, residual[i]);
    });
    const Rgb wanted = tolerance * tolerance * norm;
    Field y = std::move(first_guess);
    for (std::uint32_t i = 0; i < n; ++i)
        y[i] = quotient(y[i] - source[i], rho_root[i]);
    Field image = large_vector<Rgb>(n);
    matrix(y, image);
    for (std::uint32_t i = 0; i < n; ++i)
        residual[i] = residual[i] - image[i];
    Field().swap(image);
    const auto done = [&](const Field&, Rgb left) { return at_most(left, wanted); };
    ExchangeSolution solution;
    solution.converged =
        positive && conjugate_gradients(matrix, precondition, std::move(residual), most_steps, done, threads, y);
    for (std::uint32_t i = 0; i < n; ++i)
        y[i] = source[i] + rho_root[i] * y[i];
    solution.radiosity = std::move(y);
    return solution;
}

NoSolution no_solution(const Scene& scene)
{
    return NoSolution(scene.path() + ": the equations of line reuse do not converge with these lines; expected more");
}

std::vector<Rgb> reflectances(const Scene& scene)
{
    std::vector<Rgb> rho = large_vector<Rgb>(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        rho[i] = scene.reflectance(i);
    return rho;
}

std::vector<Rgb> unshot_radiosity(const Scene& scene, const PowerState& state)
{
    std::vector<Rgb> unshot = vector_with_capacity<Rgb>(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        unshot.push_back((1.0 / scene.area(i)) * state.unshot[i]);
    return unshot;
}

void distribute(const Scene& scene, const Exchange& exchange, const std::vector<Rgb>& radiosity, double share,
                int threads, PowerState& state)
{
    const std::vector<Rgb> received = exchange.apply(radiosity, threads);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double row = exchange.row_area(i);
        const double scale = row > 0.0 ? share * scene.area(i) / row : 0.0;
        const Rgb incident = scale * received[i];
        const Rgb escaped = (scale * exchange.escaping(i)) * radiosity[i];
        const Rgb behind = (scale * exchange.behind(i)) * radiosity[i];
        const Rgb sent = (share * scene.area(i)) * radiosity[i];
        state.incident[i] += incident;
        state.unshot[i] += scene.reflectance(i) * incident - sent;
        state.escaped += escaped;
        state.behind += behind;
        // Counted areas are right only on the average: the power received everywhere is not exactly the power sent.
        state.emitted += incident + escaped + behind - sent;
    }
}

namespace {

/// The same for the irradiance of one channel. With H' = max(0, H - mu (1 - rho)), the absorbed power is a decreasing,
/// convex and piecewise linear function of mu. So Newton's iteration from mu = 0 approaches the solution from below,
/// segment by segment.
void remove_negative_light(const Scene& scene, double Rgb::*channel, PowerState& state)
{
    const auto patches = scene.patch_count();
    // [W] Absorbed power. Patches have received what negative losses lack.
    double wanted = std::min(0.0, state.escaped.*channel + state.behind.*channel);
    bool any = wanted < 0.0;
    for (std::uint32_t i = 0; i < patches; ++i) {
        wanted += (1.0 - scene.reflectance(i).*channel) * state.incident[i].*channel;
        any = any || state.incident[i].*channel < 0.0;
    }
    if (!any)
        return;
    double mu = 0.0; // [W/m^2]
    constexpr int most_steps = 100;
    for (int step = 0; step < most_steps; ++step) {
        double absorbed = 0.0;
        double slope = 0.0;
        for (std::uint32_t i = 0; i < patches; ++i) {
            const double absorption = 1.0 - scene.reflectance(i).*channel;
            const double left = state.incident[i].*channel - mu * absorption * scene.area(i);
            if (left > 0.0) {
                absorbed += absorption * left;
                slope += absorption * absorption * scene.area(i);
            }
        }
        const double excess = absorbed - wanted;
        if (!(excess > 1e-15 * absorbed) || !(slope > 0.0))
            break;
        mu += excess / slope;
    }
    for (std::uint32_t i = 0; i < patches; ++i) {
        double& incident = state.incident[i].*channel;
        incident = std::max(0.0, incident - mu * (1.0 - scene.reflectance(i).*channel) * scene.area(i));
    }
}

} // namespace

void remove_negative_light(const Scene& scene, PowerState& state)
{
    for (double Rgb::*channel : {&Rgb::r, &Rgb::g, &Rgb::b}) {
        remove_negative_light(scene, channel, state);
        double& escaped = state.escaped.*channel;
        double& behind = state.behind.*channel;
        if (escaped >= 0.0 && behind >= 0.0)
            continue;
        const double lost = std::max(0.0, escaped + behind);
        behind = escaped < 0.0 ? lost : 0.0;
        escaped = lost - behind;
    }
}

} // namespace multipath

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
#include <utility>

namespace multipath {

ExchangeSolution solve_exchange(const Exchange& exchange, const std::vector<Rgb>& reflectance,
                                const std::vector<Rgb>& source, std::vector<Rgb> first_guess, int threads,
                                double tolerance, int most_steps)
{
    using Vector = std::vector<Rgb>;
    const std::uint32_t n = exchange.size();
    Vector rho_root = large_vector<Rgb>(n);
    Vector inverse_diagonal = large_vector<Rgb>(n);
    bool positive = true;
    for (std::uint32_t i = 0; i < n; ++i) {
        rho_root[i] = square_root(reflectance[i]);
        const double area = exchange.row_area(i);
        const Rgb diagonal = Rgb{area, area, area} - exchange.self_exchange(i) * reflectance[i];
        positive = positive && at_most({}, diagonal);
        inverse_diagonal[i] = quotient({1.0, 1.0, 1.0}, diagonal);
    }
    const auto matrix = [&](const Vector& y) {
        const auto reflected = [&](std::uint32_t i) { return rho_root[i] * y[i]; };
        Vector image = exchange.apply(parallel_list(n, threads, reflected), threads);
        parallel_numbers(n, threads,
                         [&](std::uint32_t i) { image[i] = exchange.row_area(i) * y[i] - rho_root[i] * image[i]; });
        return image;
    };
    const auto precondition = [&](std::size_t i, Rgb residual) { return inverse_diagonal[i] * residual; };

    Vector residual = exchange.apply(source, threads);
    const Rgb norm = parallel_sum<Rgb>(n, threads, [&](std::uint32_t i) {
        residual[i] = rho_root[i] * residual[i];
        return residual[i] * precondition(i, residual[i]);
    });
    const Rgb wanted = tolerance * tolerance * norm;
    Vector y = std::move(first_guess);
    for (std::uint32_t i = 0; i < n; ++i)
        y[i] = quotient(y[i] - source[i], rho_root[i]);
    Vector image = matrix(y);
    for (std::uint32_t i = 0; i < n; ++i)
        residual[i] = residual[i] - image[i];
    Vector().swap(image); // frees its memory
    const auto done = [&](const Vector&, Rgb left) { return at_most(left, wanted); };
    const bool converged =
        positive && conjugate_gradients(matrix, precondition, std::move(residual), most_steps, done, threads, y);
    for (std::uint32_t i = 0; i < n; ++i)
        y[i] = source[i] + rho_root[i] * y[i];
    return {std::move(y), converged};
}

NoSolution no_solution(const Scene& scene)
{
    return NoSolution(scene.path() + ": the equations of line reuse do not converge with these lines; expected more");
}

std::vector<Rgb> reflectances(const Scene& scene)
{
    return parallel_list(scene.patch_count(), 1, [&](std::uint32_t i) { return scene.reflectance(i); });
}

std::vector<Rgb> unshot_radiosity(const Scene& scene, const PowerState& state)
{
    const auto per_area = [&](std::uint32_t i) { return (1.0 / scene.area(i)) * state.unshot[i]; };
    return parallel_list(scene.patch_count(), 1, per_area);
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

void remove_negative_light(const Scene& scene, PowerState& state)
{
    // With H' = max(0, H - mu (1 - rho)), the absorbed power of a channel is a decreasing, convex and piecewise linear
    // function of mu. So Newton's iteration from mu = 0 approaches the solution from below, segment by segment.
    const auto absorption = [&](std::uint32_t i) { return Rgb{1.0, 1.0, 1.0} - scene.reflectance(i); };
    const auto lower = [](double x, double y) { return std::min(x, y); };
    // [W] Absorbed power. Patches have received what negative losses lack.
    Rgb wanted = by_channel(lower, Rgb{}, state.escaped + state.behind);
    Rgb least = wanted;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        wanted += absorption(i) * state.incident[i];
        least = by_channel(lower, least, state.incident[i]);
    }
    Rgb mu; // [W/m^2]
    const auto incident = [&](std::uint32_t i) {
        const auto positive = [](double before, double less, double of_channel) {
            return of_channel < 0.0 ? std::max(0.0, before - less) : before;
        };
        return by_channel(positive, state.incident[i], scene.area(i) * (mu * absorption(i)), least);
    };
    const auto newton_step = [](double absorbed, double power, double slope, double of_channel) {
        return of_channel < 0.0 && absorbed - power > 1e-15 * absorbed && slope > 0.0 ? (absorbed - power) / slope
                                                                                      : 0.0;
    };
    constexpr int most_steps = 100;
    Rgb change = least;
    for (int step = 0; step < most_steps && change != Rgb{}; ++step) {
        Rgb absorbed;
        Rgb slope;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const Rgb left = incident(i);
            absorbed += absorption(i) * left;
            slope += by_channel([](double x, double y) { return x > 0.0 ? y : 0.0; }, left,
                                scene.area(i) * (absorption(i) * absorption(i)));
        }
        change = by_channel(newton_step, absorbed, wanted, slope, least);
        mu += change;
    }
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        state.incident[i] = incident(i);
    const auto without_negative = [](double own, double other) {
        return own < 0.0 ? 0.0 : other < 0.0 ? std::max(0.0, own + other) : own;
    };
    const Rgb escaped = by_channel(without_negative, state.escaped, state.behind);
    state.behind = by_channel(without_negative, state.behind, state.escaped);
    state.escaped = escaped;
}

} // namespace multipath

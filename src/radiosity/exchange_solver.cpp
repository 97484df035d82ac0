// With y = sqrt(rho) H, H the irradiance, (R1) becomes symmetric:
//
//   a_i y_i - sqrt(rho_i) sum over j of G_ij sqrt(rho_j) y_j = sqrt(rho_i) sum over j of G_ij S_j
//
// and black patches are no exception. With rows that add up to a and reflectances below 1 the matrix is positive
// definite.

#include "radiosity/exchange_solver.h"

#include <array>
#include <cmath>
#include <utility>

namespace multipath {

namespace {

using Field = std::vector<Rgb>;

Rgb root(Rgb a)
{
    return {std::sqrt(a.r), std::sqrt(a.g), std::sqrt(a.b)};
}

Rgb quotient(Rgb a, Rgb b)
{
    const auto divide = [](double x, double y) { return y != 0.0 ? x / y : 0.0; };
    return {divide(a.r, b.r), divide(a.g, b.g), divide(a.b, b.b)};
}

/// One dot product for each channel.
Rgb dot(const Field& a, const Field& b)
{
    Rgb sum;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

Field scaled(const Field& factor, const Field& x)
{
    Field y(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        y[i] = factor[i] * x[i];
    return y;
}

void add_scaled(Field& x, Rgb factor, const Field& y)
{
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] += factor * y[i];
}

bool all_below(Rgb a, Rgb b)
{
    return a.r <= b.r && a.g <= b.g && a.b <= b.b;
}

} // namespace

ExchangeSolution solve_exchange(const Exchange& exchange, const std::vector<Rgb>& reflectance,
                                const std::vector<Rgb>& source, std::vector<Rgb> first_guess, double tolerance,
                                int most_steps, int threads)
{
    const std::uint32_t n = exchange.size();
    Field rho_root(n);
    Field inverse_diagonal(n);
    bool positive = true;
    for (std::uint32_t i = 0; i < n; ++i) {
        rho_root[i] = root(reflectance[i]);
        const double area = exchange.row_area(i);
        const Rgb diagonal = Rgb{area, area, area} - exchange.self_exchange(i) * reflectance[i];
        positive = positive && all_below({}, diagonal);
        inverse_diagonal[i] = quotient({1.0, 1.0, 1.0}, diagonal);
    }
    const auto bounce = [&](const Field& radiosity) { return scaled(rho_root, exchange.apply(radiosity, threads)); };
    const auto residual_for = [&](const Field& y, const Field& right) {
        Field residual = right;
        const Field reflected = bounce(scaled(rho_root, y));
        for (std::uint32_t i = 0; i < n; ++i)
            residual[i] = right[i] - exchange.row_area(i) * y[i] + reflected[i];
        return residual;
    };

    const Field right = bounce(source);
    const Rgb wanted = tolerance * tolerance * dot(right, scaled(inverse_diagonal, right));
    Field y(n);
    for (std::uint32_t i = 0; i < n; ++i)
        y[i] = quotient(first_guess[i] - source[i], rho_root[i]);
    Field residual = residual_for(y, right);
    Field preconditioned = scaled(inverse_diagonal, residual);
    Field direction = preconditioned;
    Rgb norm = dot(residual, preconditioned);
    for (int step = 0; step < most_steps && positive && !all_below(norm, wanted); ++step) {
        Field image = bounce(scaled(rho_root, direction));
        for (std::uint32_t i = 0; i < n; ++i)
            image[i] = exchange.row_area(i) * direction[i] - image[i];
        const Rgb curvature = dot(direction, image);
        positive = all_below({}, curvature);
        const Rgb length = quotient(norm, curvature);
        add_scaled(y, length, direction);
        add_scaled(residual, -1.0 * length, image);
        preconditioned = scaled(inverse_diagonal, residual);
        const Rgb next = dot(residual, preconditioned);
        const Rgb turn = quotient(next, norm);
        for (std::uint32_t i = 0; i < n; ++i)
            direction[i] = preconditioned[i] + turn * direction[i];
        norm = next;
    }
    ExchangeSolution solution{source, positive && all_below(norm, wanted)};
    for (std::uint32_t i = 0; i < n; ++i)
        solution.radiosity[i] += rho_root[i] * y[i];
    return solution;
}

ExchangeSolution solve_exchange(const Exchange& exchange, const std::vector<Rgb>& reflectance,
                                const std::vector<Rgb>& source, std::vector<Rgb> first_guess, int threads)
{
    constexpr double tolerance = 1e-6; // a tenth of the noise of 10^9 lines
    constexpr int most_steps = 500;
    return solve_exchange(exchange, reflectance, source, std::move(first_guess), tolerance, most_steps, threads);
}

} // namespace multipath

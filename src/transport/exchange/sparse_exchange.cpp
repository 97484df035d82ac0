#include "transport/exchange/sparse_exchange.h"

#include "parallel/blocks.h"
#include "parallel/memory.h"

#include <algorithm>
#include <cmath>

namespace multipath {

SparseExchange::SparseExchange(const LineCounts& counts, const std::vector<double>& area,
                               const std::vector<double>& density, double unseen_rays, int threads)
    : counts_(counts),
      area_(area),
      factors_(vector_with_capacity<Factors>(area.size())),
      own_(large_vector<double>(area.size())),
      unseen_(large_vector<double>(area.size()))
{
    for (const double a : area)
        unit_ += a;
    for (const double d : density)
        factors_.push_back({static_cast<float>(d * unit_), 1.0f});
    std::vector<double> wanted = area; // row sums of step 1: the areas without the share of unseen rays
    if (unseen_rays > 0.0)
        for (std::uint32_t i = 0; i < size(); ++i) {
            const CountRow row = counts_.row(i);
            const auto rays =
                static_cast<double>(row.last - row.first) + static_cast<double>(counts_.escaped(i) + counts_.behind(i));
            wanted[i] *= rays / (rays + unseen_rays);
        }
    balance(wanted, threads);
    unseen_sum_ = parallel_sum<double>(size(), threads, [&](std::uint32_t i) {
        constexpr double rounding = 1e-6;
        const double lacks = area_[i] - row_sum(i);
        (lacks <= rounding * area_[i] ? own_ : unseen_)[i] = lacks;
        return unseen_[i];
    });
}

/// [m^2] Exchange area of a patch for rays that reached no patch.
double SparseExchange::lost(std::uint32_t patch, std::uint64_t rays) const
{
    const Factors& f = factors_[patch];
    return rays == 0
               ? 0.0
               : unit_ * static_cast<double>(rays) * static_cast<double>(f.scale) / static_cast<double>(f.density);
}

/// [m^2] Sum of row i after step 1, its losses included.
double SparseExchange::row_sum(std::uint32_t i) const
{
    const auto density = static_cast<double>(factors_[i].density);
    double sum = 0.0;
    for (const std::uint32_t j : counts_.row(i)) {
        const Factors& other = factors_[j];
        sum += static_cast<double>(other.scale) / (density + static_cast<double>(other.density));
    }
    const std::uint64_t escaped = counts_.escaped(i) + counts_.behind(i);
    return unit_ * static_cast<double>(factors_[i].scale) * sum + lost(i, escaped);
}

/// Step 1: finds the factors x for which the row sums are `wanted` [m^2].
void SparseExchange::balance(const std::vector<double>& wanted, int threads)
{
    // Each step multiplies x_i by (wanted / sum)^(3/4) and by the previous change of x_i to the power of 1/16, the
    // momentum of Polyak's heavy ball (1964). The power 1/2 alone would converge for certain. Where the
    // pairs of a row are spread over the scene, as those of rays are, each step divides the errors by about 4. Errors
    // that remain make closed spaces leak, and bright surfaces multiply the leak. Groups of patches that exchange with
    // each other only, like two that face each other, hardly converge.
    constexpr int most_steps = 16;
    constexpr double small_leak = 2e-7; // [1] share of the area
    const auto root = [](double x) { return std::sqrt(x); };
    std::vector<float> next = large_vector<float>(size());
    std::vector<float> before = large_vector<float>(size());
    std::fill(before.begin(), before.end(), 1.0f);
    const double all = parallel_sum<double>(size(), threads, [&](std::uint32_t i) { return wanted[i]; });
    double leak = 1.0;
    for (int step = 0; step < most_steps && leak > small_leak; ++step) {
        const double missing = parallel_sum<double>(size(), threads, [&](std::uint32_t i) {
            const double sum = row_sum(i);
            const auto scale = static_cast<double>(factors_[i].scale);
            const double momentum = root(root(root(root(scale / static_cast<double>(before[i])))));
            const double change = sum > 0.0 ? root(wanted[i] / sum) * root(root(wanted[i] / sum)) * momentum : 1.0;
            next[i] = static_cast<float>(scale * change);
            return std::abs(wanted[i] - sum);
        });
        leak = all > 0.0 ? missing / all : 0.0;
        parallel_numbers(size(), threads, [&](std::uint32_t i) {
            before[i] = factors_[i].scale;
            factors_[i].scale = next[i];
        });
    }
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const double sum = row_sum(i);
        constexpr double below_one = 1.0 - 1.5e-7; // keeps the sum below `wanted` after rounding to float
        const double limit = std::min(1.0, below_one * wanted[i] / sum);
        next[i] = sum > 0.0 ? static_cast<float>(static_cast<double>(factors_[i].scale) * limit) : 1.0f;
    });
    parallel_numbers(size(), threads, [&](std::uint32_t i) { factors_[i].scale = next[i]; });
}

void SparseExchange::multiply(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const
{
    // Scale the light by a power of two, which is exact, into the range of single precision.
    const double sum_of_all = parallel_sum<double>(
        size(), threads, [&](std::uint32_t i) { return std::abs(x[i].r) + std::abs(x[i].g) + std::abs(x[i].b); });
    int exponent = 0;
    std::frexp(sum_of_all, &exponent);
    const double unit_of_light = std::ldexp(1.0, exponent);
    const double to_single = std::ldexp(1.0, -exponent);
    struct Sender // small, since it is read at random indices
    {
        float r, g, b; ///< scaled light
        float density;
    };
    std::vector<Sender> senders = large_vector<Sender>(size());
    Rgb spread = parallel_sum<Rgb>(size(), threads, [&](std::uint32_t i) { // [W]
        const Rgb light = to_single * static_cast<double>(factors_[i].scale) * x[i];
        senders[i] = {static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b),
                      factors_[i].density};
        return unseen_[i] * x[i];
    });
    if (unseen_sum_ > 0.0)
        spread = (1.0 / unseen_sum_) * spread; // [W/m^2] of unseen area
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const auto density = static_cast<double>(factors_[i].density);
        Rgb sum;
        for (const std::uint32_t j : counts_.row(i)) {
            const Sender& sender = senders[j];
            sum += (1.0 / (density + static_cast<double>(sender.density))) *
                   Rgb{static_cast<double>(sender.r), static_cast<double>(sender.g), static_cast<double>(sender.b)};
        }
        y[i] =
            unit_of_light * unit_ * static_cast<double>(factors_[i].scale) * sum + own_[i] * x[i] + unseen_[i] * spread;
    });
}

double SparseExchange::self_exchange(std::uint32_t patch) const
{
    return own_[patch] + (unseen_sum_ > 0.0 ? unseen_[patch] * unseen_[patch] / unseen_sum_ : 0.0);
}

double SparseExchange::unseen_share() const
{
    double area = 0.0;
    for (const double a : area_)
        area += a;
    return area > 0.0 ? unseen_sum_ / area : 0.0;
}

} // namespace multipath

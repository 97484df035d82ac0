#include "transport/exchange/sparse_exchange.h"

#include "parallel/blocks.h"
#include "parallel/memory.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr double rounding_of_rows = 1e-6; // of the area of a patch

} // namespace

SparseExchange::SparseExchange(const LineCounts& counts, const std::vector<double>& area,
                               const std::vector<double>& density, std::vector<std::uint32_t> sky, double unseen_rays,
                               int threads)
    : counts_(counts),
      area_(area),
      factors_(vector_with_capacity<Factors>(area.size())),
      sky_(std::move(sky)),
      ray_area_(large_vector<double>(area.size())),
      own_(large_vector<double>(area.size())),
      unseen_(large_vector<double>(area.size()))
{
    for (const double a : area)
        unit_ += a;
    for (const double d : density)
        factors_.push_back({static_cast<float>(d * unit_), 1.0f});
    std::vector<double> wanted = large_vector<double>(size()); // [m^2] of rays that join patches
    for (std::uint32_t i = 0; i < size(); ++i) {
        const std::uint64_t lost_rays = counts_.escaped(i) + counts_.behind(i);
        const CountRow row = counts_.row(i);
        const auto rays = static_cast<double>(row.last - row.first) + static_cast<double>(lost_rays);
        ray_area_[i] = quotient(1.0, density[i]);
        const double left = area[i] - lost(i, lost_rays);
        wanted[i] = left > rounding_of_rows * area[i] ? left * quotient(rays, rays + unseen_rays) : 0.0;
    }
    for (const std::uint32_t s : sky_) {
        wanted[s] = 0.0;
        sky_area_ += area[s];
    }
    balance(wanted, threads);
    unseen_sum_ = parallel_sum<double>(size(), threads, [&](std::uint32_t i) {
        const std::uint64_t lost_rays = counts_.escaped(i) + counts_.behind(i);
        const double lacks = area_[i] - joined(i) - lost(i, lost_rays);
        if (lacks <= rounding_of_rows * area_[i] || density[i] == 0.0) {
            own_[i] = lacks;
            return 0.0;
        }
        const double rays = density[i] * area[i];
        unseen_[i] = lacks * (1.0 - static_cast<double>(lost_rays) / rays);
        ray_area_[i] += lacks / rays;
        return unseen_[i];
    });
    const double open_area = parallel_sum<double>(size(), threads, [&](std::uint32_t i) { return open(i); });
    for (const std::uint32_t s : sky_)
        own_[s] = area_[s] * (1.0 - open_area / sky_area_);
}

/// [m^2] Exchange area of a patch for rays that reached no patch.
double SparseExchange::lost(std::uint32_t patch, std::uint64_t rays) const
{
    return static_cast<double>(rays) * ray_area_[patch];
}

/// [m^2] Exchange area of patch i with all patches after step 1.
double SparseExchange::joined(std::uint32_t i) const
{
    const auto density = static_cast<double>(factors_[i].density);
    double sum = 0.0;
    for (const std::uint32_t j : counts_.row(i)) {
        const Factors& other = factors_[j];
        sum += static_cast<double>(other.scale) / (density + static_cast<double>(other.density));
    }
    return unit_ * static_cast<double>(factors_[i].scale) * sum;
}

/// Step 1: finds the factors x for which each patch has the exchange area `wanted` [m^2] with all patches.
void SparseExchange::balance(const std::vector<double>& wanted, int threads)
{
    // Each step multiplies x_i by (wanted / sum)^(3/4) and by the previous change of x_i to the power of 1/16, the
    // momentum of Polyak's heavy ball (1964). The power 1/2 alone would converge for certain. Where the
    // pairs of a row are spread over the scene, as those of rays are, each step divides the errors by about 4. Errors
    // that remain make closed spaces leak, and bright surfaces multiply the leak. Groups of patches that exchange with
    // each other only, like two that face each other, hardly converge.
    constexpr int most_steps = 16;
    constexpr double small_leak = 2e-7;   // [1] share of the area
    constexpr double most_scale = 1024.0; // where no factors exist, they would leave the range of single precision
    const auto root = [](double x) { return std::sqrt(x); };
    std::vector<float> next = large_vector<float>(size());
    std::vector<float> before = large_vector<float>(size());
    std::fill(before.begin(), before.end(), 1.0f);
    const double all = parallel_sum<double>(size(), threads, [&](std::uint32_t i) { return wanted[i]; });
    double leak = 1.0;
    for (int step = 0; step < most_steps && leak > small_leak; ++step) {
        const double missing = parallel_sum<double>(size(), threads, [&](std::uint32_t i) {
            const double sum = joined(i);
            const auto scale = static_cast<double>(factors_[i].scale);
            const double momentum = root(root(root(root(scale / static_cast<double>(before[i])))));
            const double change = sum > 0.0 ? root(wanted[i] / sum) * root(root(wanted[i] / sum)) * momentum : 1.0;
            next[i] =
                wanted[i] > 0.0 ? static_cast<float>(std::clamp(scale * change, 1.0 / most_scale, most_scale)) : 0.0f;
            return std::abs(wanted[i] - sum);
        });
        leak = all > 0.0 ? missing / all : 0.0;
        parallel_numbers(size(), threads, [&](std::uint32_t i) {
            before[i] = factors_[i].scale;
            factors_[i].scale = next[i];
        });
    }
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const double sum = joined(i);
        constexpr double below_one = 1.0 - 1.5e-7; // keeps the sum below `wanted` after rounding to float
        const double limit = sum > 0.0 ? std::min(1.0, below_one * wanted[i] / sum) : 1.0;
        next[i] = static_cast<float>(static_cast<double>(factors_[i].scale) * limit);
    });
    parallel_numbers(size(), threads, [&](std::uint32_t i) { factors_[i].scale = next[i]; });
}

/// [W/m^2] Mean of x over the sky.
Rgb SparseExchange::light_of_sky(const std::vector<Rgb>& x) const
{
    Rgb sum;
    for (const std::uint32_t s : sky_)
        sum += area_[s] * x[s];
    return quotient(1.0, sky_area_) * sum;
}

/// Adds light [W] that escapes to the patches of the sky.
void SparseExchange::give_to_sky(Rgb light, std::vector<Rgb>& y) const
{
    for (const std::uint32_t s : sky_)
        y[s] += (area_[s] / sky_area_) * light;
}

/// The exchange by the rays that join patches, after step 1.
void SparseExchange::multiply_rays(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const
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
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const Rgb light = to_single * static_cast<double>(factors_[i].scale) * x[i];
        senders[i] = {static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b),
                      factors_[i].density};
    });
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const auto density = static_cast<double>(factors_[i].density);
        Rgb sum;
        for (const std::uint32_t j : counts_.row(i)) {
            const Sender& sender = senders[j];
            sum += (1.0 / (density + static_cast<double>(sender.density))) *
                   Rgb{static_cast<double>(sender.r), static_cast<double>(sender.g), static_cast<double>(sender.b)};
        }
        y[i] = unit_of_light * unit_ * static_cast<double>(factors_[i].scale) * sum;
    });
}

void SparseExchange::multiply(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const
{
    multiply_rays(x, threads, y);
    const Rgb sky = light_of_sky(x);
    Rgb spread = parallel_sum<Rgb>(size(), threads, [&](std::uint32_t i) { return unseen_[i] * x[i]; }); // [W]
    if (unseen_sum_ > 0.0)
        spread = (1.0 / unseen_sum_) * spread; // [W/m^2] of unseen area
    const Rgb escaped = parallel_sum<Rgb>(size(), threads, [&](std::uint32_t i) {
        y[i] += own_[i] * x[i] + unseen_[i] * spread + open(i) * sky;
        return open(i) * x[i];
    });
    give_to_sky(escaped, y);
}

SparseExchange::Returns SparseExchange::returns(const std::vector<Rgb>& radiosity, const std::vector<Rgb>& reflectance,
                                                int threads) const
{
    const Rgb sky = light_of_sky(radiosity);
    Returns result{large_vector<Rgb>(size()), {}, {}};
    std::vector<Rgb> arriving = large_vector<Rgb>(size()); // [W]
    multiply_rays(radiosity, threads, arriving);
    std::vector<Rgb> weight = large_vector<Rgb>(size()); // rho / (n - 1)
    std::vector<Rgb> excess = large_vector<Rgb>(size()); // rho H / (n - 1)
    struct Open
    {
        Rgb escaped, behind;
        Open& operator+=(const Open& other)
        {
            escaped += other.escaped;
            behind += other.behind;
            return *this;
        }
    };
    const Open lost_light = parallel_sum<Open>(size(), threads, [&](std::uint32_t i) -> Open {
        const auto density = static_cast<double>(factors_[i].density);
        const double back = behind(i);
        const auto lost_rays = static_cast<double>(counts_.escaped(i) + counts_.behind(i));
        double area = open(i) + back; // of all rays
        double squares = lost_rays * ray_area_[i] * ray_area_[i];
        for (const std::uint32_t j : counts_.row(i)) {
            const Factors& other = factors_[j];
            const double ray = unit_ * static_cast<double>(factors_[i].scale) * static_cast<double>(other.scale) /
                               (density + static_cast<double>(other.density));
            area += ray;
            squares += ray * ray;
        }
        if (!(area > 0.0))
            return {};
        constexpr double most = 0.5; // of 1 / (n - 1): a patch of one or two rays has no other ones
        weight[i] = std::min(most, quotient(squares, area * area - squares)) * reflectance[i];
        const Rgb irradiance = (1.0 / area) * (arriving[i] + open(i) * sky);
        excess[i] = weight[i] * irradiance;
        return {open(i) * (excess[i] - weight[i] * sky), back * excess[i]};
    });
    std::vector<Rgb> weights_around = large_vector<Rgb>(size());
    multiply_rays(weight, threads, weights_around);
    multiply_rays(excess, threads, result.incident);
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        result.incident[i] = result.incident[i] - weights_around[i] * radiosity[i];
    });
    give_to_sky(lost_light.escaped, result.incident);
    result.escaped = sky_.empty() ? lost_light.escaped : Rgb{};
    result.behind = lost_light.behind;
    return result;
}

double SparseExchange::lost_area() const
{
    double area = 0.0;
    for (std::uint32_t i = 0; i < size(); ++i)
        area += open(i) + behind(i);
    return area;
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

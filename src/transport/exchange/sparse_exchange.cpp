#include "transport/exchange/sparse_exchange.h"

#include "parallel/blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace multipath {

namespace {

/// Runs work(patch) for all patches, in no particular order.
template <class Work>
void for_all_patches(std::uint32_t patches, int threads, const Work& work)
{
    constexpr std::uint32_t patches_at_a_time = 1024;
    parallel_ranges(patches, patches_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i)
            work(i);
    });
}

} // namespace

SparseExchange::SparseExchange(const LineCounts& counts, const std::vector<double>& area, std::vector<double> density,
                               double unseen_rays, int threads, double small_leak)
    : counts_(counts),
      area_(area),
      density_(std::move(density)),
      scale_(area.size(), 1.0),
      limit_(area.size(), 1.0),
      unseen_(area)
{
    std::vector<double> wanted = area; // by the rays that were counted
    std::vector<double> sums = row_sums(false, threads);
    for (std::uint32_t i = 0; i < size(); ++i) {
        const double rays = sums[i] * density_[i];
        wanted[i] *= unseen_rays > 0.0 ? rays / (rays + unseen_rays) : 1.0;
    }
    // With the root, noise is halved by each step; with a power of 5/8 it becomes 3/8, and what all rows have in common
    // a quarter. What is left leaks out of closed spaces, where bright surfaces multiply it; groups of patches that
    // exchange with each other alone, like two that face each other, never converge.
    constexpr int most_steps = 32;
    const auto power = [](double x) { return std::sqrt(x) * std::sqrt(std::sqrt(std::sqrt(x))); };
    double leak = 1.0; // [1] share of the area
    for (int step = 0; step < most_steps && leak > small_leak; ++step) {
        double missing = 0.0;
        double all = 0.0;
        for (std::uint32_t i = 0; i < size(); ++i) {
            all += wanted[i];
            missing += std::abs(wanted[i] - sums[i]);
            if (sums[i] > 0.0)
                scale_[i] *= power(wanted[i] / sums[i]);
        }
        leak = all > 0.0 ? missing / all : 0.0;
        sums = row_sums(false, threads);
    }
    for (std::uint32_t i = 0; i < size(); ++i)
        limit_[i] = sums[i] > wanted[i] ? wanted[i] / sums[i] : 1.0;
    sums = row_sums(true, threads);
    for (std::uint32_t i = 0; i < size(); ++i) {
        unseen_[i] = std::max(0.0, area_[i] - sums[i]);
        unseen_sum_ += unseen_[i];
    }
}

std::vector<double> SparseExchange::row_sums(bool limited, int threads) const
{
    std::vector<double> sums(size());
    for_all_patches(size(), threads, [&](std::uint32_t i) {
        double sum = lost(i, counts_.escaped(i) + counts_.behind(i));
        for (const CountEntry& entry : counts_.row(i))
            sum += counted(i, entry) * (limited ? factor(i, entry.patch) : scale_[i] * scale_[entry.patch]);
        sums[i] = sum;
    });
    return sums;
}

double SparseExchange::counted(std::uint32_t i, const CountEntry& entry) const
{
    return static_cast<double>(entry.count) / (density_[i] + density_[entry.patch]);
}

double SparseExchange::factor(std::uint32_t i, std::uint32_t j) const
{
    return scale_[i] * scale_[j] * std::min(limit_[i], limit_[j]);
}

std::vector<Rgb> SparseExchange::apply(const std::vector<Rgb>& x, int threads) const
{
    Rgb spread; // [W] for each m^2 that is not seen
    for (std::uint32_t i = 0; i < size(); ++i)
        spread += unseen_[i] * x[i];
    if (unseen_sum_ > 0.0)
        spread = (1.0 / unseen_sum_) * spread;
    std::vector<Rgb> y(size());
    for_all_patches(size(), threads, [&](std::uint32_t i) {
        Rgb sum;
        for (const CountEntry& entry : counts_.row(i))
            sum += (counted(i, entry) * factor(i, entry.patch)) * x[entry.patch];
        y[i] = sum + unseen_[i] * spread;
    });
    return y;
}

double SparseExchange::self_exchange(std::uint32_t patch) const
{
    return unseen_sum_ > 0.0 ? unseen_[patch] * unseen_[patch] / unseen_sum_ : 0.0;
}

double SparseExchange::lost(std::uint32_t patch, std::uint64_t rays) const
{
    return rays == 0 ? 0.0 : static_cast<double>(rays) / density_[patch] * scale_[patch] * limit_[patch];
}

double SparseExchange::escaping(std::uint32_t patch) const
{
    return lost(patch, counts_.escaped(patch));
}

double SparseExchange::behind(std::uint32_t patch) const
{
    return lost(patch, counts_.behind(patch));
}

double SparseExchange::unseen_share() const
{
    double area = 0.0;
    for (const double a : area_)
        area += a;
    return area > 0.0 ? unseen_sum_ / area : 0.0;
}

} // namespace multipath

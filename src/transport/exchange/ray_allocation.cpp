#include "transport/exchange/ray_allocation.h"

#include "parallel/blocks.h"
#include "sampling/random.h"
#include "sampling/systematic_rounding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numeric>

namespace multipath {

namespace {

constexpr int depths_per_octave_bits = 4;

/// Depths are told apart by the leading bits of a float: exponent and first part of the fraction.
std::size_t depth_class(double depth)
{
    const auto single = static_cast<float>(depth);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &single, sizeof bits);
    return bits >> (23 - depths_per_octave_bits);
}

double least_depth(std::size_t depth_class)
{
    const auto bits = static_cast<std::uint32_t>(depth_class << (23 - depths_per_octave_bits));
    float depth = 0.0f;
    std::memcpy(&depth, &bits, sizeof depth);
    return static_cast<double>(depth);
}

} // namespace

FillLevel::FillLevel() : by_depth_(std::size_t{1} << (8 + depths_per_octave_bits)) {}

void FillLevel::add(double importance, double lines)
{
    Vessels& vessels = by_depth_[depth_class(lines / importance)];
    vessels.importance += importance;
    vessels.lines += lines;
}

void FillLevel::add(const FillLevel& others)
{
    for (std::size_t k = 0; k < by_depth_.size(); ++k) {
        by_depth_[k].importance += others.by_depth_[k].importance;
        by_depth_[k].lines += others.by_depth_[k].lines;
    }
}

double FillLevel::level(double rays) const
{
    double importance = 0.0; // of the vessels that are reached
    double lines = 0.0;
    double level = 0.0;
    for (std::size_t k = 0; k < by_depth_.size(); ++k) {
        if (importance > 0.0 && level <= least_depth(k))
            break;
        importance += by_depth_[k].importance;
        lines += by_depth_[k].lines;
        if (importance > 0.0)
            level = (rays + lines) / importance;
    }
    return level;
}

// A pair whose exchange is known with the variance s^2 / m after m rays adds s^2 / m (rho_i^2 B_j^2 / A_i + rho_j^2
// B_i^2 / A_j) to the error (1), up to factors that all pairs share. For a given number of rays in all the sum is
// smallest when m is proportional to s times the root of the bracket.

namespace {

double sum_of_products(Rgb a, Rgb b)
{
    return a.r * b.r + a.g * b.g + a.b * b.b;
}

} // namespace

PairRayAllotment::PairRayAllotment(const ExchangeEstimate& estimate, const Scene& scene,
                                   const PairMatrix<float>& unoccluded, double crossing_area,
                                   const std::vector<Rgb>& radiosity)
    : estimate_(estimate), unoccluded_(unoccluded), crossing_area_(crossing_area)
{
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Rgb rho = scene.reflectance(i);
        receives_.push_back((1.0 / scene.area(i)) * (rho * rho));
        sends_.push_back(radiosity[i] * radiosity[i]);
    }
}

/// How much a pair deserves to be looked at. `spread` [m^4]: the variance of the exchange if one ray told it.
double PairRayAllotment::importance(std::uint32_t i, std::uint32_t j, double spread) const
{
    return std::sqrt(spread * (sum_of_products(receives_[i], sends_[j]) + sum_of_products(receives_[j], sends_[i])));
}

/// Calls visit(j, importance, lines) for the pairs (i, j < i) that leave doubt; the estimate is worth so many lines.
template <class Visit>
void PairRayAllotment::for_uncertain_pairs(std::uint32_t i, const Visit& visit) const
{
    const float* variance = estimate_.variance.row(i);
    const float* free_exchange = unoccluded_.row(i);
    for (std::uint32_t j = 0; j < i; ++j)
        if (variance[j] > 0.0f) {
            const double lines = static_cast<double>(free_exchange[j]) / crossing_area_;
            const double deserves = importance(i, j, static_cast<double>(variance[j]) * lines);
            if (deserves > 0.0)
                visit(j, deserves, lines);
        }
}

double PairRayAllotment::fill_level(std::uint64_t rays, int threads) const
{
    constexpr std::uint32_t parts = 32; // sums of each part in order: the same bits for any number of threads
    const std::uint32_t n = estimate_.exchange.size();
    std::vector<FillLevel> levels(parts);
    parallel_blocks(parts, threads, [&](std::uint64_t part) {
        for (auto i = static_cast<std::uint32_t>(part); i < n; i += parts)
            for_uncertain_pairs(
                i, [&](std::uint32_t, double deserves, double lines) { levels[part].add(deserves, lines); });
    });
    FillLevel all;
    for (const FillLevel& level : levels)
        all.add(level);
    return all.level(static_cast<double>(rays));
}

std::vector<double> PairRayAllotment::deserved_rays(std::uint32_t i) const
{
    std::vector<double> row(i);
    for_uncertain_pairs(
        i, [&](std::uint32_t j, double deserves, double lines) { row[j] = std::max(0.0, level_ * deserves - lines); });
    return row;
}

void PairRayAllotment::allot(std::uint64_t rays, std::uint64_t seed, int threads)
{
    const std::uint32_t n = estimate_.exchange.size();
    level_ = fill_level(rays, threads);
    std::vector<double> row_sums(n);
    parallel_blocks(n, threads, [&](std::uint64_t number) {
        const auto i = static_cast<std::uint32_t>(n - 1 - number); // long rows first
        for (const double x : deserved_rays(i))
            row_sums[i] += x;
    });
    rate_ = static_cast<double>(rays) / std::accumulate(row_sums.begin(), row_sums.end(), 0.0);
    before_ = {bits_to_unit(random_bits(mix_bits(seed ^ 0x243f6a8885a308d3u), 0))};
    for (const double sum : row_sums)
        before_.push_back(before_.back() + rate_ * sum);
}

RowOfRays PairRayAllotment::row(std::uint32_t i) const
{
    const std::vector<double> deserved = deserved_rays(i);
    RowOfRays row;
    SystematicRounding rounding(before_[i]); // goes on from the row before
    row.first_ray = rounding.given();
    double sum = 0.0;
    for (std::uint32_t j = 0; j < deserved.size(); ++j) {
        sum += deserved[j];
        const std::uint64_t rays = rounding.up_to(before_[i] + rate_ * sum);
        if (rays > 0)
            row.targets.push_back({j, rays});
    }
    row.end_ray = rounding.given();
    return row;
}

SharedRange PairRayAllotment::rows_of(Share share) const
{
    const std::uint64_t n = before_.size() - 1;
    const auto first_row = [&](std::uint64_t number) -> std::uint64_t {
        if (number == 0 || number == share.of)
            return number == 0 ? 0 : n;
        const double part = static_cast<double>(number) / static_cast<double>(share.of);
        const double rays = before_.front() + part * (before_.back() - before_.front());
        const auto row = std::lower_bound(before_.begin(), before_.end(), rays) - before_.begin();
        return std::min(n, static_cast<std::uint64_t>(row));
    };
    const std::uint64_t first = first_row(share.number);
    return {n, first, first, first_row(share.number + 1), share.of};
}

void PairRayAllotment::visit(Archive& archive)
{
    archive.value<double>("fill level", level_);
    archive.value<double>("rays per deserved ray", rate_);
    archive.growing_list<double>("rays before", before_);
    if (before_.size() != std::size_t{estimate_.exchange.size()} + 1)
        throw ArchiveError("the state is damaged: no such rows");
}

} // namespace multipath

#include "transport/sparse_exchange.h"

#include "parallel/ordered_blocks.h"

#include <algorithm>

namespace multipath {

namespace {

/// Runs work(patch) for all patches, in no particular order.
template <class Work>
void for_all_patches(std::uint32_t patches, int threads, const Work& work)
{
    constexpr std::uint32_t patches_per_block = 1024;
    parallel_blocks((patches + patches_per_block - 1) / patches_per_block, threads, [&](std::uint64_t block) {
        const auto first = static_cast<std::uint32_t>(block * patches_per_block);
        const std::uint32_t last = first + std::min(patches_per_block, patches - first);
        for (std::uint32_t i = first; i < last; ++i)
            work(i);
    });
}

} // namespace

SparseExchange::SparseExchange(const LineCounts& counts, double crossing_area, int threads)
    : counts_(counts), crossing_area_(crossing_area), row_area_(counts.size())
{
    for_all_patches(size(), threads, [&](std::uint32_t i) {
        std::uint64_t lines = counts_.escaped(i) + counts_.behind(i);
        for (const CountEntry& entry : counts_.row(i))
            lines += entry.count;
        row_area_[i] = crossing_area_ * static_cast<double>(lines);
    });
}

std::vector<Rgb> SparseExchange::apply(const std::vector<Rgb>& x, int threads) const
{
    std::vector<Rgb> y(size());
    for_all_patches(size(), threads, [&](std::uint32_t i) {
        Rgb sum;
        for (const CountEntry& entry : counts_.row(i))
            sum += static_cast<double>(entry.count) * x[entry.patch];
        y[i] = crossing_area_ * sum;
    });
    return y;
}

double SparseExchange::escaping(std::uint32_t patch) const
{
    return crossing_area_ * static_cast<double>(counts_.escaped(patch));
}

double SparseExchange::behind(std::uint32_t patch) const
{
    return crossing_area_ * static_cast<double>(counts_.behind(patch));
}

} // namespace multipath

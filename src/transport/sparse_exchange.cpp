#include "transport/sparse_exchange.h"

#include "parallel/ordered_blocks.h"

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

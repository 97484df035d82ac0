// Sparse counts of lines. Each row is the sorted list of the patches that its lines reached, with repetitions: 4 bytes
// per line and end. New lines are appended as 8-byte keys (row, column), which are radix-sorted and merged into the
// rows from time to time.
//
// The rows are partitioned into up to 256 parts, each with a mutex. A thread sorts the ends of its lines by part and
// adds them part by part. The order of the threads does not change the result: counts are integers, and rows are
// sorted.

#include "transport/exchange/line_counts.h"

#include "base/errors.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

namespace multipath {

void sort_keys(std::vector<std::uint64_t>& keys, int bits)
{
    constexpr int digit_bits = 11; // the offsets of all digit values then stay in the first-level cache
    constexpr std::size_t digit_values = std::size_t{1} << digit_bits;
    // For few keys the offsets do not pay; for more than 2^32 keys their type is too small.
    if (keys.size() < digit_values / 4 || keys.size() > 0xffffffffu) {
        std::sort(keys.begin(), keys.end());
        return;
    }
    std::vector<std::uint64_t> sorted(keys.size());
    for (int shift = 0; shift < bits; shift += digit_bits) {
        const auto digit = [shift](std::uint64_t key) {
            return static_cast<std::size_t>(key >> shift) & (digit_values - 1);
        };
        std::array<std::uint32_t, digit_values> offsets{}; // of the first key with each value of the digit
        for (const std::uint64_t key : keys)
            ++offsets[digit(key)];
        std::exclusive_scan(offsets.begin(), offsets.end(), offsets.begin(), std::uint32_t{0});
        for (const std::uint64_t key : keys)
            sorted[offsets[digit(key)]++] = key;
        keys.swap(sorted);
    }
}

namespace {

constexpr int bits_of_parts = 8; // up to 256 parts, many times the threads, so that these rarely contend for one

/// Number of bits that hold 0 ... count - 1.
int bits_for(std::uint64_t count)
{
    int bits = 0;
    while ((std::uint64_t{1} << bits) < count)
        ++bits;
    return bits;
}

} // namespace

CountRows::CountRows(std::uint32_t rows, std::uint32_t columns)
    : row_bits_(bits_for(rows)),
      column_bits_(bits_for(columns)),
      row_begin_(rows + std::size_t{1}, 0),
      escaped_(rows, 0),
      behind_(rows, 0)
{
}

void CountRows::add(std::uint32_t row, std::uint32_t end)
{
    if (end == Segment::outside)
        ++escaped_[row];
    else if (end == Segment::behind)
        ++behind_[row];
    else
        unsorted_.push_back(std::uint64_t{row} << column_bits_ | end);
}

void CountRows::merge()
{
    if (unsorted_.empty())
        return;
    CountRows fresh(rows(), 0);
    fresh.reached_.reserve(unsorted_.size());
    sort_keys(unsorted_, row_bits_ + column_bits_);
    const std::uint64_t column_mask = (std::uint64_t{1} << column_bits_) - 1;
    for (const std::uint64_t key : unsorted_) {
        fresh.reached_.push_back(static_cast<std::uint32_t>(key & column_mask));
        fresh.row_begin_[(key >> column_bits_) + 1] = fresh.reached_.size();
    }
    for (std::uint32_t i = 0; i < rows(); ++i) // rows without lines end where the row before them ends
        fresh.row_begin_[i + 1] = std::max(fresh.row_begin_[i + 1], fresh.row_begin_[i]);
    std::vector<std::uint64_t>().swap(unsorted_); // frees its memory
    add(fresh);
}

void CountRows::add(const CountRows& others)
{
    std::vector<std::uint64_t> begin = {0};
    begin.reserve(row_begin_.size());
    std::vector<std::uint32_t> sum(reached_.size() + others.reached_.size());
    for (std::uint32_t i = 0; i < rows(); ++i) {
        const CountRow a = row(i);
        const CountRow b = others.row(i);
        const auto end =
            std::merge(a.first, a.last, b.first, b.last, sum.begin() + static_cast<std::ptrdiff_t>(begin.back()));
        begin.push_back(static_cast<std::size_t>(end - sum.begin()));
        escaped_[i] += others.escaped_[i];
        behind_[i] += others.behind_[i];
    }
    row_begin_ = std::move(begin);
    reached_ = std::move(sum);
}

void CountRows::visit(Archive& archive)
{
    archive.list<std::uint64_t>("row begin", row_begin_);
    archive.growing_list<std::uint32_t>("reached", reached_);
    archive.list<std::uint64_t>("escaped", escaped_);
    archive.list<std::uint64_t>("behind", behind_);
    bool whole = row_begin_.front() == 0 && row_begin_.back() == reached_.size();
    for (std::size_t i = 0; i + 1 < row_begin_.size(); ++i)
        whole = whole && row_begin_[i] <= row_begin_[i + 1];
    for (const std::uint32_t patch : reached_)
        whole = whole && patch >> column_bits_ == 0;
    if (!whole)
        throw ArchiveError("the state is damaged: no such rows of counts");
}

LineCounts::LineCounts(std::uint32_t patches)
    : patches_(patches), part_bits_(std::max(0, bits_for(patches + std::uint64_t{1}) - bits_of_parts))
{
    const std::uint32_t rows = 1u << part_bits_;
    for (std::uint32_t first = 0; first < patches; first += rows)
        parts_.emplace_back(std::min(rows, patches - first), patches);
}

void LineCounts::add(const std::vector<Segment>& segments)
{
    // Each segment in both directions, sorted by the part of the patch that it leaves (counting sort).
    const auto for_ends = [&](const auto& take) {
        for (const Segment& segment : segments) {
            if (Segment::is_patch(segment.from))
                take(segment.from >> part_bits_, segment);
            if (Segment::is_patch(segment.to))
                take(segment.to >> part_bits_, Segment{segment.to, segment.from});
        }
    };
    std::vector<std::size_t> end_of_part(parts_.size() + 1, 0);
    for_ends([&](std::uint32_t p, const Segment&) { ++end_of_part[p + 1]; });
    std::partial_sum(end_of_part.begin(), end_of_part.end(), end_of_part.begin());
    std::vector<Segment> by_part(end_of_part.back());
    for_ends([&](std::uint32_t p, const Segment& segment) { by_part[end_of_part[p]++] = segment; });

    const Segment* segment = by_part.data();
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        const std::lock_guard<std::mutex> lock(parts_[p].mutex);
        for (const Segment* const end = by_part.data() + end_of_part[p]; segment != end; ++segment)
            parts_[p].counts.add(row_in_part(segment->from), segment->to);
    }
}

void LineCounts::merge(int threads)
{
    parallel_blocks(parts_.size(), threads, [&](std::uint64_t p) { parts_[p].counts.merge(); });
}

void LineCounts::add(LineCounts others, int threads)
{
    parallel_blocks(parts_.size(), threads, [&](std::uint64_t p) {
        parts_[p].counts.add(others.parts_[p].counts);
        others.parts_[p].counts = CountRows(0, 0);
    });
}

void LineCounts::visit(Archive& archive)
{
    for (std::size_t p = 0; p < parts_.size(); ++p)
        archive.object("part " + std::to_string(p), parts_[p].counts);
}

void count_rays(const Scene& scene, const Allotment& rays, const Sequence& sequence, std::uint64_t first_item,
                ShardRange& range, const RunControl& run, LineCounts& counts)
{
    // Unsorted lines take 16 more bytes per ray, but each merge copies all counts. So merges become rarer as counts
    // grow.
    constexpr std::uint64_t fewest_blocks_per_merge = 256;
    constexpr std::uint64_t merges_per_doubling = 8;
    const Blocks blocks = ray_blocks(rays);
    const bool has_sky = scene.file().sky_surfaces > 0;
    BlockBuffers<std::pair<RayBlock, std::vector<Segment>>> buffers(run.threads);
    const auto trace = [&](std::uint64_t block, int slot) {
        auto& [traced, segments] = buffers[slot];
        traced.items.resize(blocks.length(block));
        sequence.generate(first_item + blocks.first(block), traced.items);
        traced.patches.clear();
        const auto append = [&patches = traced.patches](std::uint32_t patch, std::uint64_t, std::size_t count) {
            patches.insert(patches.end(), count, patch);
        };
        rays.for_range(blocks.first(block), blocks.length(block), append);
        traced.trace(scene);
        segments.clear();
        for (std::size_t k = 0; k < traced.patches.size(); ++k) {
            const std::uint32_t end = traced.receivers[k];
            const bool escapes = has_sky && Segment::is_patch(end) && scene.is_sky_patch(end);
            segments.push_back({traced.patches[k], escapes ? Segment::outside : end});
        }
        counts.add(segments);
    };
    const auto report = [&](std::uint64_t block, int) { run.count_lines(blocks.length(block)); };
    while (range.next < range.end && !run.stopped()) {
        const std::uint64_t wait = std::max(fewest_blocks_per_merge, (range.next - range.first) / merges_per_doubling);
        resumable_blocks(range.next, std::min(range.end, range.next + wait), run, trace, report);
        counts.merge(run.threads);
    }
}

} // namespace multipath

#include "transport/exchange/count_rows.h"

#include "transport/lines/line_segments.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace multipath {

namespace {

constexpr int digit_bits = 11; // the places of all digits then stay in the first-level cache
constexpr std::size_t digit_values = std::size_t{1} << digit_bits;

using DigitPlaces = std::array<std::uint32_t, digit_values>;

std::size_t digit(std::uint64_t key, int shift)
{
    return static_cast<std::size_t>(key >> shift) & (digit_values - 1);
}

/// Where the keys with each value of the digit begin.
DigitPlaces places_of(const std::vector<std::uint64_t>& keys, int shift)
{
    DigitPlaces places{};
    for (const std::uint64_t key : keys)
        ++places[digit(key, shift)];
    std::uint32_t begin = 0;
    for (std::uint32_t& place : places) {
        const std::uint32_t count = place;
        place = begin;
        begin += count;
    }
    return places;
}

} // namespace

void sort_keys(std::vector<std::uint64_t>& keys, int bits)
{
    // Few keys do not pay for the places; more than 2^32 would not fit into them.
    if (keys.size() < digit_values / 4 || keys.size() > 0xffffffffu) {
        std::sort(keys.begin(), keys.end());
        return;
    }
    std::vector<std::uint64_t> sorted(keys.size());
    for (int shift = 0; shift < bits; shift += digit_bits) {
        DigitPlaces places = places_of(keys, shift);
        for (const std::uint64_t key : keys)
            sorted[places[digit(key, shift)]++] = key;
        keys.swap(sorted);
    }
}

namespace {

/// How many bits the numbers 0 ... count - 1 take.
int bits_for(std::uint64_t count)
{
    int bits = 0;
    while ((std::uint64_t{1} << bits) < count)
        ++bits;
    return bits;
}

/// Calls take(entry) for the sum of two rows, in order.
template <class Take>
void for_sum(CountRow a, CountRow b, const Take& take)
{
    while (a.first != a.last && b.first != b.last) {
        if (a.first->patch == b.first->patch)
            take(CountEntry{a.first->patch, (a.first++)->count + (b.first++)->count});
        else
            take(a.first->patch < b.first->patch ? *a.first++ : *b.first++);
    }
    std::for_each(a.first, a.last, take);
    std::for_each(b.first, b.last, take);
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
    ++lines_;
    if (end == Segment::outside)
        ++escaped_[row];
    else if (end == Segment::behind)
        ++behind_[row];
    else
        waiting_.push_back(std::uint64_t{row} << column_bits_ | end);
}

void CountRows::merge()
{
    if (waiting_.empty())
        return;
    CountRows fresh(rows(), 0);
    fresh.entries_.reserve(waiting_.size());
    sort_keys(waiting_, row_bits_ + column_bits_);
    const std::uint64_t column_mask = (std::uint64_t{1} << column_bits_) - 1;
    for (std::size_t k = 0; k < waiting_.size(); ++k) {
        if (k > 0 && waiting_[k] == waiting_[k - 1]) {
            ++fresh.entries_.back().count;
            continue;
        }
        fresh.entries_.push_back({static_cast<std::uint32_t>(waiting_[k] & column_mask), 1});
        fresh.row_begin_[(waiting_[k] >> column_bits_) + 1] = fresh.entries_.size();
    }
    for (std::uint32_t i = 0; i < rows(); ++i) // rows without an entry begin where the one before ends
        fresh.row_begin_[i + 1] = std::max(fresh.row_begin_[i + 1], fresh.row_begin_[i]);
    std::vector<std::uint64_t>().swap(waiting_); // gives its memory back
    add(fresh);
}

void CountRows::add(const CountRows& others)
{
    std::vector<std::size_t> begin = {0};
    begin.reserve(row_begin_.size());
    std::vector<CountEntry> sum;
    sum.reserve(entries_.size() + others.entries_.size());
    for (std::uint32_t i = 0; i < rows(); ++i) {
        for_sum(row(i), others.row(i), [&](CountEntry entry) { sum.push_back(entry); });
        begin.push_back(sum.size());
        escaped_[i] += others.escaped_[i];
        behind_[i] += others.behind_[i];
    }
    sum.shrink_to_fit();
    row_begin_ = std::move(begin);
    entries_ = std::move(sum);
    lines_ += others.lines_;
}

CountRow CountRows::row(std::uint32_t row) const
{
    return {entries_.data() + row_begin_[row], entries_.data() + row_begin_[row + 1]};
}

void CountRows::visit(Archive& archive)
{
    archive.list<std::uint64_t>("row begin", row_begin_);
    archive.growing_list<std::uint32_t>("entries", entries_);
    archive.list<std::uint64_t>("escaped", escaped_);
    archive.list<std::uint64_t>("behind", behind_);
    archive.value<std::uint64_t>("lines", lines_);
    bool whole = row_begin_.front() == 0 && row_begin_.back() == entries_.size();
    for (std::size_t i = 0; i + 1 < row_begin_.size(); ++i)
        whole = whole && row_begin_[i] <= row_begin_[i + 1];
    for (const CountEntry& entry : entries_)
        whole = whole && entry.patch >> column_bits_ == 0;
    if (!whole)
        throw ArchiveError("the state is damaged: no such rows of counts");
}

std::size_t CountRows::bytes() const
{
    return entries_.capacity() * sizeof(CountEntry) + waiting_.capacity() * sizeof(std::uint64_t) +
           rows() * (sizeof(std::size_t) + 2 * sizeof(std::uint64_t));
}

} // namespace multipath

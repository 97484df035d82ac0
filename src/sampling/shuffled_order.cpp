#include "sampling/shuffled_order.h"

#include "sampling/random.h"

#include <algorithm>

namespace multipath {

namespace {

/// One of many permutations of 0 ... 4095, chosen by the key: every step can be undone in 12 bits.
std::uint64_t permuted(std::uint64_t place, std::uint64_t key)
{
    constexpr std::uint64_t mask = ShuffledOrder::block_size - 1;
    for (int round = 0; round < 4; ++round) {
        place = (place * (key | 1) + (key >> 12)) & mask;
        place ^= place >> 5;
        key = (key >> 16) | (key << 48);
    }
    return place;
}

/// A permutation of 0 ... size - 1: what leaves the range is permuted again until it comes back.
std::uint64_t permuted_within(std::uint64_t place, std::uint64_t size, std::uint64_t key)
{
    do
        place = permuted(place, key);
    while (place >= size);
    return place;
}

} // namespace

ShuffledOrder::ShuffledOrder(const Sequence& base, std::uint64_t first, std::uint64_t count)
    : base_(base), first_(first), count_(count)
{
}

std::uint64_t ShuffledOrder::item_at(std::uint64_t n) const
{
    if (n < first_ || n - first_ >= count_)
        return n;
    const std::uint64_t block = (n - first_) / block_size;
    const std::uint64_t before = block * block_size;
    const std::uint64_t size = std::min(block_size, count_ - before);
    return first_ + before + permuted_within(n - first_ - before, size, mix_bits(block + 0x13198a2e03707344u));
}

void ShuffledOrder::generate(std::uint64_t first, std::vector<Item>& items) const
{
    std::vector<Item> block;
    std::uint64_t block_first = 0; // the block holds the items from here on
    for (std::size_t k = 0; k < items.size(); ++k) {
        const std::uint64_t n = item_at(first + k);
        if (n < block_first || n - block_first >= block.size()) {
            block_first = n < first_ ? n : n - (n - first_) % block_size;
            block.resize(static_cast<std::size_t>(std::min(block_size, item_limit() - block_first)));
            base_.generate(block_first, block);
        }
        items[k] = block[static_cast<std::size_t>(n - block_first)];
    }
}

} // namespace multipath

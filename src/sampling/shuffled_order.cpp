#include "sampling/shuffled_order.h"

#include "sampling/random.h"

#include <algorithm>

namespace multipath {

namespace {

/// A permutation of 0 ... 4095, chosen by the key: every step is invertible modulo 2^12.
std::uint64_t permuted(std::uint64_t index, std::uint64_t key)
{
    constexpr std::uint64_t mask = ShuffledOrder::block_size - 1;
    for (int round = 0; round < 4; ++round) {
        index = (index * (key | 1) + (key >> 12)) & mask;
        index ^= index >> 5;
        key = (key >> 16) | (key << 48);
    }
    return index;
}

/// A permutation of 0 ... size - 1 by cycle walking: an index outside the range is permuted again until it is inside.
std::uint64_t permuted_within(std::uint64_t index, std::uint64_t size, std::uint64_t key)
{
    do
        index = permuted(index, key);
    while (index >= size);
    return index;
}

} // namespace

ShuffledOrder::ShuffledOrder(const Sequence& base, std::uint64_t first, std::uint64_t count)
    : base_(base), first_(first), count_(count)
{
}

std::uint64_t ShuffledOrder::size_of(std::uint64_t block) const
{
    return std::min(block_size, count_ - block * block_size);
}

std::uint64_t ShuffledOrder::key_of(std::uint64_t block)
{
    return mix_bits(block + random_key(RandomStream::shuffled_blocks));
}

std::uint64_t ShuffledOrder::item_at(std::uint64_t n) const
{
    if (n < first_ || n - first_ >= count_)
        return n;
    const std::uint64_t block = (n - first_) / block_size;
    const std::uint64_t before = first_ + block * block_size;
    return before + permuted_within(n - before, size_of(block), key_of(block));
}

void ShuffledOrder::generate(std::uint64_t first, std::vector<Item>& items) const
{
    const bool whole_block = first >= first_ && first - first_ < count_ && (first - first_) % block_size == 0 &&
                             items.size() == size_of((first - first_) / block_size);
    if (!whole_block) {
        for (std::size_t k = 0; k < items.size(); ++k)
            items[k] = base_.item(item_at(first + k));
        return;
    }
    std::vector<Item> in_order(items.size());
    base_.generate(first, in_order);
    const std::uint64_t key = key_of((first - first_) / block_size);
    for (std::size_t k = 0; k < items.size(); ++k)
        items[k] = in_order[static_cast<std::size_t>(permuted_within(k, items.size(), key))];
}

} // namespace multipath

#pragma once

#include "sampling/sequence.h"

namespace multipath {

/// A sequence with part of its items in shuffled order: a pseudo-random permutation within each block of items. The
/// permutation is the same in every run: it depends only on the number of the block and its size. Successive items of a
/// quasi-random sequence are far from each other by design. This correlation biases the walk of the multi-path method,
/// whose result depends on the order of the lines. Shuffling breaks the correlation, but keeps the set of items, and
/// with it the uniformity of the sequence.
class ShuffledOrder final : public Sequence
{
public:
    static constexpr std::uint64_t block_size = 4096; ///< items in a block; the last block may have fewer

    /// Shuffles the items first ... first + count - 1 of `base`, all of which must exist. The other items keep their
    /// order. `base` must outlive this object.
    ShuffledOrder(const Sequence& base, std::uint64_t first, std::uint64_t count);

    std::string name() const override { return base_.name(); }
    int dimensions() const override { return base_.dimensions(); }
    std::uint64_t item_limit() const override { return base_.item_limit(); }
    double coordinate(std::uint64_t n, int dimension) const override { return base_.coordinate(item_at(n), dimension); }
    /// Fast if the items first ... first + items.size() - 1 are exactly one of the shuffled blocks.
    void generate(std::uint64_t first, std::vector<Item>& items) const override;

    /// Index that item n of this sequence has in the base sequence.
    std::uint64_t item_at(std::uint64_t n) const;

private:
    std::uint64_t size_of(std::uint64_t block) const;
    static std::uint64_t key_of(std::uint64_t block);

    const Sequence& base_;
    std::uint64_t first_; ///< first item to be shuffled
    std::uint64_t count_; ///< number of items to be shuffled
};

} // namespace multipath

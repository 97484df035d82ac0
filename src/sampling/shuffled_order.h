#pragma once

#include "sampling/sequence.h"

namespace multipath {

/// A stretch of a sequence with its items in another order: within each block of them a permutation that looks random.
/// Successive items of a quasi-random sequence are far from each other by design. Where the order of the items matters,
/// as in a walk, that is a correlation to be broken; which items there are stays as it is, and so does how evenly they
/// fill space.
class ShuffledOrder final : public Sequence
{
public:
    static constexpr std::uint64_t block_size = 4096; ///< items

    /// Of the items first ... first + count - 1, which must exist; the others keep their places. `base` must outlive
    /// this.
    ShuffledOrder(const Sequence& base, std::uint64_t first, std::uint64_t count);

    std::string name() const override { return base_.name(); }
    int dimensions() const override { return base_.dimensions(); }
    std::uint64_t item_limit() const override { return base_.item_limit(); }
    double coordinate(std::uint64_t n, int dimension) const override { return base_.coordinate(item_at(n), dimension); }
    /// Fast for whole blocks.
    void generate(std::uint64_t first, std::vector<Item>& items) const override;

    /// Which item of the base stands at place n.
    std::uint64_t item_at(std::uint64_t n) const;

private:
    std::uint64_t size_of(std::uint64_t block) const;
    static std::uint64_t key_of(std::uint64_t block);

    const Sequence& base_;
    std::uint64_t first_;
    std::uint64_t count_;
};

} // namespace multipath

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace multipath {

/// Four numbers in [0, 1): what one line takes.
using Item = std::array<double, 4>;

/// A sequence of 4-D items. Item n is a function of n alone (and of what the sequence was made with), so that any part
/// can be generated anywhere: by any thread, again, or not at all.
class Sequence
{
public:
    virtual ~Sequence() = default;

    /// Makes this sequence again through make_sequence (with the same seed).
    virtual std::string name() const = 0;

    /// Number n, dimension 0 ... 3, in [0, 1).
    virtual double coordinate(std::uint64_t n, int dimension) const = 0;

    /// Fills `items` with the items first, first + 1, ... : the same numbers as coordinate(), faster.
    virtual void generate(std::uint64_t first, std::vector<Item>& items) const;

    Item item(std::uint64_t n) const
    {
        return {coordinate(n, 0), coordinate(n, 1), coordinate(n, 2), coordinate(n, 3)};
    }
};

/// How four numbers are taken from a sequence: one 4-D item, or two successive items of its first two dimensions, the
/// arrangement that the paper found to fail for quasi-random sequences (its section 3).
enum class Pairing { four_dimensional, two_dimensional };

/// `random`, `sobol`, `halton` (bases 2, 7, 3, 5 as in the paper) or `halton:a,b,c,d` with four pairwise coprime bases.
/// Only `random` depends on the seed. Throws std::invalid_argument with the reason.
std::unique_ptr<Sequence> make_sequence(const std::string& name, std::uint64_t seed,
                                        Pairing pairing = Pairing::four_dimensional);

} // namespace multipath

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Four numbers in [0, 1): what one line takes.
using Item = std::array<double, 4>;

/// A sequence of points in [0, 1)^d. Number n is a function of n alone (and of what the sequence was made with), so
/// that any part can be generated anywhere: by any thread, again, or not at all.
class Sequence
{
public:
    virtual ~Sequence() = default;

    /// Makes this sequence again through make_sequence (with the same seed and number of dimensions).
    virtual std::string name() const = 0;
    virtual int dimensions() const = 0;

    /// Points from this number on do not exist or repeat; a caller must stop before.
    virtual std::uint64_t item_limit() const = 0;

    /// Coordinate of point n < item_limit(), 0 <= dimension < dimensions(), in [0, 1).
    virtual double coordinate(std::uint64_t n, int dimension) const = 0;

    /// Fills `items` with the first four coordinates of the points first, first + 1, ... : the same numbers as
    /// coordinate(), faster. Needs four dimensions or more.
    virtual void generate(std::uint64_t first, std::vector<Item>& items) const;

    Item item(std::uint64_t n) const
    {
        return {coordinate(n, 0), coordinate(n, 1), coordinate(n, 2), coordinate(n, 3)};
    }
};

/// Random bits that tell nothing of the item from which they are made.
std::uint64_t bits_from(const Item& item);

/// How four numbers are taken from a sequence: one 4-D item, or two successive items of its first two dimensions, the
/// arrangement that the paper found to fail for quasi-random sequences (its section 3).
enum class Pairing { four_dimensional, two_dimensional };

/// What a sequence is called, and what may follow its name: a list of pairwise coprime bases as in `halton:2,7,3,5`, or
/// a number of points as in `hammersley:4096`.
struct SequenceKind
{
    std::string_view name;
    std::string_view arguments; ///< "[:BASES]"; brackets around what may be left out; empty: nothing
    std::string_view summary;   ///< a few words
    /// The kind that the seed randomises of the same points: its own name where it is one, nothing where there is none.
    std::string_view randomised;
    bool fills_best_at_powers_of_two; ///< numbers of points
    bool in_selftest;

    /// True if a list of bases may follow the name, one for each dimension.
    bool may_have_bases() const { return arguments == "[:BASES]"; }
};

/// All that make_sequence() knows.
std::vector<SequenceKind> sequence_kinds();

/// The one of them that a name with its arguments means. Throws std::invalid_argument for an unknown name.
const SequenceKind& sequence_kind(const std::string& name);

/// The name of one of sequence_kinds() with its arguments. The seed chooses among the random and the randomised ones.
/// Throws std::invalid_argument with the reason.
std::unique_ptr<Sequence> make_sequence(const std::string& name, std::uint64_t seed, int dimensions = 4);

/// The same for lines: four dimensions, arranged as `pairing` says.
std::unique_ptr<Sequence> make_line_sequence(const std::string& name, std::uint64_t seed, Pairing pairing);

/// The name of the randomised kind, with the same bases, for independent replicates: `name` itself where it is one.
/// Throws std::invalid_argument where there is none.
std::string randomised_name(const std::string& name);

/// True if the seed chooses among sequences of this name.
bool is_randomised(const std::string& name);

} // namespace multipath

#pragma once

#include "sampling/random.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// An item, a point of four coordinates in [0, 1): the numbers that make one line.
using Item = std::array<double, 4>;

/// A sequence of points in [0, 1)^d. It has no state: point n depends only on n, the kind of sequence and its seed, so
/// any thread can generate any part of it, in any order. Immutable and thread-safe.
class Sequence
{
public:
    virtual ~Sequence() = default;

    /// The name for which make_sequence, with the same seed and number of dimensions, makes this sequence again. A
    /// sequence made from another one (2-D pairs, ShuffledOrder) has the name of the other one.
    virtual std::string name() const = 0;
    virtual int dimensions() const = 0;

    /// Number of points. Callers must not ask for point item_limit() or later ones.
    virtual std::uint64_t item_limit() const = 0;

    /// One coordinate, in [0, 1), of point n < item_limit(); 0 <= dimension < dimensions().
    virtual double coordinate(std::uint64_t n, int dimension) const = 0;

    /// Fills all elements of `items` with the first four coordinates of the points first, first + 1, ...: the same
    /// numbers as coordinate(), in most sequences computed faster. Needs at least four dimensions.
    virtual void generate(std::uint64_t first, std::vector<Item>& items) const;

    /// The first four coordinates of point n. Needs at least four dimensions.
    Item item(std::uint64_t n) const
    {
        return {coordinate(n, 0), coordinate(n, 1), coordinate(n, 2), coordinate(n, 3)};
    }
};

/// How the seed changes the points of a sequence: not at all, by a shift of all points, or by a permutation of digits.
enum class Randomisation { none, shift, scramble };

/// What a sequence is made of, for the functions in the table of sequence.cpp.
struct SequenceRequest
{
    std::string kind;      ///< the name of the sequence without arguments
    std::string arguments; ///< those after the name, without the colon
    int dimensions;
    Randomisation randomisation;
    std::uint64_t key; ///< of random_bits(), from the seed

    /// Random bits for a dimension; 0 without a randomisation.
    std::uint64_t random_bits_of(std::size_t dimension) const;
};

/// Hash of an item: 64 bits that can be used as random bits.
std::uint64_t bits_from(const Item& item);

/// How a sequence gives the four numbers of a line: as one 4-D item, or as two successive 2-D points. The paper found
/// that the second arrangement fails for quasi-random sequences (its section 3).
enum class Pairing { four_dimensional, two_dimensional };

/// A kind of sequence. In the name of a sequence, arguments may follow the name of its kind: a list of pairwise coprime
/// bases as in `halton:2,7,3,5`, a number of points as in `hammersley:4096`, or both as in `hammersley:4096:2,7,3`.
struct SequenceKind
{
    std::string_view name;
    std::string_view arguments; ///< such as "[:BASES]", with brackets around an optional part; empty if there are none
    std::string_view summary;   ///< a few words for lists
    /// Name of the kind that randomises the same points by the seed. A randomised kind has its own name here; the text
    /// is empty if no kind randomises these points.
    std::string_view randomised;
    Randomisation randomisation;
    RandomStream stream; ///< of its random numbers
    std::unique_ptr<Sequence> (*make)(const SequenceRequest& request);
    bool in_selftest; ///< true if the selftest runs it
};

/// All kinds of sequences, in the order of the help text.
const std::vector<SequenceKind>& sequence_kinds();

/// The kind of a sequence, given its name with or without arguments. The arguments are not checked. Throws
/// std::invalid_argument for an unknown name.
const SequenceKind& sequence_kind(const std::string& name);

/// Makes a sequence, given the name of its kind with arguments, if there are any. The seed matters for randomised kinds
/// only. Throws std::invalid_argument, with the reason, for unknown names, wrong arguments and too many dimensions.
std::unique_ptr<Sequence> make_sequence(const std::string& name, std::uint64_t seed, int dimensions = 4);

/// Makes a sequence of 4-D items for lines. With two_dimensional pairing, item n consists of the points 2 n and 2 n + 1
/// of a 2-D sequence. Throws like make_sequence.
std::unique_ptr<Sequence> make_line_sequence(const std::string& name, std::uint64_t seed, Pairing pairing);

/// The name of the sequence that randomises the same points, with the same arguments, for independent replicates. It is
/// `name` itself if its kind is randomised. Throws std::invalid_argument if no kind randomises these points, or if the
/// name is unknown.
std::string randomised_name(const std::string& name);

/// True if a sequence of this name depends on the seed. Throws std::invalid_argument for an unknown name.
bool is_randomised(const std::string& name);

} // namespace multipath

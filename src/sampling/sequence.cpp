#include "sampling/sequence.h"

#include "sampling/halton.h"
#include "sampling/kronecker.h"
#include "sampling/random.h"
#include "sampling/sobol.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace multipath {

namespace {

class RandomSequence final : public Sequence
{
public:
    explicit RandomSequence(const SequenceRequest& request)
        : key_(request.key), dimensions_(static_cast<std::uint64_t>(request.dimensions))
    {
    }

    std::string name() const override { return "random"; }
    int dimensions() const override { return static_cast<int>(dimensions_); }
    std::uint64_t item_limit() const override { return (std::uint64_t{1} << 63) / dimensions_; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return bits_to_unit(random_bits(key_, dimensions_ * n + static_cast<std::uint64_t>(dimension)));
    }
    void generate(std::uint64_t first, std::vector<Item>& items) const override
    {
        std::uint64_t counter = dimensions_ * first;
        for (Item& item : items) {
            for (std::uint64_t d = 0; d < 4; ++d)
                item[d] = bits_to_unit(random_bits(key_, counter + d));
            counter += dimensions_;
        }
    }

private:
    std::uint64_t key_;
    std::uint64_t dimensions_;
};

/// Items of two successive 2-D points.
class PairedSequence final : public Sequence
{
public:
    explicit PairedSequence(std::unique_ptr<Sequence> points) : points_(std::move(points)) {}

    std::string name() const override { return points_->name(); }
    int dimensions() const override { return 4; }
    std::uint64_t item_limit() const override { return points_->item_limit() / 2; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return points_->coordinate(2 * n + static_cast<std::uint64_t>(dimension / 2), dimension % 2);
    }

private:
    std::unique_ptr<Sequence> points_;
};

/// The numbers of a list such as "2,7,3,5". Throws std::invalid_argument for anything else.
std::vector<std::uint64_t> parse_list(const std::string& text)
{
    std::vector<std::uint64_t> numbers;
    std::uint64_t value = 0;
    bool has_digit = false;
    for (const char c : text + ",") {
        if (c >= '0' && c <= '9' && value < std::uint64_t{1} << 59) {
            value = 10 * value + static_cast<std::uint64_t>(c - '0');
            has_digit = true;
        } else if (c == ',' && has_digit) {
            numbers.push_back(value);
            value = 0;
            has_digit = false;
        } else {
            throw std::invalid_argument("cannot read the numbers '" + text + "'; expected a list such as 2,7,3,5");
        }
    }
    return numbers;
}

/// The bases of a list, or the default ones for an empty text. Throws std::invalid_argument unless there is one per
/// dimension.
std::vector<std::uint64_t> bases_or_default(const std::string& text, int dimensions)
{
    std::vector<std::uint64_t> bases = text.empty() ? default_bases(dimensions) : parse_list(text);
    if (bases.size() != static_cast<std::size_t>(dimensions))
        throw std::invalid_argument("one base per dimension is needed, here " + std::to_string(dimensions) + ", but '" +
                                    text + "' has " + std::to_string(bases.size()));
    return bases;
}

using SequencePointer = std::unique_ptr<Sequence>;

/// Arguments: the number of points, also as in "2^16", and after a colon the bases of the other dimensions.
SequencePointer make_hammersley(const SequenceRequest& request)
{
    const std::string& arguments = request.arguments;
    const int dimensions = request.dimensions;
    const std::size_t colon = arguments.find(':');
    const std::string count = arguments.substr(0, colon);
    const std::string bases = colon == std::string::npos ? "" : arguments.substr(colon + 1);
    if (count.size() > 2 && count.compare(0, 2, "2^") == 0) {
        const std::vector<std::uint64_t> power = parse_list(count.substr(2));
        if (power.size() == 1 && power[0] <= 52)
            return make_hammersley_sequence(std::uint64_t{1} << power[0], bases_or_default(bases, dimensions - 1));
    }
    const std::vector<std::uint64_t> number = count.empty() ? std::vector<std::uint64_t>{} : parse_list(count);
    if (number.size() != 1)
        throw std::invalid_argument("hammersley needs its number of points; expected for instance hammersley:65536");
    return make_hammersley_sequence(number[0], bases_or_default(bases, dimensions - 1));
}

SequencePointer make_halton(const SequenceRequest& request)
{
    return make_halton_sequence(request, bases_or_default(request.arguments, request.dimensions));
}

SequencePointer make_random(const SequenceRequest& request)
{
    return std::make_unique<RandomSequence>(request);
}

/// A kind of sequence, its randomisation by one of the streams of random numbers, and the function that makes it.
struct MadeKind
{
    SequenceKind kind;
    Randomisation randomisation;
    RandomStream stream;
    SequencePointer (*make)(const SequenceRequest& request);
};

constexpr bool at_any_number = false;
constexpr bool at_powers_of_two = true;
constexpr bool in_selftest = true;

constexpr MadeKind made_kinds[] = {
    {{"random", "", "pseudo-random numbers by counter", "random", at_any_number, in_selftest},
     Randomisation::none,
     RandomStream::random_sequence,
     make_random},
    {{"sobol", "", "Sobol's sequence", "sobol-owen", at_powers_of_two, in_selftest},
     Randomisation::none,
     RandomStream::sobol_shift,
     make_sobol_sequence},
    {{"sobol-shift", "", "the same, shifted digit by digit", "sobol-shift", at_powers_of_two, !in_selftest},
     Randomisation::shift,
     RandomStream::sobol_shift,
     make_sobol_sequence},
    {{"sobol-owen", "", "the same, nested uniform scrambling", "sobol-owen", at_powers_of_two, in_selftest},
     Randomisation::scramble,
     RandomStream::sobol_scrambling,
     make_sobol_sequence},
    {{"halton", "[:BASES]", "radical inverses in coprime bases", "halton-permuted", at_any_number, in_selftest},
     Randomisation::none,
     RandomStream::halton_shift,
     make_halton},
    {{"halton-shift", "[:BASES]", "the same, shifted modulo 1", "halton-shift", at_any_number, !in_selftest},
     Randomisation::shift,
     RandomStream::halton_shift,
     make_halton},
    {{"halton-permuted", "[:BASES]", "the same, permuted digits", "halton-permuted", at_any_number, in_selftest},
     Randomisation::scramble,
     RandomStream::halton_permutations,
     make_halton},
    {{"kronecker", "", "powers of a golden ratio, modulo 1", "kronecker-shift", at_any_number, in_selftest},
     Randomisation::none,
     RandomStream::kronecker,
     make_kronecker_sequence},
    {{"kronecker-shift", "", "the same from a random start", "kronecker-shift", at_any_number, !in_selftest},
     Randomisation::shift,
     RandomStream::kronecker,
     make_kronecker_sequence},
    {{"hammersley", ":N[:BASES]", "N items, the first number n/N", "", at_any_number, !in_selftest},
     Randomisation::none,
     RandomStream::halton_shift,
     make_hammersley},
};

/// "random, sobol, ... or hammersley:N[:BASES]"
std::string known_kinds()
{
    std::string text;
    for (const MadeKind& made : made_kinds) {
        text += &made == std::begin(made_kinds) ? "" : &made + 1 == std::end(made_kinds) ? " or " : ", ";
        text.append(made.kind.name).append(made.kind.arguments);
    }
    return text;
}

/// The two parts of a name such as "halton:2,7,3,5".
struct NameParts
{
    std::string kind;
    std::string arguments; ///< with the colon, or empty
};

NameParts parts_of(const std::string& name)
{
    const std::size_t colon = std::min(name.find(':'), name.size());
    return {name.substr(0, colon), name.substr(colon)};
}

const MadeKind& kind_named(const std::string& name)
{
    const std::string kind = parts_of(name).kind;
    const auto* const made = std::find_if(std::begin(made_kinds), std::end(made_kinds),
                                          [&](const MadeKind& candidate) { return candidate.kind.name == kind; });
    if (made == std::end(made_kinds))
        throw std::invalid_argument("unknown sequence '" + name + "'; expected " + known_kinds());
    return *made;
}

} // namespace

void Sequence::generate(std::uint64_t first, std::vector<Item>& items) const
{
    for (Item& next : items)
        next = item(first++);
}

std::uint64_t SequenceRequest::random_bits_of(std::size_t dimension) const
{
    return randomisation == Randomisation::none ? 0 : random_bits(key, dimension);
}

std::vector<SequenceKind> sequence_kinds()
{
    std::vector<SequenceKind> kinds;
    for (const MadeKind& made : made_kinds)
        kinds.push_back(made.kind);
    return kinds;
}

const SequenceKind& sequence_kind(const std::string& name)
{
    return kind_named(name).kind;
}

std::unique_ptr<Sequence> make_sequence(const std::string& name, std::uint64_t seed, int dimensions)
{
    const MadeKind& made = kind_named(name);
    const auto [kind, arguments] = parts_of(name);
    if (!arguments.empty() && (made.kind.arguments.empty() || arguments == ":"))
        throw std::invalid_argument(
            "cannot read the sequence '" + name +
            "': " + (made.kind.arguments.empty() ? kind + " takes no bases" : "nothing follows the colon"));
    return made.make({kind, arguments.empty() ? "" : arguments.substr(1), dimensions, made.randomisation,
                      random_key(made.stream, seed)});
}

std::unique_ptr<Sequence> make_line_sequence(const std::string& name, std::uint64_t seed, Pairing pairing)
{
    if (pairing == Pairing::four_dimensional)
        return make_sequence(name, seed);
    // Four bases are those of 4-D items; pairs of 2-D points use the first two.
    const std::size_t colon = name.find(':');
    const bool has_bases = sequence_kind(name).arguments == "[:BASES]" && colon != std::string::npos;
    std::string points = name;
    if (has_bases) {
        const std::vector<std::uint64_t> bases = parse_list(name.substr(colon + 1));
        if (bases.size() == 4)
            points = name.substr(0, colon + 1) + std::to_string(bases[0]) + "," + std::to_string(bases[1]);
    }
    return std::make_unique<PairedSequence>(make_sequence(points, seed, 2));
}

std::string randomised_name(const std::string& name)
{
    const auto [kind, arguments] = parts_of(name);
    const std::string_view randomised = sequence_kind(name).randomised;
    if (randomised.empty())
        throw std::invalid_argument(kind + " has no randomised form for replicates; expected another sequence");
    return std::string(randomised) + arguments;
}

bool is_randomised(const std::string& name)
{
    const SequenceKind& kind = sequence_kind(name);
    return kind.randomised == kind.name;
}

std::uint64_t bits_from(const Item& item)
{
    std::uint64_t mixed = 0;
    for (const double x : item) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        mixed = mix_bits(mixed ^ bits) + 1;
    }
    return mix_bits(mixed);
}

} // namespace multipath

#include "sampling/sequence.h"

#include "sampling/halton.h"
#include "sampling/kronecker.h"
#include "sampling/sobol.h"

#include <algorithm>
#include <cstring>
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

/// Arguments: the number of points, and after a colon the bases of the other dimensions.
std::unique_ptr<Sequence> make_hammersley(const SequenceRequest& request)
{
    const std::string& arguments = request.arguments;
    const std::size_t colon = arguments.find(':');
    const std::string count = arguments.substr(0, colon);
    const std::string bases = colon == std::string::npos ? "" : arguments.substr(colon + 1);
    const std::vector<std::uint64_t> number = count.empty() ? std::vector<std::uint64_t>{} : parse_list(count);
    if (number.size() != 1)
        throw std::invalid_argument("hammersley needs its number of points; expected for instance hammersley:65536");
    return make_hammersley_sequence(number[0], bases_or_default(bases, request.dimensions - 1));
}

std::unique_ptr<Sequence> make_halton(const SequenceRequest& request)
{
    return make_halton_sequence(request, bases_or_default(request.arguments, request.dimensions));
}

std::unique_ptr<Sequence> make_random(const SequenceRequest& request)
{
    return std::make_unique<RandomSequence>(request);
}

constexpr bool in_selftest = true;

} // namespace

const std::vector<SequenceKind>& sequence_kinds()
{
    static const std::vector<SequenceKind> kinds = {
        {"random", "", "pseudo-random numbers by counter", "random", Randomisation::none, RandomStream::random_sequence,
         make_random, in_selftest},
        {"sobol", "", "Sobol's sequence", "sobol-owen", Randomisation::none, RandomStream::sobol_shift,
         make_sobol_sequence, in_selftest},
        {"sobol-shift", "", "the same, shifted digit by digit", "sobol-shift", Randomisation::shift,
         RandomStream::sobol_shift, make_sobol_sequence, !in_selftest},
        {"sobol-owen", "", "the same, nested uniform scrambling", "sobol-owen", Randomisation::scramble,
         RandomStream::sobol_scrambling, make_sobol_sequence, in_selftest},
        {"halton", "[:BASES]", "radical inverses in coprime bases", "halton-permuted", Randomisation::none,
         RandomStream::halton_shift, make_halton, in_selftest},
        {"halton-shift", "[:BASES]", "the same, shifted modulo 1", "halton-shift", Randomisation::shift,
         RandomStream::halton_shift, make_halton, !in_selftest},
        {"halton-permuted", "[:BASES]", "the same, permuted digits", "halton-permuted", Randomisation::scramble,
         RandomStream::halton_permutations, make_halton, in_selftest},
        {"kronecker", "", "powers of a golden ratio, modulo 1", "kronecker-shift", Randomisation::none,
         RandomStream::kronecker, make_kronecker_sequence, in_selftest},
        {"kronecker-shift", "", "the same from a random start", "kronecker-shift", Randomisation::shift,
         RandomStream::kronecker, make_kronecker_sequence, !in_selftest},
        {"hammersley", ":N[:BASES]", "N items, the first number n/N", "", Randomisation::none,
         RandomStream::halton_shift, make_hammersley, !in_selftest},
    };
    return kinds;
}

namespace {

/// "random, sobol, ... or hammersley:N[:BASES]"
std::string known_kinds()
{
    std::string text;
    for (const SequenceKind& kind : sequence_kinds()) {
        text += text.empty() ? "" : &kind == &sequence_kinds().back() ? " or " : ", ";
        text.append(kind.name).append(kind.arguments);
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

const SequenceKind& sequence_kind(const std::string& name)
{
    const std::string wanted = parts_of(name).kind;
    const auto kind = std::find_if(sequence_kinds().begin(), sequence_kinds().end(),
                                   [&](const SequenceKind& candidate) { return candidate.name == wanted; });
    if (kind == sequence_kinds().end())
        throw std::invalid_argument("unknown sequence '" + name + "'; expected " + known_kinds());
    return *kind;
}

std::unique_ptr<Sequence> make_sequence(const std::string& name, std::uint64_t seed, int dimensions)
{
    const SequenceKind& made = sequence_kind(name);
    const auto [kind, arguments] = parts_of(name);
    if (!arguments.empty() && (made.arguments.empty() || arguments == ":"))
        throw std::invalid_argument("cannot read the sequence '" + name + "': " +
                                    (made.arguments.empty() ? kind + " takes no bases" : "nothing follows the colon"));
    return made.make({kind, arguments.empty() ? "" : arguments.substr(1), dimensions, made.randomisation,
                      random_key(made.stream, seed)});
}

std::unique_ptr<Sequence> make_line_sequence(const std::string& name, std::uint64_t seed, Pairing pairing)
{
    return pairing == Pairing::four_dimensional ? make_sequence(name, seed)
                                                : std::make_unique<PairedSequence>(make_sequence(name, seed, 2));
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

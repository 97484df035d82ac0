#include "sampling/sequence.h"

#include "sampling/halton_sequence.h"
#include "sampling/kronecker_sequence.h"
#include "sampling/random.h"
#include "sampling/sobol_sequence.h"

#include <stdexcept>
#include <utility>

namespace multipath {

namespace {

class RandomSequence final : public Sequence
{
public:
    RandomSequence(std::uint64_t seed, int dimensions)
        : key_(mix_bits(seed ^ 0x6a09e667f3bcc908u)), dimensions_(static_cast<std::uint64_t>(dimensions))
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

/// Two successive points of two dimensions as one item.
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

/// "2,7,3,5" as numbers.
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

std::vector<std::uint64_t> bases_or_default(const std::string& text, int dimensions)
{
    std::vector<std::uint64_t> bases = text.empty() ? default_bases(dimensions) : parse_list(text);
    if (bases.size() != static_cast<std::size_t>(dimensions))
        throw std::invalid_argument("one base per dimension is needed, here " + std::to_string(dimensions) + ", but '" +
                                    text + "' has " + std::to_string(bases.size()));
    return bases;
}

std::unique_ptr<Sequence> make_hammersley(const std::string& arguments, int dimensions)
{
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

} // namespace

void Sequence::generate(std::uint64_t first, std::vector<Item>& items) const
{
    for (Item& place : items)
        place = item(first++);
}

std::unique_ptr<Sequence> make_sequence(const std::string& name, std::uint64_t seed, int dimensions)
{
    const std::size_t colon = name.find(':');
    const std::string kind = name.substr(0, colon);
    const bool has_arguments = colon != std::string::npos;
    const std::string arguments = has_arguments ? name.substr(colon + 1) : "";
    const bool takes_arguments = kind.compare(0, 6, "halton") == 0 || kind == "hammersley";
    if (has_arguments && (!takes_arguments || arguments.empty()))
        throw std::invalid_argument("cannot read the sequence '" + name +
                                    "': " + (takes_arguments ? "nothing follows the colon" : kind + " takes no bases"));
    if (kind == "random")
        return std::make_unique<RandomSequence>(seed, dimensions);
    if (kind == "sobol")
        return make_sobol_sequence(SobolKind::plain, seed, dimensions);
    if (kind == "sobol-shift")
        return make_sobol_sequence(SobolKind::shift, seed, dimensions);
    if (kind == "sobol-owen")
        return make_sobol_sequence(SobolKind::owen, seed, dimensions);
    if (kind == "halton")
        return make_halton_sequence(HaltonKind::plain, bases_or_default(arguments, dimensions), seed);
    if (kind == "halton-shift")
        return make_halton_sequence(HaltonKind::shift, bases_or_default(arguments, dimensions), seed);
    if (kind == "halton-permuted")
        return make_halton_sequence(HaltonKind::permuted, bases_or_default(arguments, dimensions), seed);
    if (kind == "kronecker" || kind == "kronecker-shift")
        return make_kronecker_sequence(kind == "kronecker-shift", seed, dimensions);
    if (kind == "hammersley")
        return make_hammersley(arguments, dimensions);
    throw std::invalid_argument(
        "unknown sequence '" + name +
        "'; expected random, sobol, sobol-shift, sobol-owen, halton, halton-shift, halton-permuted "
        "(with bases such as halton:2,7,3,5), kronecker, "
        "kronecker-shift or hammersley:N");
}

std::unique_ptr<Sequence> make_line_sequence(const std::string& name, std::uint64_t seed, Pairing pairing)
{
    if (pairing == Pairing::four_dimensional)
        return make_sequence(name, seed);
    // Four bases name the 4-D arrangement; pairs use the first two.
    const std::size_t colon = name.find(':');
    const bool has_bases = name.compare(0, 6, "halton") == 0 && colon != std::string::npos;
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
    const std::size_t colon = name.find(':');
    const std::string kind = name.substr(0, colon);
    const std::string bases = colon == std::string::npos ? "" : name.substr(colon);
    if (kind == "sobol")
        return "sobol-owen";
    if (kind == "halton")
        return "halton-permuted" + bases;
    if (kind == "kronecker")
        return "kronecker-shift";
    if (kind == "hammersley")
        throw std::invalid_argument("hammersley has no randomised form for replicates; expected another sequence");
    return name;
}

bool prefers_powers_of_two(const std::string& name)
{
    return name.compare(0, 5, "sobol") == 0;
}

} // namespace multipath

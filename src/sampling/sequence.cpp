#include "sampling/sequence.h"

#include "sampling/radical_inverse.h"
#include "sampling/random.h"
#include "sampling/sobol.h"

#include <numeric>
#include <stdexcept>
#include <utility>

namespace multipath {

namespace {

class RandomSequence final : public Sequence
{
public:
    explicit RandomSequence(std::uint64_t seed) : key_(mix_bits(seed ^ 0x6a09e667f3bcc908u)) {}

    std::string name() const override { return "random"; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return bits_to_unit(random_bits(key_, 4 * n + static_cast<std::uint64_t>(dimension)));
    }

private:
    std::uint64_t key_;
};

class SobolSequence final : public Sequence
{
public:
    std::string name() const override { return "sobol"; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return bits_to_unit(sobol::coordinate_bits(n, dimension));
    }

    // From one point to the next a single direction number changes: the one of the lowest zero bit of n.
    void generate(std::uint64_t first, std::vector<Item>& items) const override
    {
        const auto& directions = sobol::direction_numbers();
        std::array<std::uint64_t, 4> bits;
        for (std::size_t d = 0; d < 4; ++d)
            bits[d] = sobol::coordinate_bits(first, static_cast<int>(d));
        std::uint64_t n = first;
        for (Item& item : items) {
            std::size_t lowest_zero = 0;
            for (std::uint64_t rest = n++; (rest & 1u) != 0; rest >>= 1)
                ++lowest_zero;
            for (std::size_t d = 0; d < 4; ++d) {
                item[d] = bits_to_unit(bits[d]);
                bits[d] ^= directions[d][lowest_zero];
            }
        }
    }
};

class HaltonSequence final : public Sequence
{
public:
    explicit HaltonSequence(std::array<std::uint64_t, 4> bases) : bases_(bases) {}

    std::string name() const override
    {
        std::string text = "halton:";
        for (const std::uint64_t base : bases_)
            text += std::to_string(base) + ",";
        text.pop_back();
        return text;
    }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return radical_inverse(bases_[static_cast<std::size_t>(dimension)], n);
    }

private:
    std::array<std::uint64_t, 4> bases_;
};

class PairedSequence final : public Sequence
{
public:
    explicit PairedSequence(std::unique_ptr<Sequence> points) : points_(std::move(points)) {}

    std::string name() const override { return points_->name(); }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return points_->coordinate(2 * n + static_cast<std::uint64_t>(dimension / 2), dimension % 2);
    }

private:
    std::unique_ptr<Sequence> points_;
};

/// "2,7,3,5" as four pairwise coprime bases.
std::array<std::uint64_t, 4> parse_bases(const std::string& text)
{
    const std::string expected = "; expected four numbers such as halton:2,7,3,5";
    std::vector<std::uint64_t> bases;
    std::uint64_t value = 0;
    bool has_digit = false;
    for (const char c : text + ",") {
        if (c >= '0' && c <= '9') {
            value = 10 * value + static_cast<std::uint64_t>(c - '0');
            has_digit = true;
            if (value > 1'000'000)
                throw std::invalid_argument("a Halton base above 1000000 is of no use" + expected);
        } else if (c == ',' && has_digit) {
            bases.push_back(value);
            value = 0;
            has_digit = false;
        } else {
            throw std::invalid_argument("cannot read the Halton bases '" + text + "'" + expected);
        }
    }
    if (bases.size() != 4)
        throw std::invalid_argument("a line takes 4 numbers, but " + std::to_string(bases.size()) +
                                    " Halton bases are given" + expected);
    for (std::size_t i = 0; i < 4; ++i) {
        if (bases[i] < 2)
            throw std::invalid_argument("a Halton base must be at least 2, got " + std::to_string(bases[i]));
        for (std::size_t j = 0; j < i; ++j)
            if (std::gcd(bases[i], bases[j]) != 1)
                throw std::invalid_argument("Halton bases must have no common divisor, but " +
                                            std::to_string(bases[j]) + " and " + std::to_string(bases[i]) + " have");
    }
    return {bases[0], bases[1], bases[2], bases[3]};
}

} // namespace

void Sequence::generate(std::uint64_t first, std::vector<Item>& items) const
{
    for (Item& place : items)
        place = item(first++);
}

std::unique_ptr<Sequence> make_sequence(const std::string& name, std::uint64_t seed, Pairing pairing)
{
    if (pairing == Pairing::two_dimensional)
        return std::make_unique<PairedSequence>(make_sequence(name, seed));
    if (name == "random")
        return std::make_unique<RandomSequence>(seed);
    if (name == "sobol")
        return std::make_unique<SobolSequence>();
    if (name == "halton")
        return std::make_unique<HaltonSequence>(std::array<std::uint64_t, 4>{2, 7, 3, 5});
    const std::string prefix = "halton:";
    if (name.compare(0, prefix.size(), prefix) == 0)
        return std::make_unique<HaltonSequence>(parse_bases(name.substr(prefix.size())));
    throw std::invalid_argument("unknown sequence '" + name + "'; expected random, sobol, halton or halton:2,7,3,5");
}

} // namespace multipath

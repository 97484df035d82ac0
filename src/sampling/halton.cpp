// Halton sequences. The radical inverse of n is split into a part of the low k digits and a part of the high digits:
//
//   inverse(n) = inverse(n mod base^k) + inverse(floor(n / base^k)) / base^k.
//
// The first term comes from a table of base^k entries: as many as possible up to 4096, but at least one digit. The
// second term is the same for base^k successive n, so blocks of points cost little more than a look-up and an addition
// per coordinate. Permuted digits work in the same way.

#include "sampling/halton.h"

#include "sampling/random.h"

#include <numeric>
#include <stdexcept>
#include <utility>

namespace multipath {

namespace {

constexpr std::uint64_t largest_table = 4096; // 32 kB per base: four tables fit into the second-level cache

} // namespace

double radical_inverse(std::uint64_t base, std::uint64_t n)
{
    std::uint64_t reversed = 0;
    std::uint64_t power = 1;
    const std::uint64_t limit = (std::uint64_t{1} << 63) / base;
    while (n > 0 && power <= limit) {
        const std::uint64_t quotient = n / base;
        reversed = reversed * base + (n - quotient * base);
        power *= base;
        n = quotient;
    }
    const double value = static_cast<double>(reversed) / static_cast<double>(power);
    return value < 1.0 ? value : 1.0 - 0x1p-53;
}

namespace {

/// The permuted values of all digits, position by position.
std::vector<std::vector<double>> permuted_digits(std::uint64_t base, std::uint64_t key)
{
    std::vector<std::vector<double>> positions;
    std::uint64_t counter = 0;
    for (double weight = 1.0; weight > 0x1p-54;) {
        weight /= static_cast<double>(base);
        std::vector<double> values(base);
        for (std::uint64_t digit = 0; digit < base; ++digit)
            values[digit] = weight * static_cast<double>(digit);
        for (std::uint64_t left = base; left > 1; --left) // Fisher-Yates shuffle; bias of the modulo below 2^-44
            std::swap(values[left - 1], values[random_bits(key, counter++) % left]);
        positions.push_back(std::move(values));
    }
    return positions;
}

} // namespace

RadicalInverse::RadicalInverse(std::uint64_t base, std::optional<std::uint64_t> key) : base_(base)
{
    if (key)
        permuted_ = permuted_digits(base, *key);
    std::uint64_t size = base;
    for (; size * base <= largest_table; size *= base)
        ++low_digits_;
    low_.reserve(size);
    for (std::uint64_t n = 0; n < size; ++n)
        low_.push_back(key ? sum_of_permuted(n, 0, low_digits_) : radical_inverse(base, n));
}

double RadicalInverse::high_part(std::uint64_t high_digits) const
{
    return permuted_.empty() ? radical_inverse(base_, high_digits) / static_cast<double>(low_.size())
                             : sum_of_permuted(high_digits, low_digits_, permuted_.size());
}

double RadicalInverse::sum_of_permuted(std::uint64_t digits, std::size_t first, std::size_t end) const
{
    double value = 0.0;
    for (std::size_t position = first; position < end; ++position, digits /= base_)
        value += permuted_[position][digits % base_];
    return value;
}

namespace {

constexpr std::uint64_t largest_base = 1'000'000; // its first million points lie on a diagonal line
constexpr std::uint64_t halton_limit = std::uint64_t{1} << 63;

void check_bases(const std::vector<std::uint64_t>& bases)
{
    for (std::size_t i = 0; i < bases.size(); ++i) {
        if (bases[i] < 2)
            throw std::invalid_argument("a Halton base must be at least 2, got " + std::to_string(bases[i]));
        if (bases[i] > largest_base)
            throw std::invalid_argument("a Halton base above 1000000 is of no use, got " + std::to_string(bases[i]));
        for (std::size_t j = 0; j < i; ++j)
            if (std::gcd(bases[i], bases[j]) != 1)
                throw std::invalid_argument("Halton bases must have no common divisor, but " +
                                            std::to_string(bases[j]) + " and " + std::to_string(bases[i]) + " have");
    }
}

/// "2,7,3,5"
std::string bases_text(const std::vector<RadicalInverse>& inverses)
{
    std::string text;
    for (const RadicalInverse& inverse : inverses)
        text += (text.empty() ? "" : ",") + std::to_string(inverse.base());
    return text;
}

/// x + shift modulo 1, in [0, 1) also after rounding.
double shifted(double x, double shift)
{
    return x + shift < 1.0 ? x + shift : x + shift - 1.0;
}

/// All kinds of the sequence; without a shift the shifts are 0.
class HaltonSequence final : public Sequence
{
public:
    HaltonSequence(const SequenceRequest& request, const std::vector<std::uint64_t>& bases) : kind_(request.kind)
    {
        for (std::size_t d = 0; d < bases.size(); ++d) {
            const std::uint64_t bits = request.random_bits_of(d);
            const bool is_permuted = request.randomisation == Randomisation::scramble;
            inverses_.emplace_back(bases[d], is_permuted ? std::optional(bits) : std::nullopt);
            shifts_.push_back(is_permuted ? 0.0 : bits_to_unit(bits));
        }
    }

    std::string name() const override { return kind_ + ":" + bases_text(inverses_); }
    int dimensions() const override { return static_cast<int>(inverses_.size()); }
    std::uint64_t item_limit() const override { return halton_limit; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        const auto d = static_cast<std::size_t>(dimension);
        return shifted(inverses_[d](n), shifts_[d]);
    }
    void generate(std::uint64_t first, std::vector<Item>& items) const override
    {
        for (std::size_t d = 0; d < 4; ++d) {
            const double shift = shifts_[d];
            inverses_[d].for_range(first, items.size(),
                                   [&](std::uint64_t k, double x) { items[k][d] = shifted(x, shift); });
        }
    }

private:
    std::string kind_;
    std::vector<RadicalInverse> inverses_;
    std::vector<double> shifts_;
};

class HammersleySequence final : public Sequence
{
public:
    HammersleySequence(std::uint64_t count, const std::vector<std::uint64_t>& bases)
        : count_(count), inverses_(bases.begin(), bases.end())
    {
    }

    std::string name() const override { return "hammersley:" + std::to_string(count_) + ":" + bases_text(inverses_); }
    int dimensions() const override { return 1 + static_cast<int>(inverses_.size()); }
    std::uint64_t item_limit() const override { return count_; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        if (dimension == 0)
            return static_cast<double>(n) / static_cast<double>(count_);
        return inverses_[static_cast<std::size_t>(dimension) - 1](n);
    }

private:
    std::uint64_t count_;
    std::vector<RadicalInverse> inverses_;
};

} // namespace

std::unique_ptr<Sequence> make_halton_sequence(const SequenceRequest& request, const std::vector<std::uint64_t>& bases)
{
    check_bases(bases);
    return std::make_unique<HaltonSequence>(request, bases);
}

std::unique_ptr<Sequence> make_hammersley_sequence(std::uint64_t count, const std::vector<std::uint64_t>& bases)
{
    check_bases(bases);
    constexpr std::uint64_t most = std::uint64_t{1} << 52; // n / count must differ from its neighbours
    if (count < 1 || count > most)
        throw std::invalid_argument("hammersley needs a number of points from 1 to 2^52, got " + std::to_string(count));
    return std::make_unique<HammersleySequence>(count, bases);
}

std::vector<std::uint64_t> default_bases(int dimensions)
{
    if (dimensions == 4)
        return {2, 7, 3, 5};
    std::vector<std::uint64_t> primes;
    for (std::uint64_t candidate = 2; primes.size() < static_cast<std::size_t>(dimensions); ++candidate) {
        bool is_prime = true;
        for (const std::uint64_t prime : primes)
            is_prime = is_prime && candidate % prime != 0;
        if (is_prime)
            primes.push_back(candidate);
    }
    return primes;
}

} // namespace multipath

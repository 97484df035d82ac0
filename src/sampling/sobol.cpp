#include "sampling/sobol.h"

#include "sampling/random.h"

#include <stdexcept>

namespace multipath {

namespace sobol {

namespace {

/// The input of the recurrence: a primitive polynomial modulo 2, x^degree + c_1 x^(degree-1) + ... + 1, and starting
/// values.
struct Generator
{
    int degree;
    unsigned coefficients;              ///< c_1 ... c_(degree-1), as bits
    std::array<std::uint64_t, 4> start; ///< odd numbers m_1 ... m_degree
};

constexpr std::array<Generator, dimensions> generators = {{{1, 0, {1, 0, 0, 0}},
                                                           {2, 1, {1, 1, 0, 0}},
                                                           {3, 1, {1, 3, 7, 0}},
                                                           {3, 2, {1, 3, 3, 0}},
                                                           {4, 1, {1, 1, 3, 13}},
                                                           {4, 4, {1, 1, 5, 9}}}};

/// Direction numbers by Sobol's recurrence.
DirectionNumbers expand(const Generator& generator)
{
    DirectionNumbers v{};
    const auto degree = static_cast<std::size_t>(generator.degree);
    for (std::size_t j = 0; j < v.size(); ++j) {
        if (j < degree) {
            v[j] = generator.start[j] << (63 - j);
            continue;
        }
        v[j] = v[j - degree] ^ (v[j - degree] >> degree);
        for (std::size_t k = 1; k < degree; ++k)
            if ((generator.coefficients >> (degree - 1 - k) & 1u) != 0)
                v[j] ^= v[j - k];
    }
    return v;
}

std::array<DirectionNumbers, dimensions> expand_all()
{
    std::array<DirectionNumbers, dimensions> all{};
    for (std::size_t d = 0; d < all.size(); ++d)
        all[d] = expand(generators[d]);
    return all;
}

const std::array<DirectionNumbers, dimensions> table = expand_all();

} // namespace

const std::array<DirectionNumbers, dimensions>& direction_numbers()
{
    return table;
}

std::uint64_t coordinate_bits(std::uint64_t n, int dimension)
{
    const DirectionNumbers& v = table[static_cast<std::size_t>(dimension)];
    std::uint64_t x = 0;
    std::uint64_t gray = n ^ (n >> 1); // Antonov and Saleev: successive points differ by one direction number
    for (std::size_t bit = 0; gray != 0; ++bit, gray >>= 1)
        if ((gray & 1u) != 0)
            x ^= v[bit];
    return x;
}

} // namespace sobol

namespace {

/// Direction numbers of the first four dimensions side by side, bit by bit.
using StepTable = std::array<std::array<std::uint64_t, 4>, sobol::index_bits>;

/// Position of the lowest bit that is 0.
std::size_t lowest_zero(std::uint64_t n)
{
#if defined(__GNUC__)
    return static_cast<std::size_t>(__builtin_ctzll(~n));
#else
    std::size_t position = 0;
    for (; (n & 1u) != 0; n >>= 1)
        ++position;
    return position;
#endif
}

/// Generates successive points, beginning with `bits`, the coordinates of point `first`, and calls finish(item, bits)
/// for each. Takes one exclusive or per coordinate, since in the order of Antonov and Saleev successive points differ
/// by one direction number.
template <class Finish>
void walk(const StepTable& steps, std::array<std::uint64_t, 4> bits, std::uint64_t first, std::vector<Item>& items,
          const Finish& finish)
{
    std::uint64_t n = first;
    for (Item& item : items) {
        finish(item, bits);
        const std::array<std::uint64_t, 4>& step = steps[lowest_zero(n++) % sobol::index_bits];
        for (std::size_t d = 0; d < 4; ++d)
            bits[d] ^= step[d];
    }
}

class SobolSequence : public Sequence
{
public:
    explicit SobolSequence(int dimensions) : dimensions_(dimensions)
    {
        for (std::size_t bit = 0; bit < steps_.size(); ++bit)
            for (std::size_t d = 0; d < 4; ++d)
                steps_[bit][d] = sobol::direction_numbers()[d][bit];
    }

    std::string name() const override { return "sobol"; }
    int dimensions() const override { return dimensions_; }
    std::uint64_t item_limit() const override { return std::uint64_t{1} << sobol::index_bits; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return bits_to_unit(sobol::coordinate_bits(n, dimension) ^ shift_[static_cast<std::size_t>(dimension)]);
    }
    // The shift stays in the walking bits: exclusive or does not mind the order.
    void generate(std::uint64_t first, std::vector<Item>& items) const override
    {
        std::array<std::uint64_t, 4> bits = bits_of(first);
        for (std::size_t d = 0; d < 4; ++d)
            bits[d] ^= shift_[d];
        walk(steps_, bits, first, items, [](Item& item, const std::array<std::uint64_t, 4>& walking) {
            for (std::size_t d = 0; d < 4; ++d)
                item[d] = bits_to_unit(walking[d]);
        });
    }

protected:
    static std::array<std::uint64_t, 4> bits_of(std::uint64_t n)
    {
        return {sobol::coordinate_bits(n, 0), sobol::coordinate_bits(n, 1), sobol::coordinate_bits(n, 2),
                sobol::coordinate_bits(n, 3)};
    }

    StepTable steps_;
    std::array<std::uint64_t, sobol::dimensions> shift_{}; ///< per dimension: digital shift of all points

private:
    int dimensions_;
};

/// A random number for each dimension.
std::array<std::uint64_t, sobol::dimensions> random_keys(RandomStream stream, std::uint64_t seed)
{
    std::array<std::uint64_t, sobol::dimensions> keys{};
    for (std::uint64_t d = 0; d < keys.size(); ++d)
        keys[d] = random_bits(random_key(stream, seed), d);
    return keys;
}

class ShiftedSobol final : public SobolSequence
{
public:
    ShiftedSobol(std::uint64_t seed, int dimensions) : SobolSequence(dimensions)
    {
        shift_ = random_keys(RandomStream::sobol_shift, seed);
    }

    std::string name() const override { return "sobol-shift"; }
};

class OwenSobol final : public SobolSequence
{
public:
    OwenSobol(std::uint64_t seed, int dimensions)
        : SobolSequence(dimensions), keys_(random_keys(RandomStream::sobol_scrambling, seed))
    {
        for (auto& step : steps_) // reversed, since the scrambling works on reversed bits
            for (std::uint64_t& number : step)
                number = reverse_bits(number);
    }

    std::string name() const override { return "sobol-owen"; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return scrambled(reverse_bits(sobol::coordinate_bits(n, dimension)),
                         keys_[static_cast<std::size_t>(dimension)]);
    }
    void generate(std::uint64_t first, std::vector<Item>& items) const override
    {
        std::array<std::uint64_t, 4> bits = bits_of(first);
        for (std::uint64_t& b : bits)
            b = reverse_bits(b);
        walk(steps_, bits, first, items, [this](Item& item, const std::array<std::uint64_t, 4>& walking) {
            for (std::size_t d = 0; d < 4; ++d)
                item[d] = scrambled(walking[d], keys_[d]);
        });
    }

private:
    static double scrambled(std::uint64_t reversed, std::uint64_t key)
    {
        return bits_to_unit(reverse_bits(scramble_reversed(reversed, key)));
    }

    std::array<std::uint64_t, sobol::dimensions> keys_;
};

} // namespace

std::unique_ptr<Sequence> make_sobol_sequence(SobolKind kind, std::uint64_t seed, int dimensions)
{
    if (dimensions > sobol::dimensions)
        throw std::invalid_argument("Sobol's sequence has 6 dimensions here, but " + std::to_string(dimensions) +
                                    " are wanted; halton with that many bases has more");
    if (kind == SobolKind::shift)
        return std::make_unique<ShiftedSobol>(seed, dimensions);
    if (kind == SobolKind::owen)
        return std::make_unique<OwenSobol>(seed, dimensions);
    return std::make_unique<SobolSequence>(dimensions);
}

} // namespace multipath

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
constexpr DirectionNumbers expand(const Generator& generator)
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

} // namespace

constexpr std::array<DirectionNumbers, dimensions> direction_numbers = {expand(generators[0]), expand(generators[1]),
                                                                        expand(generators[2]), expand(generators[3]),
                                                                        expand(generators[4]), expand(generators[5])};

std::uint64_t coordinate_bits(std::uint64_t n, int dimension)
{
    const DirectionNumbers& v = direction_numbers[static_cast<std::size_t>(dimension)];
    std::uint64_t x = 0;
    std::uint64_t gray = n ^ (n >> 1); // Antonov and Saleev: successive points differ by one direction number
    for (std::size_t bit = 0; gray != 0; ++bit, gray >>= 1)
        if ((gray & 1u) != 0)
            x ^= v[bit];
    return x;
}

} // namespace sobol

namespace {

/// In the order of Antonov and Saleev successive points differ by one direction number, so that a walk from point to
/// point takes one exclusive or per coordinate. The bits of the walk are reversed if they are to be scrambled.
template <bool is_scrambled>
class SobolSequence final : public Sequence
{
public:
    explicit SobolSequence(const SequenceRequest& request) : kind_(request.kind), dimensions_(request.dimensions)
    {
        for (std::size_t d = 0; d < keys_.size(); ++d)
            keys_[d] = request.random_bits_of(d);
        for (std::size_t bit = 0; bit < sobol::index_bits; ++bit)
            for (std::size_t d = 0; d < 4; ++d)
                steps_[bit][d] = walking(sobol::direction_numbers[d][bit]);
    }

    std::string name() const override { return kind_; }
    int dimensions() const override { return dimensions_; }
    std::uint64_t item_limit() const override { return std::uint64_t{1} << sobol::index_bits; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return finished(walking(sobol::coordinate_bits(n, dimension)), static_cast<std::size_t>(dimension));
    }
    void generate(std::uint64_t first, std::vector<Item>& items) const override
    {
        std::array<std::uint64_t, 4> bits;
        for (std::size_t d = 0; d < 4; ++d)
            bits[d] = walking(sobol::coordinate_bits(first, static_cast<int>(d)));
        std::uint64_t n = first;
        for (Item& item : items) {
            for (std::size_t d = 0; d < 4; ++d)
                item[d] = finished(bits[d], d);
            const auto lowest_zero = static_cast<std::size_t>(__builtin_ctzll(~n++)); // position of the bit in n
            const std::array<std::uint64_t, 4>& step = steps_[lowest_zero];
            for (std::size_t d = 0; d < 4; ++d)
                bits[d] ^= step[d];
        }
    }

private:
    static std::uint64_t walking(std::uint64_t bits) { return is_scrambled ? reverse_bits(bits) : bits; }
    double finished(std::uint64_t bits, std::size_t dimension) const
    {
        return bits_to_unit(is_scrambled ? reverse_bits(scramble_reversed(bits, keys_[dimension]))
                                         : bits ^ keys_[dimension]);
    }

    std::string kind_;
    int dimensions_;
    std::array<std::uint64_t, sobol::dimensions> keys_{}; ///< of the scrambling, or the shift of all points
    /// The first direction numbers, bit by bit, and a zero for the step after the last point. Aligned, as a step across
    /// two cache lines costs a third of the speed.
    alignas(32) std::array<std::array<std::uint64_t, 4>, sobol::index_bits + 1> steps_{};
};

} // namespace

std::unique_ptr<Sequence> make_sobol_sequence(const SequenceRequest& request)
{
    if (request.dimensions > sobol::dimensions)
        throw std::invalid_argument("Sobol's sequence has 6 dimensions here, but " +
                                    std::to_string(request.dimensions) +
                                    " are wanted; halton with that many bases has more");
    if (request.randomisation == Randomisation::scramble)
        return std::make_unique<SobolSequence<true>>(request);
    return std::make_unique<SobolSequence<false>>(request);
}

} // namespace multipath

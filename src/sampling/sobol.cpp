#include "sampling/sobol.h"

namespace multipath::sobol {

namespace {

/// A primitive polynomial modulo 2, x^degree + c_1 x^(degree-1) + ... + 1, whose inner coefficients c are the bits of
/// `coefficients`, and the odd starting values m_1 ... m_degree.
struct Generator
{
    int degree;
    unsigned coefficients;
    std::array<std::uint64_t, 4> start;
};

constexpr std::array<Generator, dimensions> generators = {{{1, 0, {1, 0, 0, 0}},
                                                           {2, 1, {1, 1, 0, 0}},
                                                           {3, 1, {1, 3, 7, 0}},
                                                           {3, 2, {1, 3, 3, 0}},
                                                           {4, 1, {1, 1, 3, 13}},
                                                           {4, 4, {1, 1, 5, 9}}}};

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

} // namespace multipath::sobol

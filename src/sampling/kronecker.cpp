#include "sampling/kronecker.h"

#include "sampling/random.h"

#include <array>
#include <stdexcept>

namespace multipath {

namespace {

constexpr int most_dimensions = 6;
using Steps = std::array<std::uint64_t, most_dimensions>;

/// Steps for s dimensions as fixed-point fractions: steps_by_dimension[s - 1][j] = floor(2^64 / g^(j + 1)), with g the
/// positive root of g^(s + 1) = g + 1: the golden ratio for s = 1, the plastic number for s = 2.
constexpr std::array<Steps, most_dimensions> steps_by_dimension = {
    {{0x9e3779b97f4a7c15u},
     {0xc13fa9a902a6328fu, 0x91e10da5c79e7b1cu},
     {0xd1b54a32d192ed03u, 0xabc98388fb8fac02u, 0x8cb92ba72f3d8dd7u},
     {0xdb4f0b9175ae2165u, 0xbbe0563303a4615fu, 0xa0f2ec75a1fe1575u, 0x89e182857d9ed688u},
     {0xe19b01aa9d42c633u, 0xc6d1d6c8ed0c9631u, 0xaf36d01ef7518dbbu, 0x9a69443f36f710e6u, 0x881403b9339bd42du},
     {0xe60e2b722b53aeebu, 0xcebd76d9edb6a8efu, 0xb9c9aa3a51d00b65u, 0xa6f5777f6f88983fu, 0x9609c71eb7d03f7au,
      0x86d516e50b04ab1bu}}};

class KroneckerSequence final : public Sequence
{
public:
    explicit KroneckerSequence(const SequenceRequest& request)
        : kind_(request.kind),
          dimensions_(request.dimensions),
          steps_(steps_by_dimension[static_cast<std::size_t>(request.dimensions) - 1])
    {
        for (std::size_t d = 0; d < start_.size(); ++d)
            start_[d] =
                request.randomisation == Randomisation::none ? std::uint64_t{1} << 63 : request.random_bits_of(d);
    }

    std::string name() const override { return kind_; }
    int dimensions() const override { return dimensions_; }
    /// Beyond it neighbouring points are closer than doubles can resolve.
    std::uint64_t item_limit() const override { return std::uint64_t{1} << 52; }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        const auto d = static_cast<std::size_t>(dimension);
        return bits_to_unit(start_[d] + n * steps_[d]); // 2^64 stands for 1: overflow is the modulo
    }
    void generate(std::uint64_t first, std::vector<Item>& items) const override
    {
        for (std::size_t k = 0; k < items.size(); ++k)
            items[k] = {coordinate(first + k, 0), coordinate(first + k, 1), coordinate(first + k, 2),
                        coordinate(first + k, 3)};
    }

private:
    std::string kind_;
    int dimensions_;
    Steps steps_;
    Steps start_;
};

} // namespace

std::unique_ptr<Sequence> make_kronecker_sequence(const SequenceRequest& request)
{
    if (request.dimensions > most_dimensions)
        throw std::invalid_argument("the Kronecker sequence has 6 dimensions here, but " +
                                    std::to_string(request.dimensions) +
                                    " are wanted; halton with that many bases has more");
    return std::make_unique<KroneckerSequence>(request);
}

} // namespace multipath

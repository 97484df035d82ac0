// The product of a row of a symmetric matrix with one or three vectors, and the contribution of its mirror image, the
// column above the diagonal. This file is included once for each instruction set; parallel/lanes/plain.inl defines the
// functions of lanes.

namespace multipath {
namespace LANE_SET {
namespace {

constexpr std::uint32_t sum_count = 8; // for any number of lanes, so that all instruction sets add in the same order

template <int vectors>
KERNEL_ENTRY void multiply_row(const float* row, std::uint32_t i, RowProduct* products)
{
    constexpr std::uint32_t width = DoubleLanes::width;
    DoubleLanes sums[vectors][sum_count / width];
    for (int k = 0; k < vectors; ++k)
        for (std::uint32_t s = 0; s < sum_count / width; ++s)
            sums[k][s] = DoubleLanes::all(0.0);
    std::uint32_t j = 0;
    for (; j + sum_count <= i; j += sum_count)
        for (std::uint32_t s = 0; s < sum_count / width; ++s) {
            const std::uint32_t at = j + s * width;
            const DoubleLanes value = DoubleLanes::load_floats(row + at);
            for (int k = 0; k < vectors; ++k) {
                sums[k][s] = sums[k][s] + value * DoubleLanes::load(products[k].x + at);
                (DoubleLanes::load(products[k].y + at) + value * DoubleLanes::all(products[k].factor))
                    .store(products[k].y + at);
            }
        }
    for (int k = 0; k < vectors; ++k) {
        double parts[sum_count];
        for (std::uint32_t s = 0; s < sum_count / width; ++s)
            sums[k][s].store(parts + s * width);
        for (std::uint32_t rest = j; rest < i; ++rest) {
            const double value = row[rest];
            parts[0] += value * products[k].x[rest];
            products[k].y[rest] += value * products[k].factor;
        }
        const double sum =
            ((parts[0] + parts[1]) + (parts[2] + parts[3])) + ((parts[4] + parts[5]) + (parts[6] + parts[7]));
        products[k].y[i] += sum + static_cast<double>(row[i]) * products[k].factor; // with the diagonal
    }
}

constexpr RowKernel table = {LANE_SET_NAME, multiply_row<1>, multiply_row<3>};

} // namespace
} // namespace LANE_SET
} // namespace multipath

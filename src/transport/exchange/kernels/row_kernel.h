#pragma once

#include <cstdint>
#include <vector>

namespace multipath {

/// The contribution of row i of a symmetric matrix, stored up to its diagonal, to its product with one vector.
struct RowProduct
{
    const double* x; ///< the vector
    double factor;   ///< x[i]
    double* y;  ///< the product: the kernel adds row[j] * factor to y[j], for the mirrored elements above the diagonal
    double sum; ///< the kernel sets it to the sum of row[j] * x[j], to be added to y[i]
};

/// The innermost loop of symmetric_product, compiled for one instruction set. All kernels add in the same order, in
/// eight partial sums, and so give the same bits.
struct RowKernel
{
    const char* name; ///< of the instruction set

    /// Multiply row[0] ... row[count - 1] with one vector, or with three: `products` then has three elements.
    void (*multiply_one)(const float* row, std::uint32_t count, RowProduct* product);
    void (*multiply_three)(const float* row, std::uint32_t count, RowProduct* products);
};

/// The kernels whose instruction sets this processor has, the fastest first. The plain one is always among them.
std::vector<const RowKernel*> available_row_kernels();

} // namespace multipath

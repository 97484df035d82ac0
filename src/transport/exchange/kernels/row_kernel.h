#pragma once

#include <cstdint>
#include <vector>

namespace multipath {

/// One of the vectors that a row of a symmetric matrix is multiplied with, and its product.
struct RowProduct
{
    const double* x; ///< the vector
    double factor;   ///< its element of the row's own number
    double* y;       ///< the product, to which row[j] * factor is added
    double sum;      ///< of row[j] * x[j]; set
};

/// The innermost loop of symmetric_product, compiled for one instruction set. All add in the same order, eight sums
/// side by side, and so give the same bits.
struct RowKernel
{
    const char* name; ///< of the instruction set

    void (*multiply_one)(const float* row, std::uint32_t count, RowProduct* product);
    void (*multiply_three)(const float* row, std::uint32_t count, RowProduct* products);
};

/// Those whose instruction set is usable, the fastest first; the plain one is always there.
std::vector<const RowKernel*> available_row_kernels();

} // namespace multipath

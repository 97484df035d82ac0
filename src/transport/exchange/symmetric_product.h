#pragma once

#include "transport/exchange/pair_counts.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The contribution of row i of a symmetric matrix to the product of the matrix with one vector. Only the lower
/// triangle is stored; the `row` of a kernel is the part of row i up to the diagonal, the elements j <= i.
struct RowProduct
{
    const double* x; ///< the vector
    double factor;   ///< x[i]
    double* y; ///< the product: the kernel adds row i times x to y[i], and row[j] * factor to y[j] for each j < i, for
               ///< the mirrored elements above the diagonal
};

/// The innermost loop of symmetric_product, compiled for one instruction set. All kernels add in the same order, in
/// eight partial sums, so all give the same bits.
struct RowKernel
{
    const char* name; ///< name of the instruction set

    /// Both multiply row[0] ... row[i]: multiply_one with the vector of one RowProduct, multiply_three with
    /// those of an array of three.
    void (*multiply_one)(const float* row, std::uint32_t i, RowProduct* product);
    void (*multiply_three)(const float* row, std::uint32_t i, RowProduct* products);
};

/// The kernels of all usable() instruction sets (parallel/instruction_set.h), the fastest first. The kernel in plain
/// C++ is always among them.
std::vector<const RowKernel*> available_row_kernels();

/// The products of a symmetric matrix with one or three vectors of matrix.size() elements, in their order. Sums
/// are added in a fixed order, so the bits do not depend on the number of threads, nor on the kernel.
std::vector<std::vector<double>> symmetric_product(const PairMatrix<float>& matrix,
                                                   const std::vector<std::vector<double>>& vectors, int threads,
                                                   const RowKernel& kernel = *available_row_kernels().front());

/// The sum of each row of a symmetric matrix.
std::vector<double> row_sums(const PairMatrix<float>& matrix, int threads);

} // namespace multipath

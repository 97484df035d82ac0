#pragma once

#include "transport/exchange/kernels/row_kernel.h"
#include "transport/exchange/pair_counts.h"

#include <vector>

namespace multipath {

/// The products of a symmetric matrix with several vectors of matrix.size() elements, in the order of the vectors. Sums
/// are added in a fixed order, so the bits do not depend on the number of threads.
std::vector<std::vector<double>> symmetric_product(const PairMatrix<float>& matrix,
                                                   const std::vector<std::vector<double>>& vectors, int threads);

/// The same with the given kernel. All kernels give the same bits.
std::vector<std::vector<double>> symmetric_product(const PairMatrix<float>& matrix,
                                                   const std::vector<std::vector<double>>& vectors, int threads,
                                                   const RowKernel& kernel);

} // namespace multipath

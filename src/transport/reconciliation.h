#pragma once

#include "transport/exchange_estimate.h"

#include <vector>

namespace multipath {

/// Estimates that agree with what is known for certain.
struct Reconciled
{
    PairMatrix<float> exchange;     ///< [m^2]
    std::vector<double> sum_change; ///< [m^2] by how much each row now adds up to less than wanted
};

/// Changes the estimates as little as possible, measured by their variances, so that every row has the sum that it must
/// have [m^2], the area of the patch less what is lost. Symmetric; pairs that are certain stay. `sum_variance` [m^4] is
/// how uncertain each wanted sum is: it takes its part of the change.
Reconciled reconciled(ExchangeEstimate estimate, const std::vector<double>& row_sums,
                      const std::vector<double>& sum_variance, int threads);

} // namespace multipath

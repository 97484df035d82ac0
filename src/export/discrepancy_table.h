#pragma once

#include "sampling/sequence.h"

#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// Discrepancy of the first `count` points.
struct DiscrepancyRow
{
    std::uint64_t count;
    double l2_star;
    double random_l2_star;      ///< of independent random points, root mean square
    std::optional<double> star; ///< in one and two dimensions
};

/// For 1, 2, 4, ... points of the sequence from `first` on, and for all `count` of them; time of order count^2.
std::vector<DiscrepancyRow> measure_discrepancy(const Sequence& sequence, std::uint64_t first, std::uint64_t count);

/// For readers: aligned columns below a line of headings.
std::string discrepancy_text(const std::vector<DiscrepancyRow>& rows);

/// As CSV, 17 significant digits; `star` is empty where it is absent. The comments become `# ` lines before the header.
std::string discrepancy_table(const std::vector<DiscrepancyRow>& rows, const std::vector<std::string>& comments);

} // namespace multipath

#pragma once

#include "export/patch_table_reader.h"
#include "radiosity/error_measure.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace multipath {

/// In one channel of one patch.
struct Deviation
{
    std::size_t patch = 0;
    double value = 0.0; ///< A - B [W/m^2]
};

struct WorstPatch
{
    std::size_t patch;
    double share; ///< [1] of the MSE
};

/// How far A, the estimate, is from B, the reference. The lists of both have the same length.
struct Comparison
{
    const PatchTable& a;
    const PatchTable& b;
    double area = 0.0; ///< [m^2]
    ErrorMeasure error{};
    double mean_a = 0.0; ///< radiosity [W/m^2]
    double mean_b = 0.0;
    std::optional<double> expected_a{}; ///< [1] relative MSE (1) that the table's own standard errors let expect
    std::optional<double> expected_b{};
    Deviation largest{};
    std::vector<WorstPatch> worst{};

    double root() const; ///< [1] of the relative MSE

    /// 1 where A and B are independent and their standard errors are all that makes them differ; nothing without any.
    std::optional<double> measured_over_expected() const;
};

/// Throws InputError for tables of other patches, told by their number and areas.
void require_same_patches(const PatchTable& a, const PatchTable& b);

/// Of tables with the same patches, which must outlive it, with the `worst_count` patches that have the largest shares
/// of the MSE. Throws InputError for numbers too large to square, and for a reference without light.
Comparison compare(const PatchTable& a, const PatchTable& b, std::size_t worst_count);

} // namespace multipath

#pragma once

#include "exam/exam_row.h"

#include <string>
#include <vector>

namespace multipath {

/// A table to read; only the rows that did not pass if `only_failed`. The last line is "N passed, N failed".
std::string exam_text(const std::vector<ExamRow>& rows, bool only_failed);

/// One row per row: topic, method, sequence, quantity, expected, measured, standard_error, sigmas, limit, verdict.
/// Standard error and sigmas are empty where nothing is random, sigmas also where the runs agree to the last bit.
std::string exam_csv(const std::vector<ExamRow>& rows, const std::vector<std::string>& comments);

} // namespace multipath

#pragma once

#include "exam/broken_law.h"
#include "exam/exam_row.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// How an exam is held.
struct ExamSettings
{
    std::uint64_t seed = 1;
    int replicates = 32;           ///< independent runs that a row is the mean of, at least 2
    std::uint64_t lines = 1 << 15; ///< of every run
    std::optional<BrokenLaw> broken;
    int threads = 1; ///< of every run
};

/// What makes a run differ from its replicates: another randomisation or, of a sequence that has none, another stretch.
struct ExamRun
{
    std::uint64_t seed;
    std::uint64_t first_item; ///< of the sequence; a run may take 16 times as many items as lines
};

/// The runs of a row.
std::vector<ExamRun> exam_runs(const ExamSettings& settings, const std::string& sequence);

/// Sets mean, standard error and degrees of freedom from what the runs of row.sequence measured. Stretches of a
/// sequence that is not randomised share their errors to a part that their spread does not tell: the row may be off by
/// 1/200 of what is expected, besides.
ExamRow measured_by(ExamRow row, const std::vector<double>& samples);

/// The row with what another one measured, by other runs, for what is expected: the errors of both count.
ExamRow compared_with(ExamRow row, const ExamRow& other);

/// A part of an exam; may run beside other parts.
struct ExamTask
{
    std::string topic; ///< of its rows
    std::function<std::vector<ExamRow>()> rows;
};

/// The sequences that everything is examined with.
inline const std::vector<std::string> exam_sequences = {"random", "sobol",           "sobol-owen",
                                                        "halton", "halton-permuted", "kronecker"};

} // namespace multipath

#include "exam/exam_runs.h"

#include "sampling/random.h"
#include "sampling/sequence.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

bool is_randomised(const std::string& sequence)
{
    return randomised_name(sequence) == sequence;
}

} // namespace

std::vector<ExamRun> exam_runs(const ExamSettings& settings, const std::string& sequence)
{
    const bool randomised = is_randomised(sequence);
    const bool repeated = settings.broken == BrokenLaw::replicates;
    std::vector<ExamRun> runs;
    for (int number = 0; number < settings.replicates; ++number) {
        const std::uint64_t r = repeated ? 0 : static_cast<std::uint64_t>(number);
        runs.push_back({random_bits(mix_bits(settings.seed), r), randomised ? 0 : 16 * settings.lines * r});
    }
    return runs;
}

ExamRow measured_by(ExamRow row, const std::vector<double>& samples)
{
    const auto count = static_cast<double>(samples.size());
    double sum = 0.0;
    for (const double sample : samples)
        sum += sample;
    row.measured = sum / count;
    double squares = 0.0;
    for (const double sample : samples)
        squares += (sample - row.measured) * (sample - row.measured);
    row.degrees = static_cast<int>(samples.size()) - 1;
    row.standard_error = std::sqrt(squares / (count - 1.0) / count);
    if (!is_randomised(row.sequence))
        row.allowance += row.expected / 200.0;
    return row;
}

ExamRow compared_with(ExamRow row, const ExamRow& other)
{
    row.expected = other.measured;
    row.standard_error = std::hypot(row.standard_error, other.standard_error);
    row.degrees = std::min(row.degrees, other.degrees);
    return row;
}

} // namespace multipath

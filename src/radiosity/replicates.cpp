#include "radiosity/replicates.h"

#include "radiosity/error_measure.h"
#include "sampling/random.h"
#include "scene/input_error.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace multipath {

namespace {

/// Running mean and sum of squared deviations of each patch (Welford), which do not cancel.
class PatchMoments
{
public:
    explicit PatchMoments(std::size_t patches) : mean_(patches), squares_(patches) {}

    void add(const std::vector<Rgb>& values)
    {
        count_ += 1.0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const Rgb before = values[i] - mean_[i];
            mean_[i] += (1.0 / count_) * before;
            squares_[i] += before * (values[i] - mean_[i]);
        }
    }
    const std::vector<Rgb>& mean() const { return mean_; }
    /// Of the mean.
    std::vector<Rgb> standard_errors() const
    {
        std::vector<Rgb> errors(squares_);
        const double scale = 1.0 / (count_ * (count_ - 1.0));
        for (Rgb& e : errors)
            e = {std::sqrt(scale * e.r), std::sqrt(scale * e.g), std::sqrt(scale * e.b)};
        return errors;
    }

private:
    double count_ = 0.0;
    std::vector<Rgb> mean_;
    std::vector<Rgb> squares_;
};

void add(const PowerBalance& part, double share, PowerBalance& sum)
{
    sum.emitted += share * part.emitted;
    sum.absorbed += share * part.absorbed;
    sum.unshot += share * part.unshot;
    sum.escaped += share * part.escaped;
    sum.behind += share * part.behind;
    sum.source += share * part.source;
}

std::uint64_t replicate_seed(std::uint64_t seed, std::uint64_t round, int replicate)
{
    return random_bits(mix_bits(seed ^ 0x452821e638d01377u), (round << 32) + static_cast<std::uint64_t>(replicate));
}

Solution solve_round(const Scene& scene, const Preparation& preparation, const SolveOptions& options, int replicates,
                     std::uint64_t round, const ProgressCallback& progress)
{
    const auto parts = static_cast<std::uint64_t>(replicates);
    if (options.lines < parts)
        throw InputError(std::to_string(replicates) + " replicates need as many lines; expected more lines");
    SolveOptions replicate = options;
    replicate.sequence = randomised_name(options.sequence);
    PatchMoments moments(scene.patch_count());
    Solution sum;
    sum.unshot.resize(scene.patch_count());
    for (int r = 0; r < replicates; ++r) {
        const auto part = static_cast<std::uint64_t>(r);
        replicate.lines = options.lines / parts + (part < options.lines % parts ? 1 : 0);
        replicate.seed = replicate_seed(options.seed, round, r);
        const Solution one = solve(scene, preparation, replicate,
                                   [&](double done) { progress((r + done) / static_cast<double>(replicates)); });
        moments.add(one.radiosity);
        add(one.balance, 1.0 / replicates, sum.balance);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            sum.unshot[i] += 1.0 / replicates * one.unshot[i];
        sum.local_lines += one.local_lines;
        sum.global_lines += one.global_lines;
        sum.global_lines_cast += one.global_lines_cast;
        if (r == 0)
            sum.shot_passes = one.shot_passes;
    }
    sum.radiosity = moments.mean();
    sum.standard_error = moments.standard_errors();
    sum.relative_standard_error = std::sqrt(expected_relative_square(scene.areas(), sum.radiosity, sum.standard_error));
    sum.replicates = replicates;
    sum.all_lines = sum.local_lines + sum.global_lines;
    return sum;
}

} // namespace

Solution solve_replicates(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
                          int replicates, const ProgressCallback& progress)
{
    return solve_round(scene, preparation, options, replicates, 0, progress);
}

Solution solve_until(const Scene& scene, const SolveOptions& options, int replicates, std::uint64_t first_lines,
                     const std::function<bool(const Round&)>& go_on, const ProgressCallback& progress)
{
    const Preparation preparation = prepare(scene, options);
    SolveOptions round_options = options;
    round_options.lines = first_lines;
    std::uint64_t lines_before = 0;
    for (std::uint64_t round = 0;; ++round) {
        Solution solution = solve_round(scene, preparation, round_options, replicates, round, progress);
        solution.all_lines += lines_before;
        lines_before = solution.all_lines;
        if (!go_on({round_options.lines, *solution.relative_standard_error}))
            return solution;
        round_options.lines *= 2;
    }
}

} // namespace multipath

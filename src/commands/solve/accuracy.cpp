#include "commands/solve/accuracy.h"

#include "base/errors.h"
#include "cli/options/number_text.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace multipath {

namespace {

constexpr int replicates_of_rounds = 4; ///< default with --tolerance or --time, which need an estimate of the error
constexpr std::uint64_t first_round_lines = 1u << 16;
constexpr double share_of_patches = 0.9; // of the tolerance

} // namespace

double Accuracy::patch_tolerance() const
{
    return share_of_patches * tolerance.value_or(0.0);
}

double Accuracy::noise_tolerance() const
{
    const double patches = std::min(patch_error.value_or(0.0), patch_tolerance());
    return std::sqrt(*tolerance * *tolerance - patches * patches);
}

std::uint64_t RoundLimit::next_lines(const Round& round, double seconds)
{
    constexpr std::uint64_t most_growth = 16;
    const double last_round = seconds - round_start_;
    round_start_ = seconds;
    std::uint64_t growth = 2;
    if (accuracy_.tolerance) {
        const double excess = round.relative_standard_error / accuracy_.noise_tolerance();
        if (round.lines >= least_lines_ && excess <= 1.0)
            return 0;
        const auto lines = static_cast<double>(round.lines);
        const double needed = std::max(excess * excess * lines, static_cast<double>(least_lines_));
        while (growth < most_growth && static_cast<double>(growth) * lines < needed)
            growth *= 2;
    }
    const auto is_too_much = [&] {
        return (accuracy_.seconds && seconds + static_cast<double>(growth) * last_round > *accuracy_.seconds) ||
               (accuracy_.most_lines && growth * round.lines > *accuracy_.most_lines);
    };
    while (growth > 1 && is_too_much())
        growth /= 2;
    return growth > 1 ? growth * round.lines : 0;
}

OptionGroup accuracy_option_group()
{
    return {
        "Accuracy",
        {{"adaptive", 0, "N", "",
          "Cut patches where the light changes most, until there are N: the default without --patch-size and "
          "--patches."},
         {"replicates", 0, "R", "1",
          "Solve R times with independent randomisations of the sequence, each with its part of the lines; estimates "
          "the standard error of every patch and of the whole."},
         {"tolerance", 0, "SHARE", "",
          "Cut patches, unless options fix them, and add lines, at most to --lines, until the root of the "
          "relative mean square error is at most this, such as 1%. Takes 4 replicates by default.",
          false, any_text, true},
         {"time", 0, "TIME", "", "Double the lines for as long as this allows, such as 30s, otherwise as --tolerance.",
          false, any_text, true}}};
}

Accuracy read_accuracy(const CommandLine& line)
{
    Accuracy accuracy;
    if (line.has("tolerance")) {
        accuracy.tolerance = read_share("--tolerance", line.text("tolerance"));
        if (!(*accuracy.tolerance > 0.0))
            throw UsageError("--tolerance: an error of 0 is never reached; expected more, such as 1%");
    }
    if (line.has("time"))
        accuracy.seconds = read_seconds("--time", line.text("time"));
    if (accuracy.in_rounds() && line.has("lines") && line.text("lines") != "auto")
        accuracy.most_lines = read_count("--lines", line.text("lines"), 1);
    accuracy.replicates = accuracy.in_rounds() && !line.has("replicates")
                              ? replicates_of_rounds
                              : static_cast<int>(read_count("--replicates", line.text("replicates"), 1, 10000));
    if (accuracy.in_rounds() && accuracy.replicates < 2)
        throw UsageError("--replicates: --tolerance and --time need at least 2 to estimate the error; expected more");
    return accuracy;
}

Solution solve_accurately(const Scene& scene, const SolveOptions& options, const Accuracy& accuracy,
                          const ProgressCallback& progress, Checkpoint* checkpoint, Shard shard)
{
    if (!accuracy.in_rounds())
        return solve_incrementally(scene, options, accuracy.replicates, progress, checkpoint, shard);
    RoundLimit limit(accuracy, lines_for_error_estimate(scene, options.method, accuracy.replicates));
    const std::uint64_t first = std::min(first_round_lines, accuracy.most_lines.value_or(first_round_lines));
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const auto next_lines = [&](const Round& round) {
        return limit.next_lines(round, std::chrono::duration<double>(Clock::now() - start).count());
    };
    return solve_in_rounds(scene, options, accuracy.replicates, first, next_lines, progress, checkpoint);
}

} // namespace multipath

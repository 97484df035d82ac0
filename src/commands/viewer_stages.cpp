#include "commands/viewer_stages.h"

#include "scene/input_error.h"

#include <algorithm>
#include <numeric>

namespace multipath {

namespace {

constexpr int first_power = 8;                ///< of two: the fewest lines
constexpr std::uint64_t most_values = 300000; ///< patches of all stages: some eleven bytes of the page each

/// Nothing where the method cannot work with so few lines.
std::vector<Rgb> radiosity_with(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
                                const ProgressCallback& progress)
{
    try {
        const Solution solution = solve(scene, preparation, options, progress);
        return mean(solution.balance.absorbed) > 0.0 ? solution.radiosity : std::vector<Rgb>{};
    } catch (const InputError&) {
        return {};
    }
}

} // namespace

std::vector<std::uint64_t> stage_lines(std::uint64_t lines, std::uint32_t patches)
{
    const std::uint64_t most = std::min<std::uint64_t>(most_values / patches, 20);
    if (most == 0)
        return {};
    for (int step = 2;; step += 2) {
        std::vector<std::uint64_t> result;
        for (int power = first_power; power < 64 && std::uint64_t{1} << power < lines; power += step)
            result.push_back(std::uint64_t{1} << power);
        if (result.size() <= most)
            return result;
    }
}

std::vector<ViewerStage> solve_stages(const Scene& scene, const SolveOptions& options,
                                      const std::vector<std::uint64_t>& lines, const ProgressCallback& progress)
{
    std::vector<ViewerStage> stages;
    if (lines.empty())
        return stages;
    const Preparation preparation = prepare(scene, options);
    const auto all = static_cast<double>(std::accumulate(lines.begin(), lines.end(), std::uint64_t{0}));
    double done = 0.0;
    for (const std::uint64_t count : lines) {
        SolveOptions fewer = options;
        fewer.lines = count;
        const double share = static_cast<double>(count) / all;
        std::vector<Rgb> radiosity =
            radiosity_with(scene, preparation, fewer, [&](double part) { progress(done + share * part); });
        done += share;
        if (!radiosity.empty())
            stages.push_back({count, std::move(radiosity)});
    }
    return stages;
}

} // namespace multipath

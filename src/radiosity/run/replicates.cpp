#include "radiosity/run/replicates.h"

#include "base/errors.h"
#include "base/lists.h"
#include "radiosity/reuse/denoising.h"
#include "radiosity/run/solution.h"
#include "radiosity/run/statistics.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace multipath {

namespace {

SolveOptions replicate_options(SolveOptions options, int replicates, std::uint64_t round, std::uint64_t number)
{
    const auto parts = static_cast<std::uint64_t>(replicates);
    options.sequence = randomised_name(options.sequence);
    options.lines = options.lines / parts + (number < options.lines % parts ? 1 : 0);
    options.denoise = false; // only the mean is: blocks chosen for each replicate would give all the same bias
    return independent_run(options, RandomStream::replicates, options.seed, (round << 32) + number, 0);
}

/// Gives the mean of the replicates standard errors.
void add_errors(const Scene& scene, const std::vector<MeanOf<Rgb>>& means, bool denoised, int threads,
                Solution& solution)
{
    solution.standard_error = mapped(means, &MeanOf<Rgb>::standard_error);
    if (denoised) {
        std::vector<Rgb> variance = mapped(solution.standard_error, [](Rgb error) { return error * error; });
        denoise(scene, threads, solution.radiosity, variance);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            solution.standard_error[i] = square_root(variance[i]);
    }
    solution.relative_standard_error =
        std::sqrt(expected_relative_square(scene.weights(), solution.radiosity, solution.standard_error));
}

/// The replicates of one round.
Solution solve_round(const Scene& scene, const Preparation& preparation, const SolveOptions& options, int replicates,
                     std::uint64_t round, const ProgressCallback& progress, Checkpoint* checkpoint)
{
    if (options.lines < static_cast<std::uint64_t>(replicates))
        throw SettingsError(std::to_string(replicates) + " replicates need as many lines; expected more lines");
    std::uint64_t finished = 0;
    std::vector<MeanOf<Rgb>> means(scene.patch_count()); // radiosity of each patch
    Solution sum; // over the finished replicates, each divided by their planned number
    sum.radiosity.resize(scene.patch_count());
    sum.unshot.resize(scene.patch_count());
    const Checkpoint::Part part(checkpoint, "replicates", [&](Archive& archive) {
        archive.value<std::uint64_t>("finished", finished);
        archive.list<double>("means", means);
        sum.visit(archive, scene.patch_count());
    });
    while (finished < static_cast<std::uint64_t>(replicates)) {
        const auto show = [&](double done) {
            progress((static_cast<double>(finished) + done) / static_cast<double>(replicates));
        };
        const SolveOptions of_one = replicate_options(options, replicates, round, finished);
        Solution one = solve(scene, preparation, of_one, show, checkpoint);
        if (checkpoint && checkpoint->stopped()) {
            if (finished == 0)
                return one;
            break;
        }
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            means[i].add(one.radiosity[i]);
        add(one, 1.0 / replicates, sum);
        if (finished++ == 0)
            sum.shot_passes = one.shot_passes;
    }
    Solution solution = sum;
    if (finished < static_cast<std::uint64_t>(replicates)) {
        const double scale = static_cast<double>(replicates) / static_cast<double>(finished);
        solution.balance = {};
        add(sum.balance, scale, solution.balance);
        for (Rgb& unshot : solution.unshot)
            unshot = scale * unshot;
    }
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        solution.radiosity[i] = means[i].mean();
    solution.replicates = static_cast<int>(finished);
    if (finished > 1)
        add_errors(scene, means, options.denoise && preparation.lights, options.threads, solution);
    return solution;
}

/// Prepares for the lines of a single replicate, which are few: a table that pays for all lines may not pay for these.
Preparation prepare_replicates(const Scene& scene, SolveOptions options, std::uint64_t lines, int replicates)
{
    options.lines = lines / static_cast<std::uint64_t>(replicates);
    return prepare(scene, options);
}

} // namespace

SolveOptions independent_run(SolveOptions options, RandomStream stream, std::uint64_t seed, std::uint64_t number,
                             std::uint64_t items)
{
    options.seed = random_bits(random_key(stream, seed), number);
    if (!is_randomised(options.sequence))
        options.skip += number * items;
    return options;
}

std::uint64_t lines_for_error_estimate(const Scene& scene, Method method, int replicates)
{
    const std::uint64_t lines_per_patch = method->lines_per_patch ? method->lines_per_patch(scene) : 0;
    return lines_per_patch * scene.patch_count() * static_cast<std::uint64_t>(replicates);
}

Solution solve_replicates(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
                          int replicates, const ProgressCallback& progress, Checkpoint* checkpoint)
{
    return solve_round(scene, preparation, options, replicates, 0, progress, checkpoint);
}

Solution solve_in_rounds(const Scene& scene, const SolveOptions& options, int replicates, std::uint64_t first_lines,
                         const std::function<std::uint64_t(const Round&)>& next_lines, const ProgressCallback& progress,
                         Checkpoint* checkpoint)
{
    const Preparation preparation = prepare_replicates(scene, options, first_lines, replicates);
    RunRecord record;
    const Checkpoint::Part part(checkpoint, RunRecord::part,
                                [&](Archive& archive) { record.visit(archive, scene.patch_count()); });
    for (;;) {
        if (record.goal == 0)
            record.goal =
                record.pieces == 0 ? first_lines : next_lines({record.lines, *record.solution.relative_standard_error});
        if (record.goal == 0)
            break;
        SolveOptions round_options = options;
        round_options.lines = record.goal;
        Solution solution =
            solve_round(scene, preparation, round_options, replicates, record.pieces, progress, checkpoint);
        if (checkpoint && checkpoint->stopped())
            return record.pieces > 0 ? record.solution : solution;
        solution.all_lines += record.solution.all_lines;
        record.finish_piece(std::move(solution));
    }
    if (checkpoint)
        checkpoint->finish();
    return record.solution;
}

namespace {

/// Options for the lines begin ... end - 1 of the run, with items and random numbers that no other lines use.
SolveOptions stretch_options(const Scene& scene, const SolveOptions& options, std::uint64_t number, std::uint64_t begin,
                             std::uint64_t end)
{
    SolveOptions stretch = options;
    stretch.lines = end - begin;
    stretch.skip += begin == 0 ? 0 : GlobalLines(scene.bounds(), chords_of(options)).lines_to_cast(begin);
    if (number > 0)
        stretch.seed = random_bits(random_key(RandomStream::stretches, options.seed), number);
    return stretch;
}

} // namespace

Solution solve_incrementally(const Scene& scene, const SolveOptions& options, int replicates,
                             const ProgressCallback& progress, Checkpoint* checkpoint, Shard shard)
{
    if (shard.of > 1 && replicates > 1)
        throw std::invalid_argument("replicates have no shards");
    const bool averaged = options.method->shards == Shards::averaged;
    const Preparation preparation = prepare_replicates(scene, options, options.lines, replicates);
    RunRecord record;
    const Checkpoint::Part part(checkpoint, RunRecord::part,
                                [&](Archive& archive) { record.visit(archive, scene.patch_count()); });
    if (record.lines > options.lines || record.goal > options.lines)
        throw InputError("the run has " + std::to_string(std::max(record.lines, record.goal)) +
                         " lines already; expected no fewer");
    while (record.lines < options.lines) {
        if (record.goal == 0)
            record.goal = options.lines;
        const SolveOptions stretch =
            shard.of > 1 && averaged
                ? stretch_options(scene, options, shard.number, shard.begin(record.goal), shard.end(record.goal))
                : stretch_options(scene, options, record.pieces, record.lines, record.goal);
        Solution found = replicates > 1
                             ? solve_replicates(scene, preparation, stretch, replicates, progress, checkpoint)
                             : solve(scene, preparation, stretch, progress, checkpoint, averaged ? Shard{} : shard);
        if (checkpoint && checkpoint->stopped())
            return record.pieces > 0 ? record.solution : found;
        record.finish_piece(record.pieces > 0 ? combined(scene, {record.solution, found}) : std::move(found));
    }
    if (checkpoint)
        checkpoint->finish();
    return record.solution;
}

} // namespace multipath

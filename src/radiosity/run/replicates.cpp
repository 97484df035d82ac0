#include "radiosity/run/replicates.h"

#include "base/errors.h"
#include "radiosity/reuse/denoising.h"
#include "radiosity/run/solution.h"
#include "radiosity/run/statistics.h"
#include "sampling/random.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace multipath {

namespace {

/// The replicates of one round, with the result of those that are finished.
class ReplicateRun
{
public:
    ReplicateRun(const Scene& scene, const SolveOptions& options, int replicates, std::uint64_t round)
        : scene_(scene), options_(options), replicates_(replicates), round_(round), means_(scene.patch_count())
    {
        if (options.lines < static_cast<std::uint64_t>(replicates))
            throw SettingsError(std::to_string(replicates) + " replicates need as many lines; expected more lines");
        sum_.radiosity.resize(scene.patch_count());
        sum_.unshot.resize(scene.patch_count());
    }

    Solution solve_all(const Preparation& preparation, const ProgressCallback& progress, Checkpoint* checkpoint)
    {
        const Checkpoint::Part part(checkpoint, "replicates", [this](Archive& archive) { visit(archive); });
        while (finished_ < static_cast<std::uint64_t>(replicates_)) {
            const auto show = [&](double done) {
                progress((static_cast<double>(finished_) + done) / static_cast<double>(replicates_));
            };
            Solution one = solve(scene_, preparation, options_of(finished_), show, checkpoint);
            if (checkpoint && checkpoint->stopped()) {
                if (finished_ == 0)
                    return one;
                break;
            }
            add_one(one);
        }
        return result(options_.denoise && preparation.lights);
    }

private:
    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("finished", finished_);
        archive.list<double>("means", means_);
        sum_.visit(archive, scene_.patch_count());
    }

    SolveOptions options_of(std::uint64_t replicate) const
    {
        const auto parts = static_cast<std::uint64_t>(replicates_);
        SolveOptions options = options_;
        options.sequence = randomised_name(options_.sequence);
        options.lines = options_.lines / parts + (replicate < options_.lines % parts ? 1 : 0);
        options.denoise =
            false; // only the mean is denoised: blocks chosen for each replicate would give all the same bias
        return independent_run(options, RandomStream::replicates, options_.seed, (round_ << 32) + replicate, 0);
    }

    void add_one(const Solution& one)
    {
        for (std::uint32_t i = 0; i < scene_.patch_count(); ++i)
            means_[i].add(one.radiosity[i]);
        add(one, 1.0 / replicates_, sum_);
        if (finished_ == 0)
            sum_.shot_passes = one.shot_passes;
        ++finished_;
    }

    Solution result(bool denoised) const
    {
        Solution solution = sum_;
        if (finished_ < static_cast<std::uint64_t>(replicates_)) {
            const double scale = static_cast<double>(replicates_) / static_cast<double>(finished_);
            solution.balance = {};
            add(sum_.balance, scale, solution.balance);
            for (Rgb& unshot : solution.unshot)
                unshot = scale * unshot;
        }
        for (std::uint32_t i = 0; i < scene_.patch_count(); ++i)
            solution.radiosity[i] = means_[i].mean();
        solution.replicates = static_cast<int>(finished_);
        if (finished_ > 1) {
            for (const MeanOf<Rgb>& patch : means_)
                solution.standard_error.push_back(patch.standard_error());
            if (denoised)
                denoise_mean(solution);
            solution.relative_standard_error =
                std::sqrt(expected_relative_square(scene_.weights(), solution.radiosity, solution.standard_error));
        }
        return solution;
    }

    void denoise_mean(Solution& solution) const
    {
        std::vector<Rgb> variance = vector_with_capacity<Rgb>(scene_.patch_count());
        for (const Rgb& error : solution.standard_error)
            variance.push_back(error * error);
        denoise(scene_, options_.threads, solution.radiosity, variance);
        for (std::uint32_t i = 0; i < scene_.patch_count(); ++i)
            solution.standard_error[i] = square_root(variance[i]);
    }

    const Scene& scene_;
    const SolveOptions& options_;
    int replicates_;
    std::uint64_t round_;
    std::uint64_t finished_ = 0;
    std::vector<MeanOf<Rgb>> means_; ///< radiosity of each patch
    Solution sum_; ///< over the finished replicates, each divided by their planned number; radiosity and its errors are
                   ///< in means_
};

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
    return method->lines_per_patch(scene) * scene.patch_count() * static_cast<std::uint64_t>(replicates);
}

Solution solve_replicates(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
                          int replicates, const ProgressCallback& progress, Checkpoint* checkpoint)
{
    return ReplicateRun(scene, options, replicates, 0).solve_all(preparation, progress, checkpoint);
}

Solution solve_in_rounds(const Scene& scene, const SolveOptions& options, int replicates, std::uint64_t first_lines,
                         const std::function<bool(const Round&)>& go_on, const ProgressCallback& progress,
                         Checkpoint* checkpoint)
{
    const Preparation preparation = prepare_replicates(scene, options, first_lines, replicates);
    RunRecord record;
    const Checkpoint::Part part(checkpoint, RunRecord::part,
                                [&](Archive& archive) { record.visit(archive, scene.patch_count()); });
    const auto finished = [&] {
        return record.pieces > 0 && !go_on({record.lines, *record.solution.relative_standard_error});
    };
    while (record.goal > 0 || !finished()) {
        if (record.goal == 0)
            record.goal = record.pieces == 0 ? first_lines : 2 * record.lines;
        SolveOptions round_options = options;
        round_options.lines = record.goal;
        Solution solution =
            ReplicateRun(scene, round_options, replicates, record.pieces).solve_all(preparation, progress, checkpoint);
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

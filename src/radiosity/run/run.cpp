#include "radiosity/run/run.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "radiosity/paper/line_budget.h"
#include "radiosity/paper/multipath.h"
#include "radiosity/reuse/denoising.h"
#include "radiosity/reuse/exchange_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace multipath {

namespace {

/// Final check of a result: the balance closes, all numbers are finite, no patch is darker than it emits, and the
/// emitted power is that of the sources, to the accuracy of the linear systems, if no line used a forecast. Throws
/// NoSolution otherwise.
void require_sound(const Scene& scene, const Solution& solution)
{
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (const Rgb b = solution.radiosity[i]; !std::isfinite(b.r + b.g + b.b) || !at_most(scene.emittance(i), b))
            throw NoSolution(scene.path() +
                             ": the equations of the light have no sound solution with these lines; expected more");
    const PowerBalance& balance = solution.balance;
    if (!(balance.relative_error() <= 1e-9))
        throw NoSolution(scene.path() + ": the power balance does not close with these lines; expected more");
    const Rgb difference = balance.emitted - balance.source;
    const double largest = std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
    const double source = std::max({balance.source.r, balance.source.g, balance.source.b});
    if (balance.emitted_error == 0.0 && !(largest <= 1e-4 * source))
        throw NoSolution(scene.path() + format(": these lines distribute %.6g W of the %.6g W that the sources emit; "
                                               "expected more lines",
                                               mean(balance.emitted), mean(balance.source)));
}

/// Throws SettingsError if the sequence has fewer items than this after the skipped ones.
void require_items(const Sequence& sequence, std::uint64_t skip, std::uint64_t needed)
{
    const std::uint64_t limit = sequence.item_limit();
    if (skip > limit || needed > limit - skip)
        throw SettingsError("the sequence " + sequence.name() + " ends after " + std::to_string(limit) +
                            " items, but these lines need " + std::to_string(needed) +
                            (skip > 0 ? " after those skipped" : ""));
}

std::uint64_t checked_first_item(const Sequence& sequence, const SolveOptions& options, const GlobalLines& lines)
{
    constexpr std::uint64_t most_counted = 0xffffffffu; // counts have 32 bits
    if (options.method->shards == Shards::added && options.lines > most_counted)
        throw SettingsError("the method " + std::string(options.method->name) + " counts at most " +
                            std::to_string(most_counted) + " lines; expected fewer");
    // Checks for as many items as any split of the lines may need, so that a short sequence is refused before the work.
    require_items(sequence, options.skip, lines.lines_to_cast(options.lines));
    return options.skip;
}

} // namespace

Run::Run(const Scene& scene_of_run, const SolveOptions& options_of_run, const Preparation& preparation_of_run,
         const ProgressCallback& progress, Checkpoint* checkpoint, Shard shard_of_run)
    : scene(scene_of_run),
      options(options_of_run),
      preparation(preparation_of_run),
      shard(shard_of_run),
      sequence(make_line_sequence(options.sequence, options.seed, options.pairing)),
      lines(scene.bounds(), chords_of(options)),
      first_item(checked_first_item(*sequence, options, lines)),
      state(scene),
      progress_(progress),
      checkpoint_(checkpoint)
{
}

Solution Run::solve()
{
    const Stages& stages = options.method->stages;
    const Checkpoint::Part part(checkpoint_, "run", [this](Archive& archive) { visit(archive); });
    while (stages_done_ < stages.size() && !stopped()) {
        local_lines_before_ = solution.local_lines;
        if (stages[stages_done_])
            stages[stages_done_](*this);
        stages_done_ += stopped() ? 0 : 1;
    }
    return finish();
}

void Run::visit(Archive& archive)
{
    archive.value<std::uint64_t>("stages done", stages_done_);
    archive.value<double>("lines done", done_);
    archive.value<std::uint64_t>("local lines", local_lines_before_);
    multipath::visit(archive, solution.shot_passes);
    state.visit(archive);
    archive.growing_list<double>("variance", variance);
    if (archive.reads())
        solution.local_lines = local_lines_before_;
}

std::uint64_t Run::local_share(double usual_ratio) const
{
    return local_line_count(options.lines, options.ratio.value_or(usual_ratio));
}

std::uint64_t Run::lines_left() const
{
    return options.lines - std::min(options.lines, solution.local_lines);
}

void Run::plan_global_lines()
{
    solution.global_lines = lines_left();
    solution.global_lines_cast = lines.lines_to_cast(solution.global_lines);
    require_items(*sequence, first_item, solution.local_lines + solution.global_lines_cast);
}

void Run::note_cast(std::uint64_t cast)
{
    if (cast == solution.global_lines_cast)
        return;
    const double share = static_cast<double>(cast) / static_cast<double>(solution.global_lines_cast);
    solution.global_lines = static_cast<std::uint64_t>(share * static_cast<double>(solution.global_lines));
    solution.global_lines_cast = cast;
}

RunControl Run::control(std::uint64_t lines_to_come, std::uint64_t charged, Shard of_shards)
{
    const double charge = static_cast<double>(charged) / static_cast<double>(std::max<std::uint64_t>(1, lines_to_come));
    const auto count = [this, charge](std::uint64_t counted) {
        done_ += charge * static_cast<double>(counted);
        if (progress_)
            progress_(std::min(1.0, done_ / static_cast<double>(options.lines)));
    };
    return {options.threads, count, checkpoint_, of_shards};
}

/// Distributes the unshot power of a run that was stopped before its first global line: a few lines suffice to show
/// where this light goes.
void Run::send_the_rest()
{
    const GlobalPass pass{0, std::min<std::uint64_t>(options.lines, 1u << 18), options.bidirectional};
    const std::unique_ptr<Sequence> random = make_line_sequence("random", ~options.seed, options.pairing);
    solution.global_lines = solution.global_lines_cast =
        cast_global_lines(scene, lines, *random, pass, {options.threads}, state);
}

Solution Run::finish()
{
    if (stopped()) // fewer rays than planned were cast, too
        solution.local_lines =
            static_cast<std::uint64_t>(done_) - std::min(static_cast<std::uint64_t>(done_), solution.global_lines);
    if (stopped() && shard.of == 1 && solution.global_lines_cast == 0 && !solved)
        send_the_rest();
    remove_negative_light(scene, state);
    solution.balance = power_balance(scene, state);
    solution.radiosity = radiosity(scene, state);
    if (options.denoise && variance.size() == scene.patch_count())
        denoise(scene, options.threads, solution.radiosity, variance);
    solution.unshot = unshot_radiosity(scene, state);
    solution.all_lines = solution.local_lines + solution.global_lines;
    if (!stopped())
        require_sound(scene, solution);
    return std::move(solution);
}

} // namespace multipath

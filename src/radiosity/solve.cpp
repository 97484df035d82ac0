#include "radiosity/solve.h"

#include "radiosity/first_stage.h"
#include "radiosity/line_budget.h"
#include "radiosity/memory_estimate.h"
#include "radiosity/multipath.h"
#include "radiosity/reuse/counted_reuse.h"
#include "radiosity/reuse/exchange_solver.h"
#include "radiosity/reuse/gathered_light.h"
#include "radiosity/reuse/line_reuse.h"
#include "radiosity/solve_options.h"
#include "radiosity/trapped_light.h"
#include "scene/input_error.h"
#include "scene/text_format.h"
#include "transport/depth_complexity.h"
#include "transport/exchange/unoccluded_exchange.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace multipath {

namespace {

/// `reuse` counts lines in 32 bits.
void require_countable(const SolveOptions& options)
{
    if (options.method == Method::reuse && options.lines > 0xffffffffu)
        throw SettingsError("the method reuse counts at most 4294967295 lines; expected fewer");
}

std::string text_of(double power)
{
    return format("%.6g", power);
}

void require_balance(const PowerBalance& balance)
{
    if (!(balance.relative_error() <= 1e-9))
        throw std::logic_error("the power balance does not close: the program has an error");
}

/// The last check before a result leaves the solver: all numbers are finite, no patch is darker than it emits, and
/// where no line needs a forecast the light sent is that of the sources.
void require_sound(const Scene& scene, const Solution& solution)
{
    const auto at_least = [](Rgb b, Rgb e) {
        const auto channel = [](double x, double least) { return std::isfinite(x) && x >= least; };
        return channel(b.r, e.r) && channel(b.g, e.g) && channel(b.b, e.b);
    };
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (!at_least(solution.radiosity[i], scene.emittance(i)))
            throw InputError(scene.path() + ": the equations of the light have no sound solution with these lines; "
                                            "expected more --lines, or --method local");
    const PowerBalance& balance = solution.balance;
    const Rgb difference = balance.emitted - balance.source;
    const double largest = std::max({std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
    const double source = std::max({balance.source.r, balance.source.g, balance.source.b});
    if (balance.emitted_error == 0.0 && !(largest <= 1e-6 * source))
        throw InputError(scene.path() + ": these lines distribute " + text_of(mean(balance.emitted)) + " W of the " +
                         text_of(mean(balance.source)) + " W that the sources emit; expected more --lines");
}

/// One run: what it works with and what it has found so far.
class Run
{
public:
    Run(const Scene& scene, const SolveOptions& options, const Preparation& preparation,
        const ProgressCallback& progress, Checkpoint* checkpoint, Share share)
        : scene_(scene),
          options_(options),
          preparation_(preparation),
          progress_(progress),
          checkpoint_(checkpoint),
          share_(share),
          sequence_(make_line_sequence(options.sequence, options.seed, options.pairing)),
          lines_(scene.bounds(), chords_of(options)),
          state_(scene)
    {
        // More items than any split of the lines needs: a sequence that is too short is refused before the work.
        first_item_ = plan_items(*sequence_, options.skip, 0, lines_.lines_to_cast(options.lines)).first_shot;
    }

    Solution solve()
    {
        const std::vector<Stage> stages = stages_of(options_.method);
        const Checkpoint::Part part(checkpoint_, "run", [this](Archive& archive) { visit(archive); });
        while (stages_done_ < stages.size() && !stopped()) {
            local_lines_before_ = solution_.local_lines;
            (this->*stages[stages_done_])();
            stages_done_ += stopped() ? 0 : 1;
        }
        return finish();
    }

private:
    using Stage = void (Run::*)();

    std::vector<Stage> stages_of(Method method) const
    {
        if (method == Method::local)
            return {&Run::particles};
        if (method != Method::reuse)
            return {&Run::shots, &Run::global_pass};
        if (preparation_.unoccluded)
            return {&Run::shots, &Run::reuse};
        if (!gathers())
            return {&Run::shots, &Run::reuse_counts};
        if (!few_lines_gather_enough())
            return {&Run::particles};
        return {&Run::gather, &Run::shoot_what_stands_out, &Run::reuse_counts};
    }

    /// Lines that are too few to be counted are spent on gathering only if most of the light is gathered by them, and
    /// not shot: particles do that as well.
    bool few_lines_gather_enough() const
    {
        const std::uint64_t rays = local_share(0.25);
        const std::uint64_t surely_left = (options_.lines - rays) / 2; // what stands out is shot with the other half
        return can_count(scene_, lines_, lines_.lines_to_cast(surely_left), counts_limit()) ||
               gathered_share(scene_, rays) > 0.5;
    }

    /// [bytes]
    std::size_t counts_limit() const
    {
        return count_bytes(scene_.patch_count(), bytes_for_pairs(options_.memory, scene_));
    }

    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("stages done", stages_done_);
        archive.value<double>("lines done", done_);
        archive.value<std::uint64_t>("local lines", local_lines_before_);
        archive.value<std::uint64_t>("lines to shoot", lines_to_shoot_);
        multipath::visit(archive, solution_.shot_passes);
        state_.visit(archive);
        if (archive.reads())
            solution_.local_lines = local_lines_before_;
    }

    /// All power that is not sent yet, by all lines that are left.
    void particles()
    {
        const LocalOptions local{lines_left(), options_.estimator, first_item_ + solution_.local_lines, options_.seed};
        solution_.local_lines += cast_particles(scene_, *sequence_, local, control(1, 1), state_); // (L1)
    }

    void shots()
    {
        solution_.shot_passes = shoot_first(scene_, *sequence_, first_item_, options_, control(1, 1), state_);
        count_shots();
    }

    void count_shots()
    {
        for (const ShotPass& pass : solution_.shot_passes)
            solution_.local_lines += pass.lines;
    }

    void global_pass()
    {
        plan_global_lines();
        const GlobalPass pass{first_global_item(), solution_.global_lines_cast, options_.bidirectional};
        const ShuffledOrder items = walking_order(*sequence_, options_.line_order, pass.first_item, pass.lines_cast);
        const std::uint64_t cast =
            cast_global_lines(scene_, lines_, items, pass, control(pass.lines_cast, solution_.global_lines),
                              state_); // (M1) (M2)
        note_cast(cast);
    }

    /// With a table of all pairs.
    void reuse()
    {
        const std::uint64_t rays = gathers() ? std::min(local_share(1.0), options_.lines - 1) : 0;
        const std::uint64_t first_ray = first_item_ + solution_.local_lines;
        solution_.local_lines += rays;
        plan_global_lines();
        const ReusedLines plan{first_global_item(), solution_.global_lines_cast, first_ray, rays, options_.seed};
        const std::uint64_t cast =
            reuse_lines(scene_, *preparation_.unoccluded, lines_, *sequence_, plan,
                        control(plan.cast + rays, solution_.global_lines + rays, share_), state_); // (R1)
        note_cast(cast);
    }

    void gather()
    {
        const GatheredLight light =
            gather_direct_light(scene_, *sequence_, first_item_, local_share(0.25), control(1, 1));
        receive(light, scene_, state_);
        solution_.local_lines += light.lines;
    }

    /// Without one. Too few lines for equations become particles.
    void reuse_counts()
    {
        plan_global_lines();
        const std::size_t bytes = counts_limit();
        if (!can_count(scene_, lines_, solution_.global_lines_cast, bytes)) {
            if (share_.of > 1)
                throw SettingsError(scene_.path() + ": so few lines per patch are not reused, and cannot be shared; "
                                                    "expected more --lines, more --memory, or no --shard");
            solution_.global_lines = solution_.global_lines_cast = 0;
            particles();
            return;
        }
        const std::uint64_t cast =
            reuse_counted_lines(scene_, lines_, *sequence_, first_global_item(), solution_.global_lines_cast, bytes,
                                control(solution_.global_lines_cast, solution_.global_lines, share_), state_); // (R1)
        note_cast(cast);
    }

    /// The run was stopped before any global line: few of them show where the light goes that was not sent yet.
    void send_the_rest()
    {
        const GlobalPass pass{0, std::min<std::uint64_t>(options_.lines, 1u << 18), options_.bidirectional};
        const std::unique_ptr<Sequence> random = make_line_sequence("random", ~options_.seed, options_.pairing);
        solution_.global_lines = solution_.global_lines_cast =
            cast_global_lines(scene_, lines_, *random, pass, {options_.threads}, state_);
    }

    Solution finish()
    {
        if (stopped()) // fewer rays than planned, too
            solution_.local_lines =
                static_cast<std::uint64_t>(done_) - std::min(static_cast<std::uint64_t>(done_), solution_.global_lines);
        if (stopped() && share_.of == 1 && solution_.global_lines_cast == 0)
            send_the_rest();
        if (options_.method == Method::reuse)
            remove_negative_light(scene_, state_);
        solution_.balance = power_balance(scene_, state_);
        require_balance(solution_.balance);
        solution_.radiosity = radiosity(scene_, state_);
        solution_.unshot = unshot_radiosity(scene_, state_);
        solution_.all_lines = solution_.local_lines + solution_.global_lines;
        if (!stopped())
            require_sound(scene_, solution_);
        return std::move(solution_);
    }

    bool stopped() const { return checkpoint_ && checkpoint_->stopped(); }
    bool gathers() const { return options_.direct == Direct::gather; }

    /// The user's ratio of local to global lines, or the usual one.
    std::uint64_t local_share(double usual_ratio) const
    {
        return split_lines(options_.lines, options_.ratio.value_or(usual_ratio)).local_lines;
    }

    void shoot_what_stands_out()
    {
        if (lines_to_shoot_ == undecided)
            lines_to_shoot_ = lines_for_what_stands_out(scene_, options_, state_, lines_left());
        if (lines_to_shoot_ == 0)
            return;
        ExtendedShotOptions shot = extended_shot(scene_, options_);
        shot.lines = lines_to_shoot_;
        solution_.shot_passes = shoot_extended(scene_, *sequence_, first_item_ + solution_.local_lines, shot,
                                               control(1, 1), state_); // (S2)
        count_shots();
    }

    std::uint64_t lines_left() const { return options_.lines - std::min(options_.lines, solution_.local_lines); }

    /// The global lines get what is left, also what a first shot had no use for.
    void plan_global_lines()
    {
        solution_.global_lines = lines_left();
        solution_.global_lines_cast = lines_.lines_to_cast(solution_.global_lines);
    }

    std::uint64_t first_global_item() const
    {
        return plan_items(*sequence_, options_.skip, solution_.local_lines, solution_.global_lines_cast).global_pass;
    }

    /// Where the run was stopped, fewer lines were cast than planned.
    void note_cast(std::uint64_t cast)
    {
        if (cast == solution_.global_lines_cast)
            return;
        const double share = static_cast<double>(cast) / static_cast<double>(solution_.global_lines_cast);
        solution_.global_lines = static_cast<std::uint64_t>(share * static_cast<double>(solution_.global_lines));
        solution_.global_lines_cast = cast;
    }

    /// For `lines` lines to come, which are charged as so many of the budget (N1).
    RunControl control(std::uint64_t lines, std::uint64_t charged, Share share = {})
    {
        const double charge = static_cast<double>(charged) / static_cast<double>(std::max<std::uint64_t>(1, lines));
        const auto count = [this, charge](std::uint64_t counted) {
            done_ += charge * static_cast<double>(counted);
            progress_(std::min(1.0, done_ / static_cast<double>(options_.lines)));
        };
        return {options_.threads, count, checkpoint_, share};
    }

    const Scene& scene_;
    const SolveOptions& options_;
    const Preparation& preparation_;
    const ProgressCallback& progress_;
    Checkpoint* checkpoint_;
    Share share_;
    std::unique_ptr<Sequence> sequence_;
    GlobalLines lines_;
    std::uint64_t first_item_ = 0;
    static constexpr std::uint64_t undecided = ~std::uint64_t{0};
    std::uint64_t stages_done_ = 0;
    std::uint64_t local_lines_before_ = 0;     ///< N_l when the present stage began
    std::uint64_t lines_to_shoot_ = undecided; ///< see lines_for_what_stands_out
    PowerState state_;
    Solution solution_;
    double done_ = 0.0;
};

} // namespace

namespace {

/// A table of all pairs is kept where it fits, unless there are so many pairs along lines, which are all counted, or so
/// many faces on each other, of which each pair is tested for contact, that these are the work.
bool wants_table(const Scene& scene, const SolveOptions& options)
{
    constexpr double many_pairs = 4096.0;
    return reuse_bytes(scene) <= bytes_for_pairs(options.memory, scene) && affordable_patch_rays(scene) == 1.0 &&
           pairs_along_line(scene, GlobalLines(scene.bounds(), chords_of(options))) <= many_pairs;
}

} // namespace

Preparation prepare(const Scene& scene, const SolveOptions& options)
{
    require_absorption(scene);
    Preparation preparation;
    const bool optimum = options.method == Method::first_shot || options.method == Method::extended;
    if (optimum && !options.power_by_line)
        preparation.ratio = ratio_for(scene, options);
    if (options.method == Method::reuse && wants_table(scene, options))
        preparation.unoccluded = std::make_shared<const UnoccludedExchange>(scene, options.threads);
    return preparation;
}

Solution solve(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
               const ProgressCallback& progress, Checkpoint* checkpoint, Share share)
{
    SolveOptions prepared = options;
    if (preparation.ratio)
        prepared.ratio = preparation.ratio;
    require_countable(prepared);
    return Run(scene, prepared, preparation, progress, checkpoint, share).solve();
}

Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress)
{
    return solve(scene, prepare(scene, options), options, progress);
}

} // namespace multipath

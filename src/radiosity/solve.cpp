#include "radiosity/solve.h"

#include "radiosity/counted_reuse.h"
#include "radiosity/distribution.h"
#include "radiosity/first_stage.h"
#include "radiosity/gathered_light.h"
#include "radiosity/item_plan.h"
#include "radiosity/line_budget.h"
#include "radiosity/line_reuse.h"
#include "radiosity/multipath.h"
#include "scene/input_error.h"
#include "transport/line_sampling.h"
#include "transport/unoccluded_exchange.h"

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
        throw InputError("the method reuse counts at most 4294967295 lines; expected fewer");
}

void require_balance(const PowerBalance& balance)
{
    if (!(balance.relative_error() <= 1e-9))
        throw std::logic_error("the power balance does not close: the program has an error");
}

/// One run: what it works with and what it has found so far.
class Run
{
public:
    Run(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress)
        : scene_(scene),
          options_(options),
          progress_(progress),
          sequence_(make_line_sequence(options.sequence, options.seed, options.pairing)),
          lines_(scene.bounds(), chords_of(options)),
          state_(scene)
    {
        // More items than any split of the lines needs: a sequence that is too short is refused before the work.
        first_item_ = plan_items(*sequence_, options.skip, 0, lines_.lines_to_cast(options.lines)).first_shot;
    }

    void particles()
    {
        const LocalOptions local{options_.lines, options_.estimator, first_item_, options_.seed};
        solution_.local_lines =
            cast_particles(scene_, *sequence_, local, options_.threads, state_, counter(1, 1)); // (L1)
    }

    void shots()
    {
        solution_.shot_passes = shoot_first(scene_, *sequence_, first_item_, options_, state_, counter(1, 1));
        for (const ShotPass& pass : solution_.shot_passes)
            solution_.local_lines += pass.lines;
    }

    void global_pass()
    {
        plan_global_lines();
        const GlobalPass pass{first_global_item(), solution_.global_lines_cast, options_.bidirectional};
        const ShuffledOrder items = walking_order(*sequence_, options_.line_order, pass.first_item, pass.lines_cast);
        cast_global_lines(scene_, lines_, items, pass, options_.threads, state_,
                          counter(pass.lines_cast, solution_.global_lines)); // (M1) (M2)
    }

    /// With a table of all pairs.
    void reuse(const UnoccludedExchange& unoccluded)
    {
        const std::uint64_t rays = gathers() ? std::min(local_share(1.0), options_.lines - 1) : 0;
        const std::uint64_t first_ray = first_item_ + solution_.local_lines;
        solution_.local_lines += rays;
        plan_global_lines();
        const ReusedLines plan{first_global_item(), solution_.global_lines_cast, first_ray, rays, options_.seed};
        reuse_lines(scene_, unoccluded, lines_, *sequence_, plan, options_.threads, state_,
                    counter(plan.cast + rays, solution_.global_lines + rays)); // (R1)
    }

    /// Without one.
    void reuse_counts()
    {
        if (gathers()) {
            const GatheredLight light = gather_direct_light(scene_, *sequence_, first_item_, local_share(0.25),
                                                            options_.threads, counter(1, 1));
            receive(light);
            solution_.local_lines += light.lines;
            shoot_what_stands_out();
        }
        plan_global_lines();
        reuse_counted_lines(scene_, lines_, *sequence_, first_global_item(), solution_.global_lines_cast,
                            static_cast<std::size_t>(options_.memory), options_.threads, state_,
                            counter(solution_.global_lines_cast, solution_.global_lines)); // (R1)
    }

    Solution finish()
    {
        solution_.balance = power_balance(scene_, state_);
        require_balance(solution_.balance);
        solution_.radiosity = radiosity(scene_, state_);
        solution_.unshot = unshot_radiosity(scene_, state_);
        solution_.all_lines = solution_.local_lines + solution_.global_lines;
        return std::move(solution_);
    }

private:
    bool gathers() const { return options_.direct == Direct::gather; }

    /// The user's ratio of local to global lines, or the usual one.
    std::uint64_t local_share(double usual_ratio) const
    {
        return split_lines(options_.lines, options_.ratio.value_or(usual_ratio)).local_lines;
    }

    /// Where little is lit, and brightly, its light is better shot than left to global lines, which seldom come by. The
    /// more of the unshot power stands out above the threshold (4), the more lines it gets, up to half of what is left;
    /// where little does, shooting it with few lines would only add noise. The figures were found by trying.
    void shoot_what_stands_out()
    {
        ExtendedShotOptions shot;
        shot.threshold = options_.threshold.value_or(threshold_radiosity(scene_)); // (4)
        shot.most_steps = options_.most_steps;
        shot.seed = options_.seed;
        const double unshot = mean(power_balance(scene_, state_).unshot);
        const double share = unshot > 0.0 ? power_above(scene_, state_, shot.threshold) / unshot : 0.0;
        if (share < 0.2)
            return;
        const std::uint64_t left = options_.lines - std::min(options_.lines, solution_.local_lines);
        shot.lines = static_cast<std::uint64_t>(0.5 * std::sqrt(share) * static_cast<double>(left));
        solution_.shot_passes = shoot_extended(scene_, *sequence_, first_item_ + solution_.local_lines, shot,
                                               options_.threads, state_, counter(1, 1)); // (S2)
        for (const ShotPass& pass : solution_.shot_passes)
            solution_.local_lines += pass.lines;
    }

    /// The sources have sent all their light, and the patches have it.
    void receive(const GatheredLight& light)
    {
        for (std::uint32_t i = 0; i < scene_.patch_count(); ++i) {
            state_.incident[i] += light.incident[i];
            state_.unshot[i] = scene_.reflectance(i) * light.incident[i];
        }
        state_.escaped += light.escaped;
        state_.behind += light.behind;
    }

    /// The global lines get what is left, also what a first shot had no use for.
    void plan_global_lines()
    {
        solution_.global_lines = options_.lines - std::min(options_.lines, solution_.local_lines);
        solution_.global_lines_cast = lines_.lines_to_cast(solution_.global_lines);
    }

    std::uint64_t first_global_item() const
    {
        return plan_items(*sequence_, options_.skip, solution_.local_lines, solution_.global_lines_cast).global_pass;
    }

    /// For `lines` lines to come, which are charged as so many of the budget (N1).
    LineCounter counter(std::uint64_t lines, std::uint64_t charged)
    {
        const double charge = static_cast<double>(charged) / static_cast<double>(std::max<std::uint64_t>(1, lines));
        return [this, charge](std::uint64_t count) {
            done_ += charge * static_cast<double>(count);
            progress_(std::min(1.0, done_ / static_cast<double>(options_.lines)));
        };
    }

    const Scene& scene_;
    const SolveOptions& options_;
    const ProgressCallback& progress_;
    std::unique_ptr<Sequence> sequence_;
    GlobalLines lines_;
    std::uint64_t first_item_ = 0;
    PowerState state_;
    Solution solution_;
    double done_ = 0.0;
};

} // namespace

Preparation prepare(const Scene& scene, const SolveOptions& options)
{
    Preparation preparation;
    const bool optimum = options.method == Method::first_shot || options.method == Method::extended;
    if (optimum && !options.power_by_line)
        preparation.ratio = ratio_for(scene, options);
    if (options.method == Method::reuse && reuse_bytes(scene.patch_count()) <= options.memory)
        preparation.unoccluded = std::make_shared<const UnoccludedExchange>(scene, options.threads);
    return preparation;
}

Solution solve(const Scene& scene, const Preparation& preparation, const SolveOptions& options,
               const ProgressCallback& progress)
{
    SolveOptions prepared = options;
    if (preparation.ratio)
        prepared.ratio = preparation.ratio;
    require_countable(prepared);
    Run run(scene, prepared, progress);
    if (options.method == Method::local) {
        run.particles();
    } else {
        run.shots();
        if (options.method == Method::reuse && preparation.unoccluded)
            run.reuse(*preparation.unoccluded);
        else if (options.method == Method::reuse)
            run.reuse_counts();
        else
            run.global_pass();
    }
    return run.finish();
}

Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress)
{
    return solve(scene, prepare(scene, options), options, progress);
}

} // namespace multipath

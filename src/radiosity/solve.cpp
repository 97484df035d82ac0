#include "radiosity/solve.h"

#include "radiosity/first_stage.h"
#include "radiosity/item_plan.h"
#include "radiosity/multipath.h"
#include "transport/line_sampling.h"

#include <algorithm>
#include <stdexcept>

namespace multipath {

namespace {

void require_balance(const PowerBalance& balance)
{
    if (!(balance.relative_error() <= 1e-9))
        throw std::logic_error("the power balance does not close: the program has an error");
}

} // namespace

Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const GlobalLines lines(scene.bounds());
    // More items than any split of the lines needs: a sequence that is too short is refused before the work.
    const ItemPlan all_items = plan_items(*sequence, options.skip, 0, lines.lines_to_cast(options.lines));

    PowerState state(scene);
    Solution solution;
    double charged = 0.0; // lines of the budget used so far
    double charge = 1.0;  // of each line counted
    const LineCounter count_lines = [&](std::uint64_t count) {
        charged += charge * static_cast<double>(count);
        progress(std::min(1.0, charged / static_cast<double>(options.lines)));
    };
    if (options.method == Method::local) {
        const LocalOptions local{options.lines, options.estimator, all_items.first_shot, options.seed};
        solution.local_lines = cast_particles(scene, *sequence, local, options.threads, state, count_lines); // (L1)
    } else {
        solution.shot_passes = shoot_first(scene, *sequence, all_items.first_shot, options, state, count_lines);
        for (const ShotPass& pass : solution.shot_passes)
            solution.local_lines += pass.lines;
        // The global lines get what is left, also what a first shot had no use for.
        solution.global_lines = options.lines - std::min(options.lines, solution.local_lines);
        solution.global_lines_cast = lines.lines_to_cast(solution.global_lines);
        charge = static_cast<double>(solution.global_lines) /
                 static_cast<double>(std::max<std::uint64_t>(1, solution.global_lines_cast)); // (N1)
        const ItemPlan items = plan_items(*sequence, options.skip, solution.local_lines, solution.global_lines_cast);
        const GlobalPass pass{items.global_pass, solution.global_lines_cast, options.bidirectional};
        cast_global_lines(scene, lines, *sequence, pass, options.threads, state, count_lines); // (M1) (M2)
    }
    solution.balance = power_balance(scene, state);
    require_balance(solution.balance);
    solution.radiosity = radiosity(scene, state);
    return solution;
}

} // namespace multipath

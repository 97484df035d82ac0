#include "radiosity/solve.h"

#include "radiosity/direct_light.h"
#include "radiosity/first_shot.h"
#include "radiosity/item_plan.h"
#include "radiosity/line_sampling.h"
#include "radiosity/multipath.h"

#include <stdexcept>

namespace multipath {

namespace {

constexpr std::uint64_t pilot_rays = 1u << 16; // for the figures of (3); 1 % in the ratio is not noticed in the error

double ratio_for(const Scene& scene, const SolveOptions& options)
{
    if (options.method == Method::global)
        return 0.0;
    if (options.ratio)
        return *options.ratio;
    const DirectLight direct = measure_direct_light(scene, pilot_rays, options.threads);
    BudgetFigures figures;
    figures.intersections = intersections_of_hull_line(scene);
    figures.average_reflectance = mean(scene.average_reflectance());
    figures.secondary_reflectance = direct.secondary_reflectance;
    figures.lit_fraction = direct.lit_fraction;
    const double ratio = optimal_ratio(figures); // (3)
    return std::isfinite(ratio) ? ratio : 1.0;   // sources that light nothing, or only black: any split does
}

void require_balance(const PowerBalance& balance)
{
    if (!(balance.relative_error() <= 1e-9))
        throw std::logic_error("the power balance does not close: the program has an error");
}

} // namespace

Solution solve(const Scene& scene, const SolveOptions& options, const ProgressCallback& progress)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const LineBudget budget = split_lines(options.lines, ratio_for(scene, options));
    PowerState state(scene);
    const std::vector<Shot> shots = plan_first_shot(scene, state, threshold_radiosity(scene), budget.local_lines);

    Solution solution;
    for (const Shot& shot : shots)
        solution.local_lines += shot.rays;
    const GlobalLines lines(scene.bounds());
    solution.global_lines = options.lines - solution.local_lines; // with what a first shot has no use for
    solution.global_lines_cast = lines.lines_to_cast(solution.global_lines);
    const ItemPlan items = plan_items(*sequence, options.skip, solution.local_lines, solution.global_lines_cast);

    std::uint64_t lines_done = 0;
    const auto lines_in_all = static_cast<double>(solution.local_lines + solution.global_lines_cast);
    const LineCounter count_lines = [&](std::uint64_t count) {
        lines_done += count;
        progress(static_cast<double>(lines_done) / lines_in_all);
    };
    shoot(scene, *sequence, items.first_shot, shots, options.threads, state, count_lines); // (S1)
    const GlobalPass pass{items.global_pass, solution.global_lines_cast, options.bidirectional};
    cast_global_lines(scene, lines, *sequence, pass, options.threads, state, count_lines); // (M1) (M2)

    solution.balance = power_balance(scene, state);
    require_balance(solution.balance);
    solution.radiosity = radiosity(scene, state);
    return solution;
}

} // namespace multipath

#include "explain/first_stage_run.h"

#include "radiosity/paper/first_stage.h"
#include "radiosity/run/item_plan.h"

#include <algorithm>

namespace multipath {

FirstStageRun run_first_stage(const Scene& scene, const Sequence& sequence, const GlobalLines& lines,
                              const SolveOptions& options, PowerState& state)
{
    const ItemPlan all_items = plan_items(sequence, options.skip, 0, lines.lines_to_cast(options.lines));
    FirstStageRun run;
    run.passes = shoot_first(scene, sequence, all_items.first_shot, options, {options.threads}, state);
    for (const ShotPass& pass : run.passes)
        run.local_lines += pass.lines;
    run.lines_charged = options.lines - std::min(options.lines, run.local_lines);
    run.lines_cast = lines.lines_to_cast(run.lines_charged);
    run.crossings_per_area = lines.expected_crossings(1.0, run.lines_cast); // (G1)
    for (const Rgb unshot : state.unshot) {
        run.unshot += unshot;
        run.unshot_patches += mean(unshot) > 0.0 ? 1 : 0;
    }
    return run;
}

} // namespace multipath

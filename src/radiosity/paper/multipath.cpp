#include "radiosity/paper/multipath.h"

#include "parallel/stage.h"
#include "radiosity/paper/power_walk.h"
#include "transport/lines/depth_complexity.h"
#include "transport/lines/line_segments.h"

#include <algorithm>

namespace multipath {

namespace {

/// The lines of a pass, with the walk that follows their segments.
struct GlobalStage
{
    using Block = SegmentBlock;

    Blocks lines() const { return plan.lines; }
    void trace(std::uint64_t number, SegmentBlock& block) const { block.trace(plan, number); }
    std::uint64_t take(std::uint64_t number, const SegmentBlock& block)
    {
        walk.follow(block.segments); // (M1) (M2)
        return plan.lines.length(number);
    }
    void visit(Archive& archive) { walk.visit(archive); }

    const LineBlocks plan;
    PowerWalk walk;
};

/// [W^2] Estimate of the variance of the power that independent lines send as forecast (G3), mean of the
/// channels. A patch with unshot power U that expects n lines sends U / n along each of them, with variance U^2 / n if
/// it were alone. A line that leaves several such patches sends their forecasts together; the variance of that sum is
/// at most their number, here the mean number, times the sum of their variances.
double forecast_variance(const Scene& scene, const GlobalLines& lines, const GlobalPass& pass, const PowerState& state)
{
    const double departures_per_area =
        lines.expected_crossings(1.0, pass.lines_cast) * (pass.bidirectional ? 1.0 : 0.5); // (G1)
    double sum = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double unshot = mean(state.unshot[i]);
        sum += unshot * unshot / (departures_per_area * scene.area(i));
    }
    const double departures_per_line =
        departures_per_area * scene.total_area() / static_cast<double>(pass.lines_cast); // the mean
    return sum * std::max(2.0, departures_per_line);
}

} // namespace

std::uint64_t cast_global_lines(const Scene& scene, const GlobalLines& lines, const Sequence& sequence,
                                const GlobalPass& pass, const RunControl& run, PowerState& state)
{
    if (pass.lines_cast == 0)
        return 0;
    const double variance = forecast_variance(scene, lines, pass, state);
    GlobalStage stage{
        {scene, lines, sequence, pass.first_item, {pass.lines_cast, lines_per_block(crossings_per_line(scene, lines))}},
        {scene, lines.expected_crossings(1.0, pass.lines_cast), pass.bidirectional, state}}; // (G1)
    const std::uint64_t cast = run_stage("global pass", stage, run);
    const double planned_per_cast = static_cast<double>(pass.lines_cast) / static_cast<double>(cast);
    stage.walk.finish(planned_per_cast, state);
    state.emitted_variance += planned_per_cast * variance;
    return cast;
}

} // namespace multipath

// What a global line carries depends on the lines before it. So the lines before the range are followed as well, but
// not recorded.

#include "base/text_format.h"
#include "explain/stage_trace.h"
#include "explain/trace_lines.h"
#include "explain/words.h"
#include "radiosity/paper/power_walk.h"
#include "radiosity/run/run.h"

namespace multipath {

namespace {

std::string before_the_pass(const Run& run)
{
    Rgb power;
    std::size_t patches = 0;
    for (const Rgb unshot : run.state.unshot) {
        power += unshot;
        patches += mean(unshot) > 0.0 ? 1 : 0;
    }
    const std::string unshot = watts(power) + " on " + counted(patches, "patch", "patches") + ". ";
    if (run.solution.shot_passes.empty())
        return "No rays are shot first: all power of the sources is unshot when the global lines begin, " + unshot;
    return "Before it, " + counted(run.solution.shot_passes.size(), "pass", "passes") + " of shots took " +
           grouped(run.solution.local_lines) +
           " of the lines. The power that patches reflected from them and that the sources kept is unshot: " + unshot;
}

/// Explains how the lines are generated, and how many are cast (N1).
std::string lines_drawn(bool from_box, std::uint64_t lines_cast)
{
    if (from_box)
        return " from random points of the scene's bounding box, in directions that favour its inward normal by the "
               "cosine: all of them meet the box (N1).";
    return "; " + grouped(lines_cast) +
           " lines through two random points of a sphere around the scene are cast, so that this many meet the scene's "
           "box (N1).";
}

/// Explains how often lines cross a patch (G1) and what it sends each time.
std::string power_sent(const Scene& scene, double crossings_per_area, bool both)
{
    const double area = scene.total_area() / scene.patch_count();
    const double crossings = crossings_per_area * area;
    const std::string per_patch = format("%.4g", both ? crossings : 0.5 * crossings);
    return "Such lines cross a patch in proportion to its area, " +
           format("%.4g times per square metre (G1). A patch of %.3g m^2, the mean, is crossed ", crossings_per_area,
                  area) +
           format("%.4g times, and ", crossings) +
           (both ? "each crossing leaves its front in one of the line's two directions (M2)"
                 : "half of the lines leave its front") +
           ": so it can send " + per_patch + " times in total. That is known before any line is cast, so " +
           "each time it sends its unshot power divided by " + per_patch + ", the forecast (G3), " +
           "and with it all power that it holds: what it has received and reflected since it last sent (M1).";
}

/// "2 - 3": the numbers of the hits at the ends of a segment.
std::string segment_number(const TracedLine& line, std::size_t after)
{
    return (after == 0 ? "start" : std::to_string(after)) + " - " +
           (after == line.crossings.size() ? "end" : std::to_string(after + 1));
}

/// What is told about the power that a patch sends, and its fate.
std::string transfer_text(const Scene& scene, const Transfer& transfer)
{
    const bool received = Segment::is_patch(transfer.to);
    std::string text =
        patch_name(scene, transfer.from) + " -> " + (received ? patch_name(scene, transfer.to) : "nowhere") + " sends ";
    if (transfer.sent() == Rgb{})
        text += "nothing: it has no forecast and holds nothing";
    else
        text += "forecast " + colour_text(transfer.forecast) + " + held " + colour_text(transfer.held) + " = " +
                watts(transfer.sent()) + (received ? "" : ", " + loss(transfer.to));
    if (received)
        return text + "; patch " + std::to_string(transfer.to) + " reflects " +
               colour_text(scene.reflectance(transfer.to)) + " of what arrives and then holds " +
               watts(transfer.then_held);
    return text + "; it then holds nothing";
}

/// Lets the walk follow segment `after` of the line, and records what the patches at its ends send and then hold.
void trace_segment(const Scene& scene, bool bidirectional, std::size_t after, PowerWalk& walk, TracedLine& line)
{
    const Segment segment = segment_after(line, after);
    std::vector<Transfer> transfers;
    const auto sends = [&](std::uint32_t from, std::uint32_t to) {
        const WalkingPower& power = walk.at(from);
        transfers.push_back({after, from, to, power.forecast, power.held, power.to_send()});
    };
    if (Segment::is_patch(segment.from))
        sends(segment.from, segment.to);
    if (Segment::is_patch(segment.to) && bidirectional)
        sends(segment.to, segment.from);
    walk.follow({segment});

    const std::string number = segment_number(line, after) + "  ";
    if (transfers.empty())
        line.notes.push_back(number + "begins on a side without patches: nothing is sent along it");
    for (Transfer& transfer : transfers) {
        if (Segment::is_patch(transfer.to))
            transfer.then_held = walk.at(transfer.to).held;
        line.notes.push_back(number + transfer_text(scene, transfer));
        line.transfers.push_back(transfer);
    }
}

/// Traces the power along a line through the scene.
void trace_power(const Scene& scene, const SolveOptions& options, PowerWalk& walk, TracedLine& line)
{
    const bool from_box = chords_of(options) == Chords::box;
    line.opening += from_box ? ", both just outside the box" : " on the sphere";
    for (std::size_t after = 0; after <= line.crossings.size(); ++after) {
        const Segment segment = segment_after(line, after);
        if (Segment::is_patch(segment.from) || Segment::is_patch(segment.to))
            trace_segment(scene, options.bidirectional, after, walk, line);
    }
    if (line.crossings.empty())
        line.notes.push_back("meets nothing: it is cast, as (G1) counts it, but carries no power");
    else if (line.notes.empty())
        line.notes.push_back("the line meets only sides without patches: it carries no power");
}

/// The stage without its lines.
StageTrace global_stage(const Run& run, double crossings_per_area)
{
    constexpr bool from_outside = true;
    const bool from_box = chords_of(run.options) == Chords::box;
    return {"Lines of the global pass",
            {before_the_pass(run) + "The pass distributes it with " +
                 counted(run.solution.global_lines, "global line", "global lines") +
                 lines_drawn(from_box, run.solution.global_lines_cast),
             power_sent(run.scene, crossings_per_area, run.options.bidirectional)},
            "line",
            run.solution.global_lines_cast,
            from_outside};
}

} // namespace

StageTrace trace_global_pass(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    Run run(scene, options);
    options.method->stages.front()(run); // the first shot
    run.plan_global_lines();
    const std::uint64_t lines_cast = run.solution.global_lines_cast;
    require_in_stage(range, lines_cast, "global lines");
    const double crossings_per_area = run.lines.expected_crossings(1.0, lines_cast); // (G1)
    StageTrace trace = global_stage(run, crossings_per_area);

    const ShuffledOrder order = walking_order(*run.sequence, options.line_order, run.next_item(), lines_cast);
    PowerWalk walk(scene, crossings_per_area, options.bidirectional, run.state);
    std::vector<Hit> hits;
    std::vector<Segment> segments;
    for (std::uint64_t n = 0; n < range.first + range.count; ++n) {
        const std::uint64_t item = order.item_at(run.next_item() + n);
        const LineOrigin origin{n, item, run.sequence->item(item)};
        const Line line = run.lines.line(origin.numbers);
        scene.intersector().all_hits(line, hits);
        if (range.includes(n)) {
            trace.lines.push_back(through_scene(scene, origin, line, line.at(1.0), hits));
            trace_power(scene, options, walk, trace.lines.back());
        } else {
            segments.clear();
            append_segments(scene, hits, segments);
            walk.follow(segments);
        }
    }
    return trace;
}

} // namespace multipath

#include "radiosity/global_story.h"

#include "radiosity/first_stage.h"
#include "radiosity/item_plan.h"
#include "radiosity/power_walk.h"
#include "transport/line_sampling.h"

#include <algorithm>

namespace multipath {

namespace {

/// Lets the walk follow one segment and notes what the patches held before and hold after it.
Stretch follow_told(const Segment& segment, bool bidirectional, PowerWalk& walk)
{
    Stretch stretch{0, segment, {}, {}, {}};
    const auto sends = [&](std::uint32_t from, std::uint32_t to) {
        stretch.transfers.push_back({from, to, walk.at(from).forecast, walk.at(from).held});
    };
    if (Segment::is_patch(segment.from))
        sends(segment.from, segment.to);
    if (Segment::is_patch(segment.to) && bidirectional)
        sends(segment.to, segment.from);
    WalkTally not_told;
    walk.follow(segment, not_told);
    if (Segment::is_patch(segment.from))
        stretch.from_holds = walk.at(segment.from).held;
    if (Segment::is_patch(segment.to))
        stretch.to_holds = walk.at(segment.to).held;
    return stretch;
}

/// For each segment, in order, how many meetings lie before it: append_segments leaves out stretches without a patch.
std::vector<std::size_t> meetings_before(const std::vector<Meeting>& meetings)
{
    std::vector<std::size_t> before;
    for (std::size_t after = 0; after <= meetings.size(); ++after)
        if ((after > 0 && Segment::is_patch(meetings[after - 1].patches.leaves)) ||
            (after < meetings.size() && Segment::is_patch(meetings[after].patches.arrives_at)))
            before.push_back(after);
    return before;
}

GlobalLine tell(const Scene& scene, const LineOrigin& origin, const Line& line, const std::vector<Hit>& hits,
                const std::vector<Segment>& segments, bool bidirectional, PowerWalk& walk)
{
    GlobalLine told{origin, line.origin, line.at(1.0), {}, {}};
    for (const Hit& hit : hits)
        told.meetings.push_back(meeting_at(scene, line, hit));
    const std::vector<std::size_t> before = meetings_before(told.meetings);
    for (std::size_t k = 0; k < segments.size(); ++k) {
        told.stretches.push_back(follow_told(segments[k], bidirectional, walk));
        told.stretches.back().after = before.at(k);
    }
    return told;
}

/// The first stage as solve runs it, and the budget that it leaves.
GlobalStory begin(const Scene& scene, const Sequence& sequence, const GlobalLines& lines, const SolveOptions& options,
                  PowerState& state)
{
    const ItemPlan all_items = plan_items(sequence, options.skip, 0, lines.lines_to_cast(options.lines));
    GlobalStory story;
    story.shot_passes = shoot_first(scene, sequence, all_items.first_shot, options, {options.threads}, state);
    for (const ShotPass& pass : story.shot_passes)
        story.local_lines += pass.lines;
    story.lines_charged = options.lines - std::min(options.lines, story.local_lines);
    story.lines_cast = lines.lines_to_cast(story.lines_charged);
    story.crossings_per_area = lines.expected_crossings(1.0, story.lines_cast); // (G1)
    for (const Rgb unshot : state.unshot) {
        story.unshot += unshot;
        story.unshot_patches += mean(unshot) > 0.0 ? 1 : 0;
    }
    return story;
}

} // namespace

GlobalStory tell_global_pass(const Scene& scene, const SolveOptions& options, const ToldRange& range)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const GlobalLines lines(scene.bounds(), chords_of(options));
    PowerState state(scene);
    GlobalStory story = begin(scene, *sequence, lines, options, state);
    require_in_stage(range, story.lines_cast, "global lines");

    const ItemPlan items = plan_items(*sequence, options.skip, story.local_lines, story.lines_cast);
    const ShuffledOrder order = walking_order(*sequence, options.line_order, items.global_pass, story.lines_cast);
    PowerWalk walk(scene, story.crossings_per_area, options.bidirectional, state);
    WalkTally not_told;
    std::vector<Hit> hits;
    std::vector<Segment> segments;
    for (std::uint64_t n = 0; n < range.first + range.count; ++n) {
        const std::uint64_t item = order.item_at(items.global_pass + n);
        const LineOrigin origin{n, item, sequence->item(item)};
        const Line line = lines.line(origin.numbers);
        scene.intersector().all_hits(line, hits);
        segments.clear();
        append_segments(scene, hits, segments);
        if (range.includes(n))
            story.lines.push_back(tell(scene, origin, line, hits, segments, options.bidirectional, walk));
        else
            for (const Segment& segment : segments)
                walk.follow(segment, not_told);
    }
    return story;
}

} // namespace multipath

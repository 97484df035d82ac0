#include "radiosity/shot_story.h"

#include "radiosity/first_stage.h"
#include "radiosity/item_plan.h"
#include "radiosity/line_budget.h"
#include "scene/input_error.h"
#include "transport/line_sampling.h"
#include "transport/local_ray.h"

namespace multipath {

namespace {

/// One ray: traced, received, and told.
ShotRay follow(const Scene& scene, const Shot& shot, const LineOrigin& origin, PowerState& state)
{
    const Patch patch = scene.patch(shot.patch);
    const Line ray = local_line(patch, origin.numbers);
    ShotRay told{origin, shot.patch, ray, {}, receiver(scene, patch.surface, ray), shot.power_per_ray, {}};
    if (const std::optional<Hit> hit = scene.intersector().closest_hit_from(patch.surface, ray))
        told.meeting = meeting_at(scene, ray, *hit);
    if (Segment::is_patch(told.where)) {
        state.unshot[told.where] += scene.reflectance(told.where) * told.power; // (S1)
        told.unshot = state.unshot[told.where];
    }
    return told;
}

/// What a pass shoots, and the state in which it begins.
struct ObservedPass
{
    std::uint64_t first_item = 0;
    std::vector<Shot> shots;
    std::optional<PowerState> state;
};

void require_pass(const std::vector<ShotPass>& passes, std::size_t pass)
{
    if (passes.empty())
        throw SettingsError(
            "the first shot has no pass: nothing is unshot above the threshold, or no line is left for it");
    if (pass >= passes.size())
        throw SettingsError("the first shot of this run ends after pass " + std::to_string(passes.size()) +
                            ", but pass " + std::to_string(pass + 1) + " is asked for");
}

} // namespace

ShotStory tell_shot_pass(const Scene& scene, const SolveOptions& options, std::size_t pass, const ToldRange& range)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const GlobalLines lines(scene.bounds(), chords_of(options));
    const ItemPlan items = plan_items(*sequence, options.skip, 0, lines.lines_to_cast(options.lines));

    ObservedPass told;
    std::size_t passes_begun = 0;
    const auto keep_told_pass = [&](std::uint64_t first_item, const std::vector<Shot>& shots, const PowerState& state) {
        if (passes_begun++ == pass)
            told = {first_item, shots, state};
    };
    PowerState state(scene);
    const std::vector<ShotPass> passes =
        shoot_first(scene, *sequence, items.first_shot, options, {options.threads}, state, keep_told_pass);
    require_pass(passes, pass);
    require_in_stage(range, ray_count(told.shots), "rays");

    ShotStory story{passes, pass, options.threshold.value_or(threshold_radiosity(scene)), told.shots.size(), {}};
    std::uint64_t n = 0;
    for (const Shot& shot : told.shots)
        for (std::uint64_t k = 0; k < shot.rays && n < range.first + range.count; ++k, ++n) {
            const std::uint64_t item = told.first_item + n;
            const ShotRay ray = follow(scene, shot, {n, item, sequence->item(item)}, *told.state);
            if (range.includes(n))
                story.rays.push_back(ray);
        }
    return story;
}

} // namespace multipath

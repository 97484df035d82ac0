#include "radiosity/particle_story.h"

#include "radiosity/item_plan.h"
#include "transport/line_sampling.h"
#include "transport/local_ray.h"

namespace multipath {

namespace {

ToldStep tell(const Scene& scene, const ParticleStep& step, Estimator estimator)
{
    const Patch patch = scene.patch(step.from);
    ToldStep told{step, local_line(patch, step.item), {}, {}};
    if (const std::optional<Hit> hit = scene.intersector().closest_hit_from(patch.surface, told.ray))
        told.meeting = meeting_at(scene, told.ray, *hit);
    if (Segment::is_patch(step.where))
        told.counted = counted_power(scene, step, estimator);
    return told;
}

} // namespace

ParticleStory tell_particles(const Scene& scene, const SolveOptions& options, const ToldRange& range)
{
    const std::unique_ptr<Sequence> sequence = make_line_sequence(options.sequence, options.seed, options.pairing);
    const GlobalLines lines(scene.bounds());
    const ItemPlan items = plan_items(*sequence, options.skip, 0, lines.lines_to_cast(options.lines));
    const Particles particles = plan_particles(scene, PowerState(scene), options.lines, options.seed, options.threads);
    require_in_stage(range, particles.count(), "particles");

    ParticleStory story{particles.count(), particles.shots().size(), {}};
    for (std::uint64_t n = range.first; n < range.first + range.count; ++n) {
        ToldParticle told{{n, items.first_shot + n, sequence->item(items.first_shot + n)}, {}};
        ParticlePaths paths;
        particles.follow(n, {told.origin.numbers}, paths);
        for (const ParticleStep& step : paths.steps)
            told.steps.push_back(tell(scene, step, options.estimator));
        story.particles.push_back(told);
    }
    return story;
}

} // namespace multipath

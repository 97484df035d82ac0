// Particles and gathering random walks: paths of rays from patch to patch. They are independent of each other, so only
// those of the range are traced.

#include "base/text_format.h"
#include "explain/stage_trace.h"
#include "explain/trace_lines.h"
#include "explain/words.h"
#include "radiosity/family/gathering_walk.h"
#include "radiosity/paper/local_monte_carlo.h"
#include "transport/lines/local_rays.h"

namespace multipath {

namespace {

/// Appends a step to the path; what its note begins with: the two ends of the step, up to the patch where it arrives.
std::string append_step(const Scene& scene, const ParticleStep& step, std::size_t number, TracedLine& path)
{
    if (!path.points.empty())
        path.joins.push_back(false); // on within the patch
    const std::size_t hits = path.crossings.size();
    const Line ray = local_line(scene.patch(step.from), step.item);
    append_ray(scene, step.from, ray, step.where, path);
    return std::to_string(number) + "  " + point_text(ray.origin) + " of " + patch_name(scene, step.from) + " -> " +
           (path.crossings.size() > hits ? point_text(path.points.back()) + " of " : "");
}

/// The decision at the end of a step: `survivor` is what goes on if the path does not end.
std::string survival_text(const Scene& scene, const ParticleStep& step, const std::string& survivor)
{
    const double survival = mean(scene.reflectance(step.where));
    return step.ends()
               ? format("; the number drawn, %.3f, is not below the reflectance, %.3g: it ends", step.drawn, survival)
               : format("; the number drawn, %.3f, is below the reflectance, %.3g: it goes on", step.drawn, survival) +
                     survivor;
}

/// Appends the paths of the range, each of which begins with the item of its number after the first that the run does
/// not skip. carried(step, first, path) adds to the path what the step carries, where `first` is the patch at which the
/// path begins, and returns what is told about it.
template <class Carried>
void trace_paths(const Scene& scene, const SolveOptions& options, const Particles& particles, const TracedRange& range,
                 StageTrace& trace, const Carried& carried)
{
    const Run run(scene, options);
    for (std::uint64_t n = range.first; n < range.first + range.count; ++n) {
        TracedLine path;
        path.origin = {n, run.first_item + n, run.sequence->item(run.first_item + n)};
        ParticlePaths paths;
        particles.follow(*run.sequence, run.first_item, n, 1, paths);
        for (const ParticleStep& step : paths.steps) {
            const std::string ends = append_step(scene, step, path.notes.size() + 1, path);
            path.notes.push_back(ends + carried(step, paths.steps.front().from, path));
        }
        trace.lines.push_back(path);
    }
}

} // namespace

StageTrace trace_particles(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    const Particles particles = plan_particles(scene, PowerState(scene), options.lines, options.seed, options.threads);
    require_in_stage(range, particles.count(), "particles");
    StageTrace trace = {
        "Particles of local Monte Carlo",
        {"The sources, " + counted(particles.shots().size(), "patch", "patches") + ", send " +
         counted(particles.count(), "particle", "particles") +
         " of equal power, as many as use up the lines of the run in expectation: every segment of a path counts as "
         "a line. At every patch that it meets a particle draws a number. If it is below the patch's reflectance, "
         "the particle is reflected and goes on from a uniform point of the patch, otherwise it is absorbed. " +
         (options.estimator == Estimator::collision
              ? "Wherever it arrives, its power is scored as arrived (L1)."
              : "Only where it is absorbed it is scored, with its power over 1 - reflectance (L1).")},
        "particle",
        particles.count()};
    trace_paths(scene, options, particles, range, trace,
                [&](const ParticleStep& step, std::uint32_t, TracedLine& path) -> std::string {
                    const bool arrives = Segment::is_patch(step.where);
                    const Rgb scored = arrives ? scored_power(scene, step, options.estimator) : Rgb{};
                    path.transfers.push_back({path.joins.size() - 1, step.from, step.where, {}, step.power, scored});
                    if (!arrives)
                        return "nothing: " + watts(step.power) + ", " + loss(step.where);
                    return patch_name(scene, step.where) + ": brings " + watts(step.power) + ", scored " +
                           watts(scored) + survival_text(scene, step, " with " + watts(step.goes_on));
                });
    return trace;
}

StageTrace trace_walks(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    const Particles walks = first_walks(Run(scene, options));
    require_in_stage(range, walks.count(), "walks");
    StageTrace trace = {
        "Gathering random walks",
        {"The walks start at the patches whose light is wanted, in proportion to the square root of their area, " +
         counted(walks.count(), "walk", "walks") +
         " in the first round; the result is the mean of all rounds. At every patch that it meets a walk draws a "
         "number. If it is below the patch's reflectance, the walk goes on from a uniform point of the patch, "
         "otherwise it ends. " +
         (options.estimator == Estimator::collision
              ? "Wherever it arrives, the emittance there, over the number of walks of the first patch, is "
                "added to the irradiance of the first patch (W1)."
              : "Where it ends, the emittance there over 1 - reflectance, and over the number of walks of the "
                "first patch, is added to the irradiance of the first patch (W1).")},
        "walk",
        walks.count()};
    trace_paths(scene, options, walks, range, trace,
                [&](const ParticleStep& step, std::uint32_t first, TracedLine& path) -> std::string {
                    if (!Segment::is_patch(step.where))
                        return std::string("nothing: the walk ends ") +
                               (step.where == Segment::behind ? "at the back of a surface, where no patch is"
                                                              : "outside the scene");
                    const Rgb irradiance = gathered_irradiance(scene, step, options.estimator); // (W1)
                    const Rgb power = scene.area(first) * irradiance;
                    if (power != Rgb{})
                        path.transfers.push_back({path.joins.size() - 1, step.where, first, {}, power, power});
                    return patch_name(scene, step.where) +
                           (irradiance == Rgb{} ? ": adds nothing"
                                                : ": adds " + colour_text(irradiance) +
                                                      " W/m^2 to the irradiance of patch " + std::to_string(first)) +
                           survival_text(scene, step, "");
                });
    return trace;
}

} // namespace multipath

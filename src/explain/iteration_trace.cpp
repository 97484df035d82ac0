#include "base/errors.h"
#include "base/text_format.h"
#include "explain/stage_trace.h"
#include "explain/trace_lines.h"
#include "explain/words.h"
#include "radiosity/family/stochastic_jacobi.h"

namespace multipath {

namespace {

/// "patch 3 of floor (line 4), which 17 rays per m^2 leave, sends 0.7 W"
std::string sender_text(const Scene& scene, std::uint32_t patch, double density, Rgb power)
{
    return patch_name(scene, patch) + ", which " + format("%.4g", density) + " rays per m^2 leave, sends " +
           watts(power);
}

TracedLine trace_ray(const Scene& scene, const LineOrigin& origin, const IterationRay& ray)
{
    TracedLine line = traced_ray(scene, origin, ray.from, ray.to, "");
    line.transfers.push_back({0, ray.from, ray.to, {}, ray.sent, ray.sent});
    line.notes.push_back(sender_text(scene, ray.from, ray.from_density, ray.sent) + destination(scene, ray.to));
    if (ray.to_density > 0.0) {
        line.transfers.push_back({0, ray.to, ray.from, {}, ray.returned, ray.returned});
        line.notes.push_back(sender_text(scene, ray.to, ray.to_density, ray.returned) + " back");
    }
    return line;
}

/// The stage without its rays. `series_rays`: number of rays of the Neumann series before the iteration.
StageTrace iteration_stage(std::uint64_t series_rays, std::uint64_t rays, bool bidirectional)
{
    return {"Rays of a stochastic Jacobi iteration",
            {"Before it, a Neumann series of " + counted(series_rays, "ray", "rays") +
                 " gave a first estimate of all light. Each iteration improves it: every patch sends all its "
                 "power, emitted and reflected, by rays in proportion to it, in the first one " +
                 counted(rays, "ray", "rays") + ", numbered in the order of the patches. ",
             bidirectional ? "A ray between two patches carries power both ways. If d rays per m^2 leave the one and e "
                             "the other, each patch sends its radiosity over d + e along every ray between them, "
                             "whichever patch the ray leaves (J2)."
                           : "If d rays per m^2 leave a patch, it sends its radiosity over d along each of them (J1)."},
            "ray",
            rays};
}

} // namespace

StageTrace trace_iteration(const Scene& scene, const SolveOptions& options, const TracedRange& range)
{
    Run run(scene, options);
    ray_series(run);
    if (run.lines_left() == 0)
        throw SettingsError("this run has too few lines for an iteration");
    const IterationTrace iteration = trace_first_iteration(run, range.first, range.count);
    require_in_stage(range, iteration.ray_count, "rays");
    StageTrace trace = iteration_stage(run.solution.local_lines, iteration.ray_count, options.bidirectional);
    for (const IterationRay& ray : iteration.rays)
        trace.lines.push_back(
            trace_ray(scene, {range.first + trace.lines.size(), ray.item, run.sequence->item(ray.item)}, ray));
    return trace;
}

} // namespace multipath

// The figures of (3) that depend on the direct light. Rays from the sources, as in the first shot, estimate the
// received power and with it the reflectance of the lit patches. They would miss patches of which only a border is lit,
// so f is found from the other end: shadow rays join every patch, or a stratified sample of many patches, with points
// of the sources, until one of them is free.

#include "radiosity/paper/direct_light.h"

#include "parallel/blocks.h"
#include "radiosity/paper/shot_rays.h"
#include "sampling/discrete_distribution.h"
#include "sampling/halton.h"
#include "sampling/random.h"
#include "transport/lines/local_rays.h"
#include "transport/lines/shadow_rays.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace multipath {

namespace {

/// The point of the patch for (a, b) in the unit square. Unlike square_to_uniform_surface, it folds the square along
/// its diagonal onto a triangle, so that the grid of snapped_to_grid() stays regular from border to border.
Vec3 point_on(const Surface& shape, double a, double b)
{
    if (shape.shape == Shape::triangle && a + b > 1.0)
        return shape.at(1.0 - a, 1.0 - b);
    return shape.at(a, b);
}

/// One of five grid coordinates from border to border, equally often for x in [0, 1): a patch that is barely lit is lit
/// at its border, from the border of a source.
double snapped_to_grid(double x)
{
    constexpr double inset = 1e-4;
    return inset + (1.0 - 2.0 * inset) * 0.25 * std::floor(5.0 * x);
}

/// End points of a shadow ray: a point of a source, and the point (a, b) of any patch.
struct Probe
{
    Vec3 from;
    Vec3 source_normal;
    std::uint32_t source_surface;
    double a, b; ///< position on the patch
};

std::vector<Probe> make_probes(const Scene& scene, std::uint64_t count)
{
    DiscreteDistribution sources; // the patches by the power that they send
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        sources.add(scene.area(i) * mean(scene.first_light(i)));
    std::vector<Probe> probes;
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::uint64_t n = 1 + k / 2; // each point of the sequence as it is and on the grid
        const auto coordinate = [&](std::uint64_t base) {
            const double x = radical_inverse(base, n);
            return k % 2 == 0 ? snapped_to_grid(x) : x;
        };
        const Patch source = scene.patch(static_cast<std::uint32_t>(sources.at(radical_inverse(13, n))));
        probes.push_back({point_on(source.shape, coordinate(5), coordinate(7)), source.shape.normal(), source.surface,
                          coordinate(2), coordinate(3)});
    }
    return probes;
}

/// A tested patch.
struct Target
{
    std::uint32_t patch;
    double area; ///< that it represents [m^2]
    Surface shape;
    Vec3 normal;
    bool lit = false;

    Target(const Scene& scene, std::uint32_t number, double represented)
        : patch(number), area(represented), shape(scene.patch(number).shape), normal(shape.normal())
    {
    }
};

/// All patches with their own areas if there are no more than `most`. Otherwise a stratified random sample by area,
/// with one point in each of `most` equal strata of the cumulative area. Equidistant points would alias with the grids
/// into which surfaces are divided.
std::vector<Target> targets(const Scene& scene, std::uint32_t most)
{
    std::vector<Target> chosen;
    if (scene.patch_count() <= most) {
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            chosen.emplace_back(scene, i, scene.area(i));
        return chosen;
    }
    constexpr std::uint64_t key = random_key(RandomStream::chosen_patches); // the same sample in every run
    const double stratum = scene.total_area() / most;
    std::uint32_t patch = 0;
    double end = scene.area(patch); // of the patch, as cumulative area
    for (std::uint32_t k = 0; k < most; ++k) {
        const double point = (k + bits_to_unit(random_bits(key, k))) * stratum;
        while (end <= point && patch + 1 < scene.patch_count())
            end += scene.area(++patch);
        if (!chosen.empty() && chosen.back().patch == patch)
            chosen.back().area += stratum;
        else
            chosen.emplace_back(scene, patch, stratum);
    }
    return chosen;
}

/// Finds which of the targets first ... end - 1 see any of the points on the sources. All that are not known to be lit
/// cast their next shadow rays together. Returns the area represented by the lit ones [m^2].
double find_lit(const Scene& scene, const std::vector<Probe>& probes, Target* first, Target* end)
{
    constexpr std::size_t rays_together = 1024;
    std::vector<Target*> unlit(static_cast<std::size_t>(end - first));
    std::iota(unlit.begin(), unlit.end(), first);
    ShadowRays<Target*> rays;
    for (std::size_t done = 0; done < probes.size() && !unlit.empty();) {
        const std::size_t next = std::min(probes.size(), done + std::max<std::size_t>(1, rays_together / unlit.size()));
        for (Target* const target : unlit)
            for (std::size_t k = done; k < next; ++k) {
                const Probe& probe = probes[k];
                const Line ray = {probe.from, point_on(target->shape, probe.a, probe.b) - probe.from};
                if (dot(ray.direction, probe.source_normal) > 0.0 && dot(ray.direction, target->normal) < 0.0)
                    rays.add(probe.source_surface, scene.surface_of(target->patch), ray, target);
            }
        rays.trace(scene, [&](Target* target, const Hit& hit) {
            target->lit = target->lit || receiving_patch(scene, hit) == target->patch;
        });
        unlit.erase(std::remove_if(unlit.begin(), unlit.end(), [](const Target* target) { return target->lit; }),
                    unlit.end());
        done = next;
    }
    return std::accumulate(first, end, 0.0,
                           [](double sum, const Target& target) { return sum + (target.lit ? target.area : 0.0); });
}

/// [m^2] Area of the directly lit patches, estimated from a sample if there are many.
double lit_area(const Scene& scene, std::uint64_t most_rays, int threads)
{
    const std::vector<Probe> probes =
        make_probes(scene, std::clamp<std::uint64_t>(8 * most_rays / scene.patch_count(), 16, 4096));
    const auto most_patches = static_cast<std::uint32_t>(std::clamp<std::uint64_t>(most_rays, 1u << 13, 1u << 16));
    std::vector<Target> chosen = targets(scene, most_patches);
    constexpr std::uint32_t patches_at_a_time = 256;
    std::vector<double> area(chosen.size() / patches_at_a_time + 1, 0.0);
    parallel_ranges(static_cast<std::uint32_t>(chosen.size()), patches_at_a_time, threads,
                    [&](std::uint32_t first, std::uint32_t end) {
                        area[first / patches_at_a_time] =
                            find_lit(scene, probes, chosen.data() + first, chosen.data() + end);
                    });
    return std::accumulate(area.begin(), area.end(), 0.0);
}

} // namespace

DirectLight measure_direct_light(const Scene& scene, std::uint64_t most_rays, int threads)
{
    PowerState state(scene);
    const std::unique_ptr<Sequence> sequence = make_sequence("sobol", 0);
    const std::vector<Shot> shots = plan_first_shot(scene, state, 0.0, most_rays, 0);
    if (shots.empty()) // the sun shines on nothing
        return {};
    spend(scene, 0.0, shots, state);
    shoot(scene, *sequence, 0, shots, {threads}, state);

    double received = 0.0;  // [W]
    double reflected = 0.0; // [W]
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        received += mean(state.incident[i]);
        reflected += mean(scene.reflectance(i) * state.incident[i]);
    }
    DirectLight result;
    result.lit_fraction = lit_area(scene, most_rays, threads) / scene.total_area();
    result.secondary_reflectance = received > 0.0 ? reflected / received : 0.0;
    return result;
}

} // namespace multipath

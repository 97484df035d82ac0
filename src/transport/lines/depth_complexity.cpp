#include "transport/lines/depth_complexity.h"

#include "geometry/intersector/intersector.h"
#include "sampling/discrete_distribution.h"
#include "sampling/halton.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

double crossings_per_line(const Scene& scene, const GlobalLines& lines)
{
    const double area = scene.total_area() / (scene.two_sided() ? 2.0 : 1.0); // of surfaces, not of their sides
    return lines.expected_crossings(area, 1);                                 // (G1)
}

double pairs_along_line(const Scene& scene, const GlobalLines& lines)
{
    constexpr std::size_t trials = 256;
    std::vector<Item> items(trials);
    make_sequence("random", 1)->generate(0, items);
    double pairs = 0.0;
    std::vector<Hit> hits;
    for (const Item& item : items) {
        scene.intersector().all_hits(lines.line(item), hits);
        const auto count = static_cast<double>(hits.size());
        pairs += 0.5 * count * (count - 1.0);
    }
    return std::max(0.0, pairs) / trials;
}

namespace {

constexpr double ordinary_surfaces = 16.0; ///< largest number along a line, or coincident, in an ordinary scene

constexpr std::uint64_t trial_rays = 64;

/// Cost of the coincident surfaces at a point of `surface`: their number, plus a sixteenth of the candidates that the
/// intersector looks through to find them.
double faces_on(const Scene& scene, std::uint32_t surface, Vec3 point)
{
    const Intersector& intersector = scene.intersector();
    return static_cast<double>(intersector.coincident_surfaces(surface, point).size()) +
           static_cast<double>(intersector.surfaces_around(surface, point)) / 16.0;
}

/// Number of surfaces along the whole line of a ray if it starts at a point covered by another face, 0 otherwise: the
/// order of all of them decides what such a ray meets.
double faces_along(const Scene& scene, std::uint32_t surface, const Line& ray)
{
    if (scene.intersector().coincident_surfaces(surface, ray.origin).empty())
        return 0.0;
    const double beyond_scene = 2.0 * scene.bounds().diagonal() / length(ray.direction);
    std::vector<Hit> hits;
    scene.intersector().all_hits({ray.at(-beyond_scene), ray.direction}, hits);
    return static_cast<double>(hits.size());
}

/// Mean number of surfaces that a ray from a source is compared with: at its start, at its first hit, and along its
/// line if its start is covered. The sources are chosen in proportion to their power.
double faces_on_source_rays(const Scene& scene)
{
    DiscreteDistribution sources;
    for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s)
        sources.add(scene.surfaces()[s].area() * mean(scene.surface_material(s).emittance));
    if (!(sources.total() > 0.0))
        return 0.0;
    double faces = 0.0;
    for (std::uint64_t k = 0; k < trial_rays; ++k) {
        const auto number = [k](std::uint64_t base) { return radical_inverse(base, k + 1); };
        const auto source = static_cast<std::uint32_t>(sources.at((static_cast<double>(k) + 0.5) / trial_rays));
        const Line ray = local_line({source, scene.surfaces()[source]}, {number(2), number(3), number(5), number(7)});
        faces += faces_on(scene, source, ray.origin) + faces_along(scene, source, ray);
        const std::optional<Hit> hit = scene.intersector().closest_hit_from(source, ray);
        faces += hit ? faces_on(scene, hit->surface, scene.surfaces()[hit->surface].at(hit->u, hit->v)) : 0.0;
    }
    return faces / trial_rays;
}

/// Mean number of other surfaces that coincide with the centre of a patch.
double faces_on_patches(const Scene& scene)
{
    double faces = 0.0;
    for (std::uint64_t k = 0; k < trial_rays; ++k) {
        const auto patch = static_cast<std::uint32_t>(k * scene.patch_count() / trial_rays);
        faces += faces_on(scene, scene.surface_of(patch), scene.patch(patch).shape.centre());
    }
    return faces / trial_rays;
}

} // namespace

double affordable_lines(const Scene& scene)
{
    const double along = crossings_per_line(scene, GlobalLines(scene.bounds()));
    return ordinary_surfaces / std::max(along, ordinary_surfaces);
}

double affordable_source_rays(const Scene& scene)
{
    return ordinary_surfaces / std::max(faces_on_source_rays(scene), ordinary_surfaces);
}

double affordable_patch_rays(const Scene& scene)
{
    return ordinary_surfaces / std::max(faces_on_patches(scene), ordinary_surfaces);
}

} // namespace multipath

// A patch that gets the power P from a light of which it sees the share V adds rho^2 P^2 V (1 - V) / (A m) to the error
// (1) when m rays measure V. The sum over all pairs is smallest when m is proportional to
//
//   rho P sqrt(V (1 - V)) / sqrt(A)
//
// A few rays, alloted as if the root were the same everywhere, tell where it is not.

#include "radiosity/ray_allotment.h"

#include "parallel/ordered_blocks.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// What rays to this pair are worth if the light is half hidden, up to a factor that all pairs share.
double importance(const Scene& scene, std::uint32_t patch, const GatherPairs& pairs, std::size_t k)
{
    constexpr double dark = 0.01; // what black patches receive is wanted too, if not as precisely
    const Rgb emittance = surface_emittance(scene, pairs.lights[pairs.pairs[k].light]);
    const Rgb seen = (scene.reflectance(patch) + Rgb{dark, dark, dark}) * emittance;
    return static_cast<double>(pairs.pairs[k].exchange) * std::sqrt(mean(seen * seen) / scene.area(patch));
}

double sum_of(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum;
}

std::vector<double> importances(const Scene& scene, const GatherPairs& pairs)
{
    std::vector<double> result;
    result.reserve(pairs.pairs.size());
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        for (std::size_t k = pairs.first_pair[patch]; k < pairs.first_pair[patch + 1]; ++k)
            result.push_back(importance(scene, patch, pairs, k));
    return result;
}

/// The patches around this one on the same side of its surface.
std::vector<std::uint32_t> neighbours(const Scene& scene, std::uint32_t patch)
{
    const std::uint32_t surface = scene.surface_of(patch);
    const Tessellation& grid = scene.tessellation(surface);
    const auto cells = static_cast<std::uint32_t>(grid.cell_count());
    const std::uint32_t first_front = scene.first_patch(surface);
    const bool front = patch >= first_front && patch - first_front < cells;
    const std::uint32_t first = front ? first_front : scene.patch_at(surface, 0.0, 0.0, false);

    const Surface unit = {grid.shape, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Vec3 centre = grid.cell(unit, patch - first).centre();
    std::vector<std::uint32_t> found;
    for (int du = -1; du <= 1; ++du)
        for (int dv = -1; dv <= 1; ++dv) {
            const double u = centre.x + du / static_cast<double>(grid.cells_u);
            const double v = centre.y + dv / static_cast<double>(grid.cells_v);
            const bool inside = u > 0.0 && v > 0.0 && u < 1.0 && v < 1.0;
            const bool in_triangle = grid.shape != Shape::triangle || u + v < 1.0;
            if ((du != 0 || dv != 0) && inside && in_triangle)
                found.push_back(scene.patch_at(surface, u, v, front));
        }
    return found;
}

/// sqrt(V (1 - V)) from so many rays. That they all agree does not prove that one more would.
double spread(double rays, double free)
{
    return std::sqrt((free + 0.5) * (rays - free + 0.5)) / (rays + 1.0);
}

/// sqrt(V (1 - V)) of a pair, or more: what the patches around it tell, or what it has found itself.
double doubt(const GatherPairs& pairs, const std::vector<std::uint32_t>& around, std::size_t pair,
             const std::vector<double>& rays, const std::vector<Sight>& sights)
{
    // If the first rays have a say in how many follow, the mean of both has a bias of about 1 / (2 rays).
    constexpr double many = 32.0;
    const double own = rays[pair] >= many ? spread(rays[pair], rays[pair] * sights[pair].share()) : 0.0;
    double rays_around = 0.0;
    double free_around = 0.0;
    for (const std::uint32_t neighbour : around)
        if (const std::optional<std::size_t> k = pairs.find(neighbour, pairs.pairs[pair].light)) {
            rays_around += rays[*k];
            free_around += rays[*k] * sights[*k].share();
        }
    return std::max(own, spread(rays_around, free_around));
}

} // namespace

std::vector<double> first_allotment(const Scene& scene, const GatherPairs& pairs, double rays)
{
    std::vector<double> allotment = importances(scene, pairs);
    const auto count = static_cast<double>(allotment.size());
    const double least = std::min(1.0, 0.5 * rays / count);
    const double rate = (rays - least * count) / sum_of(allotment);
    for (double& pair : allotment)
        pair = least + rate * pair;
    return allotment;
}

std::vector<double> second_allotment(const Scene& scene, const GatherPairs& pairs, const std::vector<double>& first,
                                     const std::vector<Sight>& sights, double rays, int threads)
{
    constexpr std::uint32_t patches_at_a_time = 64;
    std::vector<double> allotment = importances(scene, pairs);
    parallel_ranges(scene.patch_count(), patches_at_a_time, threads, [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t patch = begin; patch < end; ++patch) {
            const std::vector<std::uint32_t> around = neighbours(scene, patch);
            for (std::size_t k = pairs.first_pair[patch]; k < pairs.first_pair[patch + 1]; ++k)
                allotment[k] *= doubt(pairs, around, k, first, sights);
        }
    });
    const double rate = rays / sum_of(allotment);
    for (double& pair : allotment)
        pair *= rate;
    return allotment;
}

} // namespace multipath

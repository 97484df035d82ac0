#pragma once

#include "brute_force.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/kernel.h"
#include "geometry/intersector/surface_sizes.h"
#include "geometry/random_surfaces.h"
#include "sampling/sequence.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

// Lines and rays on which kernels could go wrong, and how many of them do.

namespace multipath {

/// `others`: the two other coordinates.
inline Vec3 along_axis(std::size_t axis, double size, double others = 0.0)
{
    return {axis == 0 ? size : others, axis == 1 ? size : others, axis == 2 ? size : others};
}

/// Lines of all kinds around surfaces, difficult ones among them: through corners and edges, along axes, in planes,
/// from far away.
inline std::vector<Line> difficult_lines(const SurfaceList& surfaces, std::size_t count, std::uint64_t key)
{
    const Bounds box = bounds_of(surfaces);
    const double size = box.diagonal();
    Numbers numbers(key);
    const auto anywhere = [&] { return box.centre() + size * numbers.point(-0.7, 0.7); };
    const auto surface = [&]() -> const Surface& { return surfaces[numbers.below(surfaces.size())]; };
    const auto corner = [&] { return surface().at(numbers.unit() < 0.5 ? 0 : 1, numbers.unit() < 0.5 ? 0 : 1); };
    const auto on_edge = [&] { return surface().at(numbers.unit(), numbers.unit() < 0.5 ? 0 : 1); };
    const auto inside = [&] { return surface().at(numbers.unit(), numbers.unit()); };
    std::vector<Line> lines;
    while (lines.size() < count) {
        const Surface& s = surface();
        const Vec3 far_point = box.centre() + 1e3 * size * numbers.point(-1, 1);
        const Vec3 very_far_point = box.centre() + 1e8 * size * numbers.point(-1, 1);
        const double minus_nothing = numbers.unit() < 0.5 ? -0.0 : -1e-60; // both -0 in single precision
        const std::array<Line, 14> kinds = {
            chord(anywhere(), anywhere()),
            Line{anywhere(), numbers.point(-1, 1)},
            Line{inside(), numbers.point(-1, 1)},
            chord(inside(), inside()),
            chord(corner(), corner()),
            chord(on_edge(), on_edge()),
            Line{corner(), along_axis(numbers.below(3), numbers.within(-1, 1))},
            Line{inside(), along_axis(numbers.below(3), numbers.within(-1, 1)), numbers.within(0, size)},
            Line{inside(), along_axis(numbers.below(3), numbers.within(-1, 1), minus_nothing)},
            chord(s.at(-1, numbers.unit()), s.at(2, numbers.unit())), // in the plane of the surface
            Line{far_point, inside() - far_point},
            Line{far_point, corner() - far_point},
            Line{very_far_point, inside() - very_far_point},
            Line{inside(), {0, 0, 0}},
        };
        lines.insert(lines.end(), kinds.begin(), kinds.end());
    }
    return lines;
}

/// How many lines some kernel, in some way of asking, gets wrong.
inline std::size_t wrong_lines(const SurfaceList& surfaces, const std::vector<Line>& lines)
{
    const BruteForce brute_force(surfaces);
    std::vector<Intersector> intersectors;
    std::vector<HitLists> blocks(available_kernels().size());
    for (const FilterKernel* kernel : available_kernels()) {
        intersectors.emplace_back(surfaces, *kernel);
        intersectors.back().all_hits(lines.data(), lines.size(), blocks[intersectors.size() - 1]);
    }
    const auto equal = [](const auto& found, const std::vector<Hit>& expected) {
        return std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                          [](const Hit& a, const Hit& b) { return same(a, b); });
    };
    std::size_t wrong = 0;
    std::vector<Hit> hits;
    std::vector<Hit> expected;
    for (std::size_t n = 0; n < lines.size(); ++n) {
        brute_force.all_hits(lines[n], expected);
        bool right = true;
        for (std::size_t k = 0; k < intersectors.size(); ++k) {
            intersectors[k].all_hits(lines[n], hits);
            const std::optional<Hit> closest = intersectors[k].closest_hit(lines[n]);
            right = right && equal(hits, expected) && equal(blocks[k][n], expected) &&
                    same(closest, brute_force.closest(expected)) && (!closest || closest->t == expected[0].t);
        }
        wrong += !right;
    }
    return wrong;
}

struct RaysFrom
{
    std::vector<std::uint32_t> surfaces;
    std::vector<Line> rays;
};

/// Rays from points of surfaces, also from their edges and corners, in any direction, also towards corners of others
/// and along the surface.
inline RaysFrom rays_from(const SurfaceList& surfaces, std::size_t count, std::uint64_t key)
{
    RaysFrom result;
    Numbers numbers(key);
    while (result.rays.size() < count) {
        const auto from = static_cast<std::uint32_t>(numbers.below(surfaces.size()));
        const Surface& s = surfaces[from];
        const auto coordinate = [&] {
            return numbers.unit() < 0.1 ? (numbers.unit() < 0.5 ? 0.0 : 1.0) : numbers.unit();
        };
        const double u = coordinate();
        const double v = (s.shape == Shape::triangle ? 1.0 - u : 1.0) * coordinate();
        const Vec3 start = s.at(u, v);
        const Vec3 corner = surfaces[numbers.below(surfaces.size())].at(coordinate(), 0.0);
        for (const Vec3 direction : {numbers.point(-1, 1), corner - start, s.edge_u, Vec3{}}) {
            result.surfaces.push_back(from);
            result.rays.push_back({start, direction});
        }
    }
    return result;
}

/// How many rays some kernel, in some way of asking, gets wrong.
inline std::size_t wrong_rays(const SurfaceList& surfaces, const RaysFrom& from)
{
    const BruteForce brute_force(surfaces);
    std::vector<Intersector> intersectors;
    const std::size_t rays = from.rays.size();
    std::vector<FirstHits> blocks(available_kernels().size());
    for (const FilterKernel* kernel : available_kernels()) {
        intersectors.emplace_back(surfaces, *kernel);
        intersectors.back().closest_hits_from(from.surfaces.data(), from.rays.data(), rays,
                                              blocks[intersectors.size() - 1]);
    }
    std::vector<std::uint32_t> targets; // what is met, and anything
    Numbers numbers(rays);
    for (std::size_t n = 0; n < rays; ++n)
        targets.push_back(blocks[0].is_hit(n) && n % 3 != 0
                              ? blocks[0][n].surface
                              : static_cast<std::uint32_t>(numbers.below(surfaces.size())));
    std::vector<FirstHits> on_targets(blocks.size());
    for (std::size_t k = 0; k < blocks.size(); ++k)
        intersectors[k].hits_on_targets(from.surfaces.data(), targets.data(), from.rays.data(), rays, on_targets[k]);
    const auto hit_of = [](const FirstHits& found, std::size_t n) {
        return found.is_hit(n) ? std::optional<Hit>(found[n]) : std::nullopt;
    };
    std::size_t wrong = 0;
    std::vector<Hit> hits;
    for (std::size_t n = 0; n < from.rays.size(); ++n) {
        const std::uint32_t surface = from.surfaces[n];
        brute_force.all_hits(from.rays[n], hits);
        const bool covered = !brute_force.coincident_surfaces(surface, from.rays[n].origin).empty();
        const std::optional<Hit> expected = covered ? intersectors.back().closest_hit_from(surface, from.rays[n])
                                                    : brute_force.closest_from(surface, hits, from.rays[n]);
        const bool on_target = expected && expected->surface == targets[n];
        bool right = true;
        for (std::size_t k = 0; k < intersectors.size(); ++k)
            right = right && same(hit_of(blocks[k], n), expected) &&
                    same(hit_of(on_targets[k], n), on_target ? expected : std::nullopt) &&
                    same(intersectors[k].closest_hit_from(surface, from.rays[n]), expected);
        wrong += !right;
    }
    return wrong;
}

inline std::vector<Line> random_chords(const SurfaceList& surfaces, std::size_t count)
{
    const Bounds box = bounds_of(surfaces);
    const GlobalLines global_lines(box);
    const auto sequence = make_sequence("sobol", 1);
    std::vector<Line> lines;
    for (std::size_t n = 0; n < count; ++n)
        lines.push_back(global_lines.line(sequence->item(n)));
    return lines;
}

} // namespace multipath

#include "radiosity/family/importance.h"

#include "parallel/blocks.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace multipath {

namespace {

/// The receivers of some rays over the hemisphere of each patch, patch by patch.
std::vector<std::uint32_t> hemisphere_receivers(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                                std::uint32_t rays_per_patch, int threads)
{
    std::vector<std::uint32_t> receivers(std::size_t{rays_per_patch} * scene.patch_count());
    constexpr std::uint32_t patches_at_a_time = 64;
    parallel_ranges(scene.patch_count(), patches_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        const std::size_t first_ray = std::size_t{rays_per_patch} * first;
        RayBlock block;
        block.items.resize(std::size_t{rays_per_patch} * (end - first));
        sequence.generate(first_item + first_ray, block.items);
        for (std::uint32_t i = first; i < end; ++i)
            block.patches.insert(block.patches.end(), rays_per_patch, i);
        block.trace(scene);
        std::copy(block.receivers.begin(), block.receivers.end(), receivers.data() + first_ray);
    });
    return receivers;
}

} // namespace

double Importance::weighted_area(const Scene& scene) const
{
    double area = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        area += weight[i] * scene.area(i);
    return area;
}

std::vector<double> Importance::influence(const Scene& scene, const MeanOverRays& mean_over_rays, int threads) const
{
    constexpr int reflections = 8; // more of them would add little, and the result only guides sampling
    std::vector<double> result(scene.patch_count());
    for (int k = 0; k < reflections; ++k) {
        const std::vector<double> before = result;
        parallel_numbers(scene.patch_count(), threads, [&](std::uint32_t i) {
            result[i] = mean_over_rays(i, [&](std::uint32_t j) {
                const double rho = mean(scene.reflectance(j));
                return rho * std::sqrt(weight[j]) + rho * before[j];
            });
        });
    }
    return result;
}

// Noise dP in the power that arrives at patch j changes B_j by rho_j dP / A_j. Its square counts with w_j A_j. In
// addition, patch j reflects the noise to other patches. Its influence Z_j on all important patches solves the adjoint
// system, and if the influence is spread over their weighted area, the noise contributes (rho_j Z_j dP)^2 / that area.
std::vector<double> Importance::noise_factors(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                              std::uint32_t rays_per_patch, int threads) const
{
    const std::vector<std::uint32_t> receivers =
        hemisphere_receivers(scene, sequence, first_item, rays_per_patch, threads);
    const auto mean_over_rays = [&](std::uint32_t patch, const Value& value) {
        double sum = 0.0;
        for (std::uint32_t k = 0; k < rays_per_patch; ++k)
            if (const std::uint32_t end = receivers[std::size_t{rays_per_patch} * patch + k]; Segment::is_patch(end))
                sum += value(end);
        return sum / rays_per_patch;
    };
    const double area = weighted_area(scene);
    const std::vector<double> influence_of = influence(scene, mean_over_rays, threads);
    std::vector<double> result(scene.patch_count());
    parallel_numbers(scene.patch_count(), threads, [&](std::uint32_t i) {
        result[i] = std::sqrt(mean_over_rays(i, [&](std::uint32_t j) {
            const double direct = mean(scene.reflectance(j)) * std::sqrt(weight[j]);
            const double reflected = mean(scene.reflectance(j)) * influence_of[j];
            return direct * direct / scene.area(j) + reflected * reflected / area; // (I1)
        }));
    });
    return result;
}

} // namespace multipath

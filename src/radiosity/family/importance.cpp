#include "radiosity/family/importance.h"

#include "parallel/blocks.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace multipath {

namespace {

/// Receivers of some rays over the hemisphere of each patch.
class HemisphereRays
{
public:
    HemisphereRays(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, std::uint32_t rays_per_patch,
                   int threads)
        : rays_(rays_per_patch), receivers_(std::size_t{rays_per_patch} * scene.patch_count())
    {
        constexpr std::uint32_t patches_at_a_time = 64;
        parallel_ranges(scene.patch_count(), patches_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
            RayBlock block;
            block.items.resize(std::size_t{rays_} * (end - first));
            sequence.generate(first_item + std::uint64_t{rays_} * first, block.items);
            for (std::uint32_t i = first; i < end; ++i)
                block.patches.insert(block.patches.end(), rays_, i);
            block.trace(scene);
            std::copy(block.receivers.begin(), block.receivers.end(),
                      receivers_.begin() + static_cast<std::ptrdiff_t>(std::size_t{rays_} * first));
        });
    }

    /// Mean of value(receiver) over the rays of a patch. Rays that meet no patch count as 0.
    template <class Value>
    double mean_of(std::uint32_t patch, const Value& value) const
    {
        const std::uint32_t* const first = receivers_.data() + std::size_t{rays_} * patch;
        double sum = 0.0;
        for (std::uint32_t k = 0; k < rays_; ++k)
            if (Segment::is_patch(first[k]))
                sum += value(first[k]);
        return sum / rays_;
    }

private:
    std::uint32_t rays_;
    std::vector<std::uint32_t> receivers_;
};

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
    const HemisphereRays rays(scene, sequence, first_item, rays_per_patch, threads);
    const std::uint32_t n = scene.patch_count();
    const double area = weighted_area(scene);
    const std::vector<double> influence_of = influence(
        scene, [&](std::uint32_t i, const Value& value) { return rays.mean_of(i, value); }, threads);
    std::vector<double> result(n);
    parallel_numbers(n, threads, [&](std::uint32_t i) {
        result[i] = std::sqrt(rays.mean_of(i, [&](std::uint32_t j) {
            const double direct = mean(scene.reflectance(j)) * std::sqrt(weight[j]);
            const double reflected = mean(scene.reflectance(j)) * influence_of[j];
            return direct * direct / scene.area(j) + reflected * reflected / area; // (I1)
        }));
    });
    return result;
}

} // namespace multipath

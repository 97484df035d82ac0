#include "radiosity/family/importance.h"

#include "parallel/blocks.h"

#include <cmath>

namespace multipath {

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

} // namespace multipath

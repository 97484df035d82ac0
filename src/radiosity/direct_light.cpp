#include "radiosity/direct_light.h"

#include "parallel/ordered_blocks.h"
#include "radiosity/first_shot.h"
#include "sampling/radical_inverse.h"
#include "transport/intersection_list.h"
#include "transport/local_ray.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// Sources as a distribution of patches by power.
struct Sources
{
    std::vector<std::uint32_t> patches;
    std::vector<double> power_before; ///< [W] cumulative; one entry more than patches

    explicit Sources(const Scene& scene) : power_before{0.0}
    {
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const double power = scene.area(i) * mean(scene.emittance(i));
            if (power > 0.0) {
                patches.push_back(i);
                power_before.push_back(power_before.back() + power);
            }
        }
    }
    std::uint32_t at(double x) const
    {
        const auto above = std::upper_bound(power_before.begin(), power_before.end(), x * power_before.back());
        const auto place = static_cast<std::size_t>(above - power_before.begin()) - 1;
        return patches[std::min(place, patches.size() - 1)];
    }
};

Vec3 point_on(const Surface& shape, double a, double b)
{
    if (shape.shape == Shape::triangle && a + b > 1.0)
        return shape.at(1.0 - a, 1.0 - b);
    return shape.at(a, b);
}

/// One of five places from border to border: what is barely lit is lit at its border, from the border of a source.
double snapped(double x)
{
    constexpr double inset = 1e-4;
    return inset + (1.0 - 2.0 * inset) * 0.25 * std::floor(5.0 * x);
}

/// One look from a source at any patch.
struct Try
{
    Vec3 from;
    Vec3 source_normal;
    std::uint32_t source_surface;
    double a, b; ///< where on the patch
};

std::vector<Try> make_tries(const Scene& scene, std::uint64_t count)
{
    const Sources sources(scene);
    std::vector<Try> tries;
    for (std::uint64_t k = 1; k <= count; ++k) {
        const auto place = [&](std::uint64_t base) {
            const double x = radical_inverse(base, k);
            return k % 2 == 0 ? x : snapped(x);
        };
        const Patch source = scene.patch(sources.at(radical_inverse(13, k)));
        tries.push_back(
            {point_on(source.shape, place(5), place(7)), source.shape.normal(), source.surface, place(2), place(3)});
    }
    return tries;
}

/// Does light go straight from one of the points of the sources to one of the patch?
bool is_lit(const Scene& scene, const std::vector<Try>& tries, std::uint32_t patch)
{
    const Surface shape = scene.patch(patch).shape;
    const Vec3 normal = shape.normal();
    return std::any_of(tries.begin(), tries.end(), [&](const Try& look) {
        const Line ray = {look.from, point_on(shape, look.a, look.b) - look.from};
        return dot(ray.direction, look.source_normal) > 0.0 && dot(ray.direction, normal) < 0.0 &&
               receiver(scene, look.source_surface, ray) == patch;
    });
}

double lit_area(const Scene& scene, std::uint64_t shadow_rays, int threads)
{
    const std::vector<Try> tries =
        make_tries(scene, std::clamp<std::uint64_t>(8 * shadow_rays / scene.patch_count(), 16, 4096));
    constexpr std::uint64_t patches_per_block = 256;
    const std::uint64_t block_count = (scene.patch_count() + patches_per_block - 1) / patches_per_block;
    std::vector<double> area(block_count, 0.0);
    parallel_blocks(block_count, threads, [&](std::uint64_t block) {
        const std::uint64_t last = std::min<std::uint64_t>((block + 1) * patches_per_block, scene.patch_count());
        for (auto i = static_cast<std::uint32_t>(block * patches_per_block); i < last; ++i)
            if (is_lit(scene, tries, i))
                area[block] += scene.area(i);
    });
    double sum = 0.0;
    for (const double a : area)
        sum += a;
    return sum;
}

} // namespace

DirectLight measure_direct_light(const Scene& scene, std::uint64_t rays, int threads)
{
    PowerState state(scene);
    const std::unique_ptr<Sequence> sequence = make_sequence("sobol", 0);
    const std::vector<Shot> shots = plan_first_shot(scene, state, 0.0, rays);
    spend(scene, 0.0, shots, state);
    shoot(scene, *sequence, 0, shots, {threads}, state);

    double received = 0.0;  // [W]
    double reflected = 0.0; // [W]
    double squares = 0.0;   // sum of A b^2 [W^2/m^2]
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double power = mean(state.incident[i]);
        const double sent_on = mean(scene.reflectance(i) * state.incident[i]);
        received += power;
        reflected += sent_on;
        squares += sent_on * sent_on / scene.area(i);
    }
    DirectLight result;
    result.lit_fraction = lit_area(scene, rays, threads) / scene.total_area();
    result.secondary_reflectance = received > 0.0 ? reflected / received : 0.0;
    result.effective_fraction = squares > 0.0 ? reflected * reflected / (scene.total_area() * squares) : 0.0;
    return result;
}

} // namespace multipath

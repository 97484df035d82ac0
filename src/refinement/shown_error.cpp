#include "refinement/shown_error.h"

#include "image/gather/indirect_light.h"
#include "image/gather/place.h"
#include "image/gather/source_light.h"
#include "image/shading/smooth_shading.h"
#include "image/shading/visible_patches.h"
#include "parallel/blocks.h"
#include "sampling/random.h"
#include "sampling/sequence.h"
#include "sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace multipath {

namespace {

/// Places on the sides of a scene by their area.
class Places
{
public:
    explicit Places(const Scene& scene) : scene_(scene)
    {
        double sum = 0.0;
        for (const Surface& surface : scene.surfaces())
            ends_.push_back(sum += surface.area());
    }

    /// For numbers in [0, 1).
    Hit at(double which, double a, double b) const
    {
        const double sides = scene_.two_sided() ? 2.0 : 1.0;
        const bool front = which * sides < 1.0;
        const double place = (front ? which * sides : which * sides - 1.0) * ends_.back();
        const auto found = std::upper_bound(ends_.begin(), ends_.end() - 1, place);
        const auto surface = static_cast<std::uint32_t>(found - ends_.begin());
        if (scene_.surfaces()[surface].shape == Shape::parallelogram)
            return {0.0, surface, a, b, front};
        const Barycentric inside = square_to_uniform_triangle(a, b);
        return {0.0, surface, inside.u, inside.v, front};
    }

private:
    const Scene& scene_;
    std::vector<double> ends_; ///< [m^2] of the surfaces, one after the other
};

/// Sums over points.
struct Sums
{
    std::uint64_t points = 0;
    Rgb shown;
    Rgb truth;
    double product = 0.0; ///< [(W/m^2)^2] of the two deviations, mean of the channels
    double square = 0.0;  ///< of the products
};

} // namespace

ShownError shown_error(const Scene& scene, const std::vector<Rgb>& radiosity, const Truth& truth, std::uint64_t points,
                       int threads)
{
    const SmoothShading shading(scene, radiosity, threads);
    const Places places(scene);
    const std::unique_ptr<Sequence> sequence = make_sequence("sobol-owen", 3);
    constexpr std::uint64_t points_at_a_time = 64;
    const Blocks blocks = {points, points_at_a_time};
    BlockBuffers<Sums> parts(threads);
    Sums all;
    ordered_blocks(
        blocks.count(), threads,
        [&](std::uint64_t block, int slot) {
            Sums& sums = parts[slot] = {};
            std::vector<Item> items(static_cast<std::size_t>(blocks.first(block + 1) - blocks.first(block)));
            sequence->generate(blocks.first(block), items);
            for (std::size_t k = 0; k < items.size(); ++k) {
                const Hit hit = places.at(items[k][0], items[k][1], items[k][2]);
                Surface side = scene.surfaces()[hit.surface];
                const Vec3 point = side.at(hit.u, hit.v);
                if (!hit.front)
                    std::swap(side.edge_u, side.edge_v);
                if (is_covered(scene, hit.surface, side, point))
                    continue;
                const Rgb shown = shading.at(hit);
                const TruthAtPoint there = truth(hit, blocks.first(block) + k);
                const double product = mean((shown - there.one) * (shown - there.other));
                ++sums.points;
                sums.shown += shown;
                sums.truth += 0.5 * (there.one + there.other);
                sums.product += product;
                sums.square += product * product;
            }
        },
        [&](std::uint64_t, int slot) {
            all.points += parts[slot].points;
            all.shown += parts[slot].shown;
            all.truth += parts[slot].truth;
            all.product += parts[slot].product;
            all.square += parts[slot].square;
        });
    ShownError result;
    result.points = all.points;
    if (all.points == 0)
        return result;
    const auto n = static_cast<double>(all.points);
    result.area = scene.total_area() * n / static_cast<double>(points);
    result.mean_shown = mean(all.shown) / n;
    result.mean_true = mean(all.truth) / n;
    const double scale = result.mean_true * result.mean_true;
    result.relative_mean_square = all.product / n / scale;
    const double variance = std::max(0.0, all.square / n - all.product / n * (all.product / n));
    result.standard_error = std::sqrt(variance / n) / scale;
    return result;
}

Truth gathered_truth(const Scene& finer, const std::vector<Rgb>& radiosity, int rays, int threads)
{
    const auto sources = std::make_shared<const SourceLight>(finer);
    const auto indirect = std::make_shared<const IndirectLight>(finer, radiosity, rays, threads);
    return [&finer, sources, indirect, rays](const Hit& hit, std::uint64_t number) {
        const Place place = place_of(finer, hit);
        const Material& material = finer.surface_material(hit.surface);
        // Each with sequences of its own: items of one complement each other, so that the estimates would depend on
        // each other, and the standard error would not hold.
        const auto estimate = [&](RandomStream stream) {
            const std::uint64_t bits = random_bits(random_key(stream), number);
            const std::unique_ptr<Sequence> to_sources = make_sequence("sobol-owen", bits);
            const std::unique_ptr<Sequence> around = make_sequence("sobol-owen", ~bits);
            RayFan fan;
            const auto count = static_cast<std::size_t>(rays);
            Rgb irradiance = sources->irradiance(place, {*to_sources, 0, count}, bits_to_unit(bits), fan);
            irradiance += indirect->at(place, *around, 0, fan).irradiance;
            return (hit.front ? material.emittance : Rgb{}) + material.reflectance * irradiance;
        };
        return TruthAtPoint{estimate(RandomStream::first_truth), estimate(RandomStream::second_truth)};
    };
}

} // namespace multipath

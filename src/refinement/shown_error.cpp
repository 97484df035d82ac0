// The error is the mean of (shown - true)^2 over the visible points. The truth at a point is known only from estimates
// with noise, whose variance would be added to the square of a single deviation. So each point gets two independent
// estimates, and the product of the two deviations replaces the square: the noise of its factors is independent and
// averages out.

#include "refinement/shown_error.h"

#include "image/gather/gather_point.h"
#include "image/gather/indirect_light.h"
#include "image/gather/source_light.h"
#include "image/shading/smooth_shading.h"
#include "image/shading/visible_patches.h"
#include "parallel/blocks.h"
#include "radiosity/run/replicates.h"
#include "sampling/discrete_distribution.h"
#include "sampling/random.h"
#include "sampling/sequence.h"
#include "sampling/warp.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace multipath {

namespace {

/// A point on one side of a surface, with its weight in the mean.
struct SamplePoint
{
    Hit hit;
    double weight; ///< [1] 1 on the average
};

/// Sample points from a mixture of three distributions: uniform by area; the same number in every patch, as more detail
/// is seen where patches are small; and by the power that patches reflect, as errors are large in bright places. The
/// weight of a point is the inverse of the density of the mixture.
class SamplePoints
{
public:
    SamplePoints(const Scene& scene, const std::vector<Rgb>& guide) : scene_(scene), guide_(guide)
    {
        for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
            areas_.add(scene.surfaces()[s].area());
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            powers_.add(scene.area(i) * reflected(i));
    }

    SamplePoint at(const Item& item) const
    {
        const bool any_power = powers_.total() > 0.0;
        const double kinds = any_power ? 3.0 : 2.0;
        const double kind = kinds * item[3];
        const Hit hit = kind < 1.0   ? by_area(item[0], item[1], item[2])
                        : kind < 2.0 ? in_patch(any_patch(item[0]), item[1], item[2])
                                     : in_patch(static_cast<std::uint32_t>(powers_.at(item[0])), item[1], item[2]);
        const std::uint32_t patch = scene_.patch_at(hit.surface, hit.u, hit.v, hit.front);
        if (scene_.is_sky(hit.surface))
            return {hit, 0.0};
        double density = 1.0 + scene_.own_area() / (scene_.patch_count() * scene_.area(patch));
        if (any_power)
            density += scene_.own_area() * reflected(patch) / powers_.total();
        return {hit, kinds / density};
    }

private:
    double reflected(std::uint32_t i) const { return std::max(0.0, mean(guide_[i] - scene_.emittance(i))); }

    std::uint32_t any_patch(double x) const { return static_cast<std::uint32_t>(x * scene_.patch_count()); }

    Hit by_area(double which, double a, double b) const
    {
        const double sides = scene_.two_sided() ? 2.0 : 1.0;
        const bool front = which * sides < 1.0;
        const auto surface = static_cast<std::uint32_t>(areas_.at(front ? which * sides : which * sides - 1.0));
        const SurfacePoint inside = square_to_uniform_shape(scene_.surfaces()[surface].shape, a, b);
        return {0.0, surface, inside.u, inside.v, front};
    }

    Hit in_patch(std::uint32_t patch, double a, double b) const
    {
        const std::uint32_t surface = scene_.surface_of(patch);
        const bool front = scene_.is_front(patch);
        const Tessellation& cells = scene_.tessellation(surface);
        const CellCorners corners = scene_.corners(patch);
        const SurfacePoint inside = square_to_uniform_shape(cells.shape, a, b);
        const GridPoint& origin = corners.points[0];
        const GridPoint& along_u = corners.points[1];
        const GridPoint& along_v = corners.points[corners.count - 1];
        const auto between = [&](double from, double to_u, double to_v, double whole) {
            return (from + inside.u * (to_u - from) + inside.v * (to_v - from)) / whole;
        };
        return {0.0, surface, between(origin.i, along_u.i, along_v.i, cells.grid_u()),
                between(origin.j, along_u.j, along_v.j, cells.grid_v()), front};
    }

    const Scene& scene_;
    const std::vector<Rgb>& guide_;
    DiscreteDistribution areas_;  ///< [m^2] of the surfaces
    DiscreteDistribution powers_; ///< [W] reflected by the patches
};

/// Sums over sample points.
struct Sums
{
    std::uint64_t points = 0;
    double weights = 0.0;
    Rgb shown; ///< shown and true radiosity times weight
    Rgb truth;
    double product = 0.0; ///< [(W/m^2)^2] weighted product of the two deviations, mean of the channels
    double square = 0.0;  ///< of its squares
};

/// Two independent estimates of the deviation of the shown radiosity from the truth at a point [W/m^2].
struct Deviations
{
    Rgb one;
    Rgb other;
    Rgb shown;
};

using DeviationsAt = std::function<Deviations(const Hit& hit, std::uint64_t number)>;

/// Mean over the area of the product of the two deviations. `guide`: approximate radiosity [W/m^2] of the patches.
ShownError mean_product(const Scene& scene, const std::vector<Rgb>& guide, const DeviationsAt& deviations,
                        std::uint64_t points, int threads)
{
    const SamplePoints places(scene, guide);
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
                const auto [hit, weight] = places.at(items[k]);
                Surface side = scene.surfaces()[hit.surface];
                const Vec3 point = side.at(hit.u, hit.v);
                if (!hit.front)
                    std::swap(side.edge_u, side.edge_v);
                if (weight == 0.0 || is_covered(scene, hit.surface, side, point))
                    continue;
                const Deviations there = deviations(hit, blocks.first(block) + k);
                const double product = weight * mean(there.one * there.other);
                ++sums.points;
                sums.weights += weight;
                sums.shown += weight * there.shown;
                sums.truth += weight * (there.shown - 0.5 * (there.one + there.other));
                sums.product += product;
                sums.square += product * product;
            }
        },
        [&](std::uint64_t, int slot) {
            all.points += parts[slot].points;
            all.weights += parts[slot].weights;
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
    result.area = scene.own_area() * all.weights / static_cast<double>(points);
    result.mean_shown = mean(all.shown) / all.weights;
    result.mean_true = mean(all.truth) / all.weights;
    const double scale = result.mean_true * result.mean_true * all.weights / n;
    result.relative_mean_square = all.product / n / scale;
    const double variance = std::max(0.0, all.square / n - all.product / n * (all.product / n));
    result.standard_error = std::sqrt(variance / n) / scale;
    return result;
}

/// Final gathering at single points, from a solution.
class PointRadiosity
{
public:
    PointRadiosity(const Scene& scene, const std::vector<Rgb>& radiosity, int rays, int threads)
        : scene_(scene), sources_(scene), indirect_(scene, radiosity, rays, threads, &sources_), rays_(rays)
    {
    }

    /// [W/m^2] Radiosity. Estimates with another number or stream are independent. Each uses its own sequences, since
    /// the items of one sequence are not independent.
    Rgb at(const Hit& hit, std::uint64_t number, RandomStream stream) const
    {
        const GatherPoint receiver = gather_point(scene_, hit);
        const std::uint64_t bits = random_bits(random_key(stream), number);
        const std::unique_ptr<Sequence> to_sources = make_sequence("sobol-owen", bits);
        const std::unique_ptr<Sequence> around = make_sequence("sobol-owen", ~bits);
        RayFan fan;
        const auto count = static_cast<std::size_t>(rays_);
        Rgb irradiance = sources_.irradiance(receiver, {*to_sources, 0, count}, bits_to_unit(bits), fan);
        irradiance += indirect_.at(receiver, *around, 0, fan).irradiance;
        return (hit.front ? scene_.surface_material(hit.surface).emittance : Rgb{}) +
               scene_.reflectance_at(hit.surface, hit.u, hit.v) * irradiance;
    }

private:
    const Scene& scene_;
    SourceLight sources_;
    IndirectLight indirect_;
    int rays_;
};

} // namespace

ShownError shown_error(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& guide,
                       const Truth& truth, std::uint64_t points, int threads)
{
    const ShownRadiosity solution(scene, radiosity, threads);
    const auto deviations = [&](const Hit& hit, std::uint64_t number) {
        const Rgb shown = solution.at(hit);
        const TruthAtPoint there = truth(hit, number);
        return Deviations{shown - there.one, shown - there.other, shown};
    };
    return mean_product(scene, guide, deviations, points, threads);
}

Truth gathered_truth(const Scene& finer, const std::vector<Rgb>& radiosity, int rays, int threads)
{
    const auto light = std::make_shared<const PointRadiosity>(finer, radiosity, rays, threads);
    return [light](const Hit& hit, std::uint64_t number) {
        return TruthAtPoint{light->at(hit, number, RandomStream::first_estimate_of_truth),
                            light->at(hit, number, RandomStream::second_estimate_of_truth)};
    };
}

ShownError patch_error(const Scene& scene, double enough, double memory, int threads, const ProgressCallback& progress)
{
    constexpr std::uint64_t lines_per_patch = 64;
    constexpr std::uint64_t few_points = 4096;
    constexpr std::uint64_t many_points = 65536;
    constexpr int rays = 128;
    SolveOptions quick;
    quick.method = Method::reuse;
    quick.sequence = "sobol-owen";
    quick.lines = lines_per_patch * scene.patch_count();
    quick.memory = memory;
    quick.threads = threads;
    const auto solved = [&](std::uint64_t number) {
        return solve(scene, independent_run(quick, RandomStream::patch_error, quick.seed, number, 0),
                     [&](double done) { progress(0.4 * (static_cast<double>(number) + done)); })
            .radiosity;
    };
    struct Half
    {
        std::vector<Rgb> radiosity;
        ShownRadiosity shown;
        PointRadiosity light;

        Half(const Scene& scene, std::vector<Rgb> found, int threads)
            : radiosity(std::move(found)), shown(scene, radiosity, threads), light(scene, radiosity, rays, threads)
        {
        }
    };
    const Half one(scene, solved(0), threads);
    const Half other(scene, solved(1), threads);
    const auto deviations = [&](const Hit& hit, std::uint64_t number) {
        const Rgb shown = one.shown.at(hit);
        const Rgb shown_by_other = other.shown.at(hit);
        return Deviations{shown - one.light.at(hit, number, RandomStream::first_estimate_of_truth),
                          shown_by_other - other.light.at(hit, number, RandomStream::second_estimate_of_truth),
                          0.5 * (shown + shown_by_other)};
    };
    for (std::uint64_t points = few_points;; points *= 4) {
        const ShownError error = mean_product(scene, one.radiosity, deviations, points, threads);
        const bool undecided = error.root() < enough && enough < error.root_upper_bound();
        if (!undecided || points >= many_points)
            return error;
    }
}

} // namespace multipath

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

#include <memory>
#include <utility>

namespace multipath {

namespace {

/// A point on one side of a surface, with its weight in the mean.
struct SamplePoint
{
    Hit hit;
    double weight; ///< [1] 1 on the average
};

/// Sample points in patches chosen at random, uniform within each. The density is the mean of three: uniform by area;
/// the same for every patch, as more detail is seen where patches are small; and by the power that patches reflect, as
/// errors are large in bright places. The weight of a point is the inverse of its density.
class SamplePoints
{
public:
    SamplePoints(const Scene& scene, const std::vector<Rgb>& guide) : scene_(scene)
    {
        const auto reflected = [&](std::uint32_t i) {
            return scene.area(i) * std::max(0.0, mean(guide[i] - scene.emittance(i)));
        };
        double all_reflected = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            all_reflected += reflected(i);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            chances_.push_back(scene.is_sky_patch(i) ? 0.0
                                                     : scene.area(i) / scene.own_area() + 1.0 / scene.patch_count() +
                                                           quotient(reflected(i), all_reflected));
        for (const double chance : chances_)
            patches_.add(chance);
    }

    SamplePoint at(const Item& item) const
    {
        const auto patch = static_cast<std::uint32_t>(patches_.at(item[0]));
        const double weight = scene_.area(patch) / scene_.own_area() * patches_.total() / chances_[patch];
        return {point_in(patch, item[1], item[2]), weight};
    }

private:
    Hit point_in(std::uint32_t patch, double a, double b) const
    {
        const std::uint32_t surface = scene_.surface_of(patch);
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
                between(origin.j, along_u.j, along_v.j, cells.grid_v()), scene_.is_front(patch)};
    }

    const Scene& scene_;
    std::vector<double> chances_; ///< [1] relative chance of every patch
    DiscreteDistribution patches_;
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
    BlockBuffers<std::vector<std::pair<double, Deviations>>> buffers(threads); // with weights
    ShownError result;
    double weights = 0.0;
    Rgb shown; // shown and true radiosity times weight
    Rgb truth;
    double products = 0.0; // [(W/m^2)^2] weighted products of the two deviations, mean of the channels
    double squares = 0.0;  // of the products
    ordered_blocks(
        blocks.count(), threads,
        [&](std::uint64_t block, int slot) {
            buffers[slot].clear();
            std::vector<Item> items(static_cast<std::size_t>(blocks.first(block + 1) - blocks.first(block)));
            sequence->generate(blocks.first(block), items);
            for (std::size_t k = 0; k < items.size(); ++k) {
                const auto [hit, weight] = places.at(items[k]);
                Surface side = scene.surfaces()[hit.surface];
                const Vec3 point = side.at(hit.u, hit.v);
                if (!hit.front)
                    std::swap(side.edge_u, side.edge_v);
                if (is_covered(scene, hit.surface, side, point))
                    continue;
                buffers[slot].emplace_back(weight, deviations(hit, blocks.first(block) + k));
            }
        },
        [&](std::uint64_t, int slot) {
            for (const auto& [weight, there] : buffers[slot]) {
                const double product = weight * mean(there.one * there.other);
                ++result.points;
                weights += weight;
                shown += weight * there.shown;
                truth += weight * (there.shown - 0.5 * (there.one + there.other));
                products += product;
                squares += product * product;
            }
        });
    if (result.points == 0)
        return result;
    const auto n = static_cast<double>(result.points);
    result.area = scene.own_area() * weights / static_cast<double>(points);
    result.mean_shown = mean(shown) / weights;
    result.mean_true = mean(truth) / weights;
    const double scale = result.mean_true * result.mean_true * weights / n;
    result.relative_mean_square = products / n / scale;
    const double variance = std::max(0.0, squares / n - products / n * (products / n));
    result.standard_error = std::sqrt(variance / n) / scale;
    return result;
}

/// Final gathering at single points, from a solution.
class PointRadiosity
{
public:
    PointRadiosity(const Scene& scene, const std::vector<Rgb>& radiosity, int rays, int threads)
        : scene_(scene), sources_(scene), indirect_(scene, radiosity, rays, threads, &sources_)
    {
    }

    /// [W/m^2] Radiosity. Estimates with another number or stream are independent.
    Rgb at(const Hit& hit, std::uint64_t number, RandomStream stream) const
    {
        const GatherPoint receiver = gather_point(scene_, hit);
        const Rgb irradiance = indirect_.irradiance(receiver, sources_, random_bits(random_key(stream), number));
        return (hit.front ? scene_.surface_material(hit.surface).emittance : Rgb{}) +
               scene_.reflectance_at(hit.surface, hit.u, hit.v) * irradiance;
    }

private:
    const Scene& scene_;
    SourceLight sources_;
    IndirectLight indirect_;
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

// A light cut lists the clusters of lights that a patch may see, with their irradiances. The shadow rays of a patch are
// distributed over the cut by systematic sampling, in proportion to irradiance; in each cluster the tree then chooses a
// light by power, and the item a point on the patch and one on the light. Visible fractions come from the traced rays,
// and sums of g - 1 correct the approximate irradiances of the clusters (R5).

#include "radiosity/reuse/gathered_light.h"

#include "base/elementary.h"
#include "base/memory.h"
#include "sampling/random.h"
#include "sampling/warp.h"
#include "transport/exchange/line_counts.h"
#include "transport/exchange/pair_rays.h"
#include "transport/lines/shadow_rays.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace multipath {

namespace {

// Larger angles give fewer clusters per patch, and from 0.4 on more noise. Chosen by experiment in a room with 2,600
// lights.
constexpr double cluster_angle = 0.3;
// The kernels of lights that are seen under a larger angle vary much: rays sample their solid angle instead (RayPair).
constexpr double single_angle = 0.5;

constexpr double enough_rays = 16.0; // of a patch, for its own estimate of the visible fraction

constexpr std::size_t rays_at_a_time = 4096;

/// Shadow rays that are traced together.
struct RaysToLights
{
    const Scene& scene;
    const LightTree& tree;
    const LightCuts& cuts;

    struct Target
    {
        std::uint32_t patch; ///< patch that gathers the light
        std::uint32_t light; ///< surface
        bool front;          ///< side of its target that an unblocked ray meets
        double kernel;       ///< g
    };
    std::vector<Item> items = {};
    ShadowRays<Target> shadow_rays = {};

    /// Adds one ray for each of the items: rays number `first` and following of `rays` in total, by systematic sampling
    /// of the clusters with an offset in [0, 1).
    void add(std::uint32_t patch, std::uint64_t first, std::uint64_t rays, double offset, ShadowRaySums& patch_sums)
    {
        const Receiver receiver = {patch, scene.patch(patch).shape, patch_sums};
        const double step = cuts.irradiance(patch) / static_cast<double>(rays);
        const std::vector<SeenCluster>& seen = cuts.of(patch);
        auto cluster = seen.begin();
        double begin = 0.0; // of the cluster, in the cumulative irradiance
        double number = static_cast<double>(first) + offset;
        patch_sums.rays += static_cast<double>(items.size());
        for (std::size_t k = 0; k < items.size(); ++k, number += 1.0) {
            const double at = number * step;
            while (cluster + 1 < seen.end() && at >= begin + static_cast<double>(cluster->irradiance))
                begin += static_cast<double>((cluster++)->irradiance);
            const double x = std::clamp((at - begin) / static_cast<double>(cluster->irradiance), 0.0, below_one);
            add_ray(receiver, *cluster, x, items[k], true);
            if (k + 1 == items.size())
                add_another(receiver, *cluster, x, items[k]);
        }
    }

    void trace(std::vector<ShadowRaySums>& sums)
    {
        shadow_rays.trace(scene, [&](const Target& target, const Hit& hit) {
            if (hit.front != target.front)
                return;
            ShadowRaySums& patch_sums = sums[target.patch];
            const Rgb emittance = scene.emittance(scene.first_patch(target.light));
            patch_sums.free += 1.0;
            patch_sums.light += (target.kernel / mean(emittance)) * emittance;
        });
    }

    struct Receiver
    {
        std::uint32_t patch;
        FlatPiece piece; ///< the patch
        ShadowRaySums& sums;
    };

    /// Draws the last ray of a patch anew until it carries light, if no ray has. So nearly every patch knows by a ray
    /// of its own whether it sees a light.
    void add_another(const Receiver& receiver, const SeenCluster& seen, double x, Item item)
    {
        // A rotation by the fractions of roots of primes (Cranley and Patterson 1976).
        constexpr std::array<double, 5> rotation = {0.4142135623730950, 0.7320508075688773, 0.2360679774997897,
                                                    0.6457513110645906, 0.3166247903553998};
        constexpr int most_trials = 16;
        for (int trial = 0; trial < most_trials && !(receiver.sums.kernel > 0.0); ++trial) {
            for (std::size_t k = 0; k < item.size(); ++k)
                item[k] = std::fmod(item[k] + rotation[k], 1.0);
            x = std::fmod(x + rotation.back(), 1.0);
            add_ray(receiver, seen, x, item, false);
        }
    }

    /// A ray that carries no light is not traced. Only the `planned` ones tell how exact the irradiance of a cluster
    /// is.
    void add_ray(const Receiver& receiver, const SeenCluster& seen, double x, const Item& item, bool planned)
    {
        const auto& [patch, piece, patch_sums] = receiver;
        const auto assumed = static_cast<double>(seen.irradiance);
        const std::uint32_t leaf = tree.choose(seen.node, x);
        const LightTree::Cluster& light = tree.cluster(leaf);
        const std::uint32_t surface = tree.surface(leaf);
        Target target{patch, surface, true, 0.0};
        std::uint32_t from = scene.surface_of(patch);
        std::uint32_t to = surface;
        Line line;
        if (leaf == seen.node && LightCuts::is_near(light, piece, single_angle)) {
            const Patch dark = scene.patch(patch);
            const Patch bright = {surface, tree.piece(leaf).surface};
            const bool from_dark = piece.area <= light.area;
            const RayPair pair(scene, from_dark ? dark : bright, from_dark ? bright : dark);
            const RayPair::Ray ray = pair.ray(item);
            const double exchange = assumed * piece.area * light.area / light.power;
            target = {patch, surface, pair.to_front(), ray.weight / pair.mean_weight(exchange)};
            from = pair.from_surface();
            to = pair.to_surface();
            line = ray.line;
        } else {
            const Vec3 start = square_to_uniform_surface(piece.surface, item[0], item[1]);
            const Vec3 d = square_to_uniform_surface(tree.piece(leaf).surface, item[2], item[3]) - start;
            const double square = dot(d, d);
            const double cosines =
                std::max(0.0, dot(piece.normal, d)) * std::max(0.0, -dot(tree.piece(leaf).normal, d));
            target.kernel = cosines / (pi * square * square) * tree.cluster(seen.node).power / assumed;
            line = {start, d};
            if (leaf != seen.node && planned) {
                patch_sums.error += target.kernel - 1.0;
                patch_sums.square += (target.kernel - 1.0) * (target.kernel - 1.0);
            }
        }
        patch_sums.kernel += target.kernel;
        if (target.kernel > 0.0)
            shadow_rays.add(from, to, line, target);
    }
};

/// Shrinkage factor (empirical Bayes) for the mean of errors that are typically about `typical`.
double shrinkage(double typical, const RaySums& errors)
{
    constexpr double least = 0.01; // prevents overconfidence if a few rays happen to agree
    const double variance = elementary::pow(errors.standard_deviation(), 2);
    return typical * typical * errors.rays / (typical * typical * errors.rays + variance + least);
}

} // namespace

SceneLights::SceneLights(const Scene& scene, int most_threads) : threads(most_threads)
{
    tree = std::async(std::launch::deferred, [&scene] { return LightTree(scene); });
    cuts = std::async(std::launch::deferred, [&scene, trees = tree, most_threads] {
        return LightCuts(scene, trees.get(), cluster_angle, most_threads);
    });
    patches = std::async(std::launch::deferred, [&scene] {
        constexpr std::uint32_t patches_of_leaf = 8;
        const auto shape = [&](std::uint32_t i) { return scene.patch(i).shape; };
        return SurfaceTree(scene.patch_count(), shape, scene.bounds().diagonal(), patches_of_leaf);
    });
}

void GatheredLight::cast(const Allotment& rays, const Sequence& sequence, std::uint64_t first_item, ShardRange& range,
                         const RunControl& run)
{
    const Blocks patches = blocks(scene_.patch_count());
    const std::uint64_t key = bits_from(sequence.item(first_item));
    BlockBuffers<RaysToLights> buffers(run.threads, {scene_, lights_.tree.get(), cuts_});
    const auto look = [&](std::uint64_t block, int slot) {
        RaysToLights& buffer = buffers[slot];
        for (auto i = static_cast<std::uint32_t>(patches.first(block)); i < patches.first(block + 1); ++i) {
            const std::uint64_t count = rays.rays_of(i);
            const double offset = bits_to_unit(random_bits(key, i));
            for (std::uint64_t first = 0; first < count; first += buffer.items.size()) {
                buffer.items.resize(static_cast<std::size_t>(std::min<std::uint64_t>(rays_at_a_time, count - first)));
                sequence.generate(first_item + rays.first_ray(i) + first, buffer.items);
                buffer.add(i, first, count, offset, sums_[i]);
                if (buffer.shadow_rays.size() >= rays_at_a_time)
                    buffer.trace(sums_);
            }
        }
        buffer.trace(sums_);
    };
    const auto report = [&](std::uint64_t block, int) {
        run.count_lines(rays.first_ray(static_cast<std::uint32_t>(patches.first(block + 1))) -
                        rays.first_ray(static_cast<std::uint32_t>(patches.first(block))));
    };
    resumable_blocks(range.next, range.end, run, look, report);
}

/// make(i, sums of patch i) for all patches.
template <class Make>
auto GatheredLight::of_patches(const Make& make) const
{
    return parallel_list(scene_.patch_count(), lights_.threads, [&](std::uint32_t i) { return make(i, sums_[i]); });
}

std::vector<double> GatheredLight::deviations() const
{
    // Prevents a zero if all rays of some patches agree, which few rays may do by chance.
    constexpr double least_variance = 0.002;
    const std::vector<RaySums> own = of_patches([](std::uint32_t, const ShadowRaySums& sums) {
        return RaySums{sums.rays, sums.rays, sums.free, sums.free};
    });
    const std::vector<RaySums> free =
        pooled(lights_.patches.get(), own, enough_rays, OwnRays::counted, lights_.threads);
    return of_patches([&](std::uint32_t i, const ShadowRaySums&) {
        const double p = free[i].weight > 0.0 ? free[i].mean() : 0.5;
        return cuts_.irradiance(i) * std::sqrt(p * (1.0 - p) + least_variance);
    });
}

std::vector<Rgb> GatheredLight::incident() const
{
    const std::vector<RaySums> errors = of_patches([](std::uint32_t, const ShadowRaySums& sums) {
        return RaySums{sums.rays, sums.rays, sums.error, sums.square}; // of the unoccluded irradiance
    });
    const std::vector<RaySums> around =
        pooled(lights_.patches.get(), errors, 1024.0, OwnRays::counted, lights_.threads);
    constexpr double error_around = 0.1; // typical errors, relative
    constexpr double error_alone = 0.03;
    return of_patches([&](std::uint32_t i, const ShadowRaySums& sums) {
        if (!(sums.kernel > 0.0)) // patches around would lend it light that it may not see
            return cuts_.contact(i);
        const double unoccluded = scene_.area(i) * cuts_.irradiance(i);
        const double error = shrinkage(error_around, around[i]) * around[i].mean();
        const double own = errors[i].mean() - error;
        const double correction = 1.0 + error + shrinkage(error_alone, errors[i]) * own; // never negative
        return (unoccluded * correction / sums.kernel) * sums.light + cuts_.contact(i);  // (R5)
    });
}

GatheredSkylight gathered_skylight(const Scene& scene, const SurfaceTree& patches, const Sequence& sequence,
                                   std::uint64_t first_item, std::uint64_t rays, const RunControl& run)
{
    const std::uint32_t n = scene.patch_count();
    struct Group // the patches of one material on one side
    {
        double area = 0.0;     // [m^2]
        double expected = 0.0; // number of rays
        RaySums own;           // of them
        double found = 0.0;    // [m^2] sum of area times fraction
    };
    std::vector<Group> groups(2 * scene.materials().size());
    const auto group_of = [&](std::uint32_t i) -> Group& {
        return groups[2 * scene.file().material[scene.surface_of(i)] + (scene.is_front(i) ? 0 : 1)];
    };
    for (std::uint32_t i = 0; i < n; ++i)
        group_of(i).area += scene.is_sky_patch(i) ? 0.0 : scene.area(i);
    double sum = 0.0;
    for (Group& group : groups) { // at least a ray for each, so that its light is right on the average
        const double share = static_cast<double>(rays) * group.area / scene.own_area();
        group.expected = group.area > 0.0 ? std::max(1.0, share) : 0.0;
        sum += group.expected;
    }
    std::vector<double> expected(n);
    for (std::uint32_t i = 0; i < n; ++i)
        if (!scene.is_sky_patch(i))
            expected[i] = static_cast<double>(rays) / sum * group_of(i).expected * scene.area(i) / group_of(i).area;
    const Allotment allotment(expected, bits_to_unit(bits_from(sequence.item(first_item))));
    LineCounts counts(n);
    ShardRange range = ShardRange::of(ray_blocks(allotment).count(), {});
    count_rays(scene, allotment, sequence, first_item, range, run, counts);
    GatheredSkylight result{large_vector<Rgb>(n), large_vector<Rgb>(n)};
    if (run.stopped())
        return result;
    std::vector<RaySums> own = large_vector<RaySums>(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto cast = static_cast<double>(allotment.rays_of(i));
        const auto open = static_cast<double>(counts.escaped(i));
        own[i] = {cast, cast, open, open};
        group_of(i).own += own[i];
    }
    const std::vector<RaySums> around = pooled(patches, own, enough_rays, OwnRays::counted, run.threads);
    for (std::uint32_t i = 0; i < n; ++i)
        group_of(i).found += scene.area(i) * around[i].mean();
    const Rgb sky = scene.emittance(scene.first_patch(scene.own_surfaces()));
    for (std::uint32_t i = 0; i < n; ++i) {
        if (scene.is_sky_patch(i))
            continue;
        const Group& group = group_of(i);
        const double mean = group.own.mean();
        const double share = group.own.weight == 0.0 ? around[i].mean()
                             : group.found > 0.0     ? around[i].mean() * mean * group.area / group.found
                                                     : mean;
        result.incident[i] = (scene.area(i) * share) * sky;
        result.by_own_rays[i] = (scene.area(i) * quotient(own[i].value, expected[i])) * sky;
    }
    return result;
}

std::vector<Rgb> direct_radiosity(const Scene& scene, int threads)
{
    const std::uint32_t n = scene.patch_count();
    const std::unique_ptr<Sequence> sequence = make_sequence("sobol", 0);
    const SceneLights lights(scene, threads);
    GatheredLight light(scene, lights);
    // Smooth shadows look better than noise; of very many patches the eye averages several.
    const double rays = std::clamp(64.0 * n, 262144.0, std::max(4194304.0, 4.0 * n));
    std::uint64_t item = 0;
    for (const double share : {0.25, 0.75}) {
        std::vector<double> importance = share == 0.25 ? std::vector<double>(n, 1.0) : light.deviations();
        double sum = 0.0;
        for (std::uint32_t i = 0; i < n; ++i) {
            importance[i] *= light.unoccluded(i) > 0.0 ? std::sqrt(scene.area(i)) : 0.0;
            sum += importance[i];
        }
        for (double& expected : importance)
            expected = quotient(share * rays * expected, sum);
        const Allotment allotment(importance, 0.5);
        ShardRange range = ShardRange::of(GatheredLight::blocks(n).count(), {});
        light.cast(allotment, *sequence, item, range, {threads});
        item += allotment.rays();
    }
    std::vector<Rgb> incident = light.incident();
    if (scene.file().sky_surfaces > 0) {
        const std::vector<Rgb> sky =
            gathered_skylight(scene, lights.patches.get(), *sequence, item, static_cast<std::uint64_t>(rays), {threads})
                .incident;
        for (std::uint32_t i = 0; i < n; ++i)
            incident[i] += sky[i];
    }
    return parallel_list(n, threads, [&](std::uint32_t i) {
        return scene.first_light(i) + (1.0 / scene.area(i)) * (scene.reflectance(i) * incident[i]);
    });
}

} // namespace multipath

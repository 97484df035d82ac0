// A patch gets E G V from a light of emittance E. The exchange G without obstacles has a closed form for each point of
// the patch. V, the visible share, is taken from rays between points of both:
//
//   V ~ sum of w v / sum of w,   v = 1 where the ray is free, 0 where not,   w = cos cos' / (pi r^2)
//
// so a pair with nothing in between, or with nothing free, has no error. The first rays tell where the others are worth
// more. Where patch and light touch, w has no bound; there the density of the rays contains it. A ratio of sums of a
// few rays has a bias; there too.

#include "radiosity/reuse/gathered_light.h"

#include "parallel/blocks.h"
#include "radiosity/first_shot.h"
#include "radiosity/reuse/shadow_rays.h"
#include "sampling/random.h"
#include "sampling/sequence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace multipath {

namespace {

// A patch that gets the power P from a light of which it sees the share V adds rho^2 P^2 V (1 - V) / (A m) to the error
// (1) when m rays measure V. The sum over all pairs is smallest when m is proportional to
//
//   rho P sqrt(V (1 - V)) / sqrt(A)
//
// A few rays, alloted as if the root were the same everywhere, tell where it is not.

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

/// Shadow rays per pair, on the average, when nothing is known of what stands between: adds up to `rays`. Each pair
/// gets one at least, or an equal part of half the rays if these are too few.
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

/// Shadow rays per pair in addition, on the average, after those of the first allotment have found `sights`: more where
/// a patch sees a light in part, or where the patches around it do, or some of them and some not. What a pair itself
/// has found has a say only if it has many rays, so that the sum of both looks has no bias worth mentioning.
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

/// A number in [0, 1) that tells nothing of the item from which it is made.
double offset_from(const Item& item)
{
    return bits_to_unit(bits_from(item));
}

Rgb emitted_power(const Scene& scene, const std::vector<std::uint32_t>& surfaces)
{
    Rgb power;
    for (const std::uint32_t surface : surfaces)
        power += scene.surfaces()[surface].area() * surface_emittance(scene, surface);
    return power;
}

/// Emitting surfaces, the strongest first.
std::vector<std::uint32_t> lights_by_power(const Scene& scene)
{
    std::vector<std::uint32_t> lights;
    std::vector<double> power;
    for (std::uint32_t surface = 0; surface < scene.surfaces().size(); ++surface) {
        power.push_back(mean(emitted_power(scene, {surface})));
        if (power.back() > 0.0)
            lights.push_back(surface);
    }
    std::stable_sort(lights.begin(), lights.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return power[a] > power[b]; });
    return lights;
}

/// For how many lights gathering is worth its memory and its closed forms: with a ray for every other patch.
std::size_t lights_to_gather(const Scene& scene, std::size_t lights, std::uint64_t rays)
{
    constexpr std::uint64_t most_pairs = std::uint64_t{1} << 24; // half a gigabyte
    return static_cast<std::size_t>(
        std::min<std::uint64_t>(std::min(2 * rays, most_pairs) / scene.patch_count(), lights));
}

/// What gathering from some lights has found so far.
struct Gathering
{
    std::uint64_t looks_done = 0; ///< of two
    std::uint64_t lines = 0;      ///< rays cast by them
    std::vector<double> deserved; ///< rays of the look under way
    std::vector<Sight> sights;

    explicit Gathering(std::size_t pairs) : deserved(pairs), sights(pairs) {}

    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("looks done", looks_done);
        archive.value<std::uint64_t>("rays", lines);
        archive.list<double>("deserved", deserved);
        archive.list<double>("sights", sights);
    }
};

/// Sets the light that the patches get.
void gather_from(const std::vector<std::uint32_t>& lights, const Scene& scene, const Sequence& sequence,
                 std::uint64_t first_item, std::uint64_t rays, const RunControl& run, GatheredLight& light)
{
    const GatherPairs pairs = find_gather_pairs(scene, lights, run.threads);
    const auto pair_count = static_cast<double>(pairs.pairs.size());
    if (rays == 0 || pairs.pairs.empty()) {
        light.incident = pairs.contact;
        return;
    }
    const auto all_rays = static_cast<double>(rays);
    const double first_rays = all_rays >= 8.0 * pair_count ? 0.25 * all_rays : all_rays;
    const double offset = offset_from(sequence.item(first_item));
    const std::vector<double> first = first_allotment(scene, pairs, first_rays);
    const std::vector<Look> looks = choose_looks(scene, pairs, first);

    Gathering gathering(pairs.pairs.size());
    const Checkpoint::Part part(run.checkpoint, "gathering", [&](Archive& archive) { gathering.visit(archive); });
    const std::uint64_t looks_planned = first_rays < all_rays ? 2 : 1;
    for (bool under_way = part.resumed(); gathering.looks_done < looks_planned && !run.stopped(); under_way = false) {
        const double rest = all_rays - static_cast<double>(gathering.lines);
        if (!under_way)
            gathering.deserved = gathering.looks_done == 0
                                     ? first
                                     : second_allotment(scene, pairs, first, gathering.sights, rest, run.threads);
        const ShadowRays look = {gathering.deserved, offset, first_item + gathering.lines};
        gathering.lines += cast_shadow_rays(scene, pairs, looks, look, sequence, run, gathering.sights);
        ++gathering.looks_done;
    }
    light.lines = gathering.lines;
    light.incident = pairs.contact;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        for (std::size_t k = pairs.first_pair[patch]; k < pairs.first_pair[patch + 1]; ++k) {
            const double rarity = std::min(first[k], 1.0); // the ray of one such pair counts for those without
            const double exchange = static_cast<double>(pairs.pairs[k].exchange) * gathering.sights[k].share() / rarity;
            light.incident[patch] += exchange * surface_emittance(scene, lights[pairs.pairs[k].light]);
        }
}

/// Adds the light of surfaces that are shot, and what of it is lost.
void shoot_from(const std::vector<std::uint32_t>& lights, const Scene& scene, const Sequence& sequence,
                std::uint64_t first_item, std::uint64_t rays, const RunControl& run, GatheredLight& light)
{
    PowerState state = PowerState::empty(scene);
    for (const std::uint32_t surface : lights) {
        const std::uint32_t first = scene.first_patch(surface);
        for (std::uint32_t i = first; i < first + scene.tessellation(surface).cell_count(); ++i)
            state.unshot[i] = scene.area(i) * scene.emittance(i);
    }
    const double power = power_above(scene, state, 0.0);
    if (rays == 0 || !(power > 0.0))
        return;
    const ShotRule rule = {0.0, power / static_cast<double>(rays), offset_from(sequence.item(first_item))};
    const std::vector<Shot> shots = plan_shots(scene, state, rule);
    const Checkpoint::Part part(run.checkpoint, "shot lights", [&](Archive& archive) { state.visit(archive); });
    shoot(scene, sequence, first_item, shots, run, state);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        light.incident[i] += state.incident[i];
    light.lines += ray_count(shots);
    light.escaped += state.escaped;
    light.behind += state.behind;
}

/// Makes the patches and what is lost get just the power that was emitted [W], in one channel. `lost` is what rays from
/// the lights found lost; where none was, the power received is scaled.
void close_balance(double emitted, double& received_scale, double received, double& escaped, double& behind)
{
    const double lost = escaped + behind;
    const double missing = emitted - received;
    if (lost > 0.0 && missing > 0.0) {
        escaped *= missing / lost;
        behind *= missing / lost;
        received_scale = 1.0;
    } else {
        escaped = behind = 0.0;
        received_scale = received > 0.0 ? emitted / received : 0.0;
    }
}

/// What the rays from the lights found lost goes into `light`, with the received power made to fit.
void close_balance(Rgb emitted, const GatheredLight& from_lights, GatheredLight& light)
{
    Rgb received;
    for (const Rgb& incident : light.incident)
        received += incident;
    Rgb scale;
    light.escaped = from_lights.escaped;
    light.behind = from_lights.behind;
    close_balance(emitted.r, scale.r, received.r, light.escaped.r, light.behind.r);
    close_balance(emitted.g, scale.g, received.g, light.escaped.g, light.behind.g);
    close_balance(emitted.b, scale.b, received.b, light.escaped.b, light.behind.b);
    for (Rgb& incident : light.incident)
        incident = scale * incident;
    light.lines += from_lights.lines;
}

} // namespace

void receive(const GatheredLight& light, const Scene& scene, PowerState& state)
{
    const Rgb source = scene.source_power();
    Rgb found = light.escaped + light.behind;
    for (const Rgb& incident : light.incident)
        found += incident;
    const auto share_kept = [](double part, double whole) {
        constexpr double rounding = 1e-9;
        const double share = whole > 0.0 ? 1.0 - part / whole : 0.0;
        return share > rounding ? share : 0.0;
    };
    const Rgb kept = {share_kept(found.r, source.r), share_kept(found.g, source.g), share_kept(found.b, source.b)};
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        state.incident[i] += light.incident[i];
        state.unshot[i] = scene.reflectance(i) * light.incident[i] + kept * state.unshot[i];
    }
    state.escaped += light.escaped;
    state.behind += light.behind;
    state.emitted += found + kept * source - source; // rounding errors
}

double gathered_share(const Scene& scene, std::uint64_t rays)
{
    std::vector<std::uint32_t> lights = lights_by_power(scene);
    lights.resize(lights_to_gather(scene, lights.size(), rays));
    return mean(emitted_power(scene, lights)) / mean(scene.source_power());
}

GatheredLight gather_direct_light(const Scene& scene, const Sequence& sequence, std::uint64_t first_item,
                                  std::uint64_t rays, const RunControl& run)
{
    GatheredLight light;
    light.incident.resize(scene.patch_count());
    const std::vector<std::uint32_t> lights = lights_by_power(scene);
    const auto split = lights.begin() + static_cast<std::ptrdiff_t>(lights_to_gather(scene, lights.size(), rays));
    const std::vector<std::uint32_t> gathered(lights.begin(), split);
    const std::vector<std::uint32_t> shot(split, lights.end());
    const Rgb gathered_power = emitted_power(scene, gathered);
    const auto gathered_rays =
        static_cast<std::uint64_t>(gathered_share(scene, rays) * static_cast<double>(rays) + 0.5);
    constexpr std::uint64_t enough_to_see_an_opening = 32;
    const std::uint64_t rays_from_lights =
        std::max(gathered_rays / 16, std::min(gathered_rays / 2, enough_to_see_an_opening));

    enum Step : std::uint64_t { gathering, closing, shooting };
    std::uint64_t next_step = gathering;
    const Checkpoint::Part part(run.checkpoint, "direct light", [&](Archive& archive) {
        archive.value<std::uint64_t>("next step", next_step);
        archive.value<std::uint64_t>("rays", light.lines);
        archive.value<double>("escaped", light.escaped);
        archive.value<double>("behind", light.behind);
        archive.list<double>("incident", light.incident);
    });
    if (next_step == gathering) {
        gather_from(gathered, scene, sequence, first_item, gathered_rays - rays_from_lights, run, light);
        next_step += run.stopped() ? 0 : 1;
    }
    if (next_step == closing) {
        GatheredLight from_lights;
        from_lights.incident.resize(scene.patch_count());
        shoot_from(gathered, scene, sequence, first_item + light.lines, rays_from_lights, run, from_lights);
        if (!run.stopped()) {
            close_balance(gathered_power, from_lights, light);
            next_step = shooting;
        }
    }
    if (next_step == shooting)
        shoot_from(shot, scene, sequence, first_item + light.lines, rays - std::min(rays, light.lines), run, light);
    return light;
}

std::vector<Rgb> direct_radiosity(const Scene& scene, int threads)
{
    // Enough for shadows that are smooth to the eye, in a part of the time that a solution takes. Of very many patches
    // each needs less, since the eye sees several as one.
    const std::uint64_t rays = std::clamp<std::uint64_t>(std::uint64_t{64} * scene.patch_count(), 1u << 18, 1u << 22);
    const std::unique_ptr<Sequence> sequence = make_sequence("sobol", 0);
    PowerState state(scene);
    receive(gather_direct_light(scene, *sequence, 0, rays, {threads}), scene, state);
    return radiosity(scene, state);
}

} // namespace multipath

// A patch gets E G V from a light of emittance E. The exchange G without obstacles has a closed form for each point of
// the patch. V, the visible share, is taken from rays between points of both:
//
//   V ~ sum of w v / sum of w,   v = 1 where the ray is free, 0 where not,   w = cos cos' / (pi r^2)
//
// so a pair with nothing in between, or with nothing free, has no error. The first rays tell where the others are worth
// more. Where patch and light touch, w has no bound; there the density of the rays contains it. A ratio of sums of a
// few rays has a bias; there too.

#include "radiosity/gathered_light.h"

#include "radiosity/first_shot.h"
#include "radiosity/ray_allotment.h"
#include "sampling/random.h"

#include <algorithm>

namespace multipath {

namespace {

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

void gather_from(const std::vector<std::uint32_t>& lights, const Scene& scene, const Sequence& sequence,
                 std::uint64_t first_item, std::uint64_t rays, const RunControl& run, GatheredLight& light)
{
    const GatherPairs pairs = find_gather_pairs(scene, lights, run.threads);
    const auto pair_count = static_cast<double>(pairs.pairs.size());
    if (rays == 0 || pairs.pairs.empty())
        return;
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
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        for (std::size_t k = pairs.first_pair[patch]; k < pairs.first_pair[patch + 1]; ++k) {
            const double rarity = std::min(first[k], 1.0); // the ray of one such pair counts for those without
            const double exchange = static_cast<double>(pairs.pairs[k].exchange) * gathering.sights[k].share() / rarity;
            light.incident[patch] += exchange * surface_emittance(scene, lights[pairs.pairs[k].light]);
        }
}

/// Adds the light of surfaces that are shot.
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
    light.behind += state.behind;
}

} // namespace

void receive(const GatheredLight& light, const Scene& scene, bool found, PowerState& state)
{
    const Rgb source = scene.source_power();
    const Rgb kept = found ? Rgb{} : light.escaped;
    const auto share = [](double part, double whole) { return whole > 0.0 ? part / whole : 0.0; };
    const Rgb kept_share = {share(kept.r, source.r), share(kept.g, source.g), share(kept.b, source.b)};
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        state.incident[i] += light.incident[i];
        state.unshot[i] = scene.reflectance(i) * light.incident[i] + kept_share * state.unshot[i];
    }
    state.escaped += light.escaped - kept;
    state.behind += light.behind;
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
    const double gathered_share = mean(emitted_power(scene, gathered)) / mean(emitted_power(scene, lights));
    const auto gathering_rays = static_cast<std::uint64_t>(gathered_share * static_cast<double>(rays) + 0.5);

    std::uint64_t gathering_done = 0;
    const Checkpoint::Part part(run.checkpoint, "direct light", [&](Archive& archive) {
        archive.value<std::uint64_t>("gathering done", gathering_done);
        archive.value<std::uint64_t>("rays", light.lines);
        archive.list<double>("incident", light.incident);
    });
    if (gathering_done == 0)
        gather_from(gathered, scene, sequence, first_item, gathering_rays, run, light);
    if (!run.stopped()) {
        gathering_done = 1;
        shoot_from(shot, scene, sequence, first_item + light.lines, rays - std::min(rays, light.lines), run, light);
    }
    light.escaped = scene.source_power() - light.behind;
    for (const Rgb& incident : light.incident)
        light.escaped = light.escaped - incident;
    return light;
}

} // namespace multipath

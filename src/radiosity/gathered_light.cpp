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

} // namespace multipath

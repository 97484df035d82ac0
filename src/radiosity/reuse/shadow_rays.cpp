#include "radiosity/reuse/shadow_rays.h"

#include "geometry/form_factor/exchange_area.h"
#include "geometry/intersector/intersector.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/polygon.h"
#include "parallel/blocks.h"
#include "sampling/random.h"
#include "sampling/systematic_rounding.h"
#include "transport/exchange/contact.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace multipath {

namespace {

/// The pairs of some patches.
struct BlockOfPairs
{
    std::vector<GatherPair> pairs;
    std::vector<std::size_t> count; ///< per patch
    std::vector<Rgb> contact;       ///< per patch
};

/// [m^2] Of a light in the plane of the patch: its part that lies on the patch, if the two are in contact.
double contact_area(const Scene& scene, std::uint32_t patch, std::uint32_t light_surface, double touching)
{
    const Surface shape = scene.patch(patch).shape;
    const Surface& light = scene.surfaces()[light_surface];
    const bool opposite = dot(shape.normal(), light.normal()) < -1.0 + 1e-9;
    if (!opposite || !heights(polygon_of(shape), light.origin, light.normal()).within(touching))
        return 0.0;
    double area = 0.0;
    const std::uint32_t first = scene.first_patch(light_surface);
    for (std::uint32_t j = first; j < first + scene.tessellation(light_surface).cell_count(); ++j) {
        const double overlap = exchange_area(shape, scene.patch(j).shape, touching);
        if (overlap > 0.0 && in_contact(scene, patch, j))
            area += overlap;
    }
    return area;
}

BlockOfPairs pairs_of(const Scene& scene, const std::vector<std::uint32_t>& lights, std::uint32_t first,
                      std::uint32_t last)
{
    BlockOfPairs block;
    const double touching = coplanar_distance * scene.bounds().diagonal();
    for (std::uint32_t patch = first; patch < last; ++patch) {
        const std::size_t before = block.pairs.size();
        Rgb contact;
        for (std::uint32_t k = 0; k < lights.size(); ++k) {
            const LightPair pair = light_pair(scene, patch, lights[k]);
            const auto exchange = pair.faces() ? static_cast<float>(pair.exchange()) : 0.0f;
            if (exchange > 0.0f)
                block.pairs.push_back({k, exchange});
            else
                contact += contact_area(scene, patch, lights[k], touching) * surface_emittance(scene, lights[k]);
        }
        block.contact.push_back(contact);
        block.count.push_back(block.pairs.size() - before);
    }
    return block;
}

} // namespace

std::optional<std::size_t> GatherPairs::find(std::uint32_t patch, std::uint32_t light) const
{
    const auto begin = pairs.begin() + static_cast<std::ptrdiff_t>(first_pair[patch]);
    const auto end = pairs.begin() + static_cast<std::ptrdiff_t>(first_pair[patch + 1]);
    const auto found =
        std::lower_bound(begin, end, light, [](const GatherPair& pair, std::uint32_t l) { return pair.light < l; });
    if (found == end || found->light != light)
        return std::nullopt;
    return static_cast<std::size_t>(found - pairs.begin());
}

GatherPairs find_gather_pairs(const Scene& scene, std::vector<std::uint32_t> lights, int threads)
{
    constexpr std::uint32_t patches_per_block = 64;
    const Blocks patches = {scene.patch_count(), patches_per_block};
    GatherPairs result{std::move(lights), {}, {0}, {}};
    BlockBuffers<BlockOfPairs> blocks(threads);
    const auto find = [&](std::uint64_t number, int slot) {
        blocks[slot] = pairs_of(scene, result.lights, static_cast<std::uint32_t>(patches.first(number)),
                                static_cast<std::uint32_t>(patches.first(number + 1)));
    };
    const auto append = [&](std::uint64_t, int slot) {
        const BlockOfPairs& block = blocks[slot];
        result.pairs.insert(result.pairs.end(), block.pairs.begin(), block.pairs.end());
        result.contact.insert(result.contact.end(), block.contact.begin(), block.contact.end());
        for (const std::size_t count : block.count)
            result.first_pair.push_back(result.first_pair.back() + count);
    };
    ordered_blocks(patches.count(), threads, find, append);
    return result;
}

LightPair light_pair(const Scene& scene, std::uint32_t patch, std::uint32_t light_surface)
{
    const double clamp_area = std::max(scene.area(patch), scene.area(scene.first_patch(light_surface)));
    return LightPair(scene.patch(patch).shape, scene.surfaces()[light_surface], clamp_area);
}

Rgb surface_emittance(const Scene& scene, std::uint32_t surface)
{
    return scene.emittance(scene.first_patch(surface));
}

namespace {

constexpr std::uint32_t patches_per_block = 16;

/// The rays of one pair.
class PairSight
{
public:
    PairSight(const Scene& scene, std::uint32_t patch, std::uint32_t light_surface)
        : scene_(scene), patch_(patch), light_surface_(light_surface), pair_(light_pair(scene, patch, light_surface))
    {
    }

    void look(Look look, const std::vector<Item>& items, Sight& sight) const
    {
        for (const Item& item : items)
            if (look == Look::around)
                look_around(item, sight);
            else if (look == Look::at_all_points)
                look_at(pair_.points(item), pair_.kernel(pair_.points(item)), sight);
            else
                look_at(likely_points(item), 1.0, sight);
    }

private:
    void look_at(const LightPair::Points& points, double weight, Sight& sight) const
    {
        const Line ray = {points.on_receiver, points.on_light - points.on_receiver};
        const std::optional<Hit> hit = scene_.intersector().closest_hit_from(scene_.surface_of(patch_), ray);
        sight.all += weight;
        if (hit && hit->surface == light_surface_ && hit->front)
            sight.free += weight;
    }

    /// The density of the directions contains the kernel: all that would meet the light weigh the same.
    void look_around(const Item& item, Sight& sight) const
    {
        const Line ray = local_line(scene_.patch(patch_), item);
        if (const std::optional<Vec3> target = pair_.target(ray))
            look_at({ray.origin, *target}, 1.0, sight);
    }

    /// One of several candidates, with a probability proportional to its kernel.
    LightPair::Points likely_points(const Item& item) const
    {
        const std::uint64_t key = bits_from(item);
        std::uint64_t counter = 0;
        const auto random = [&] { return bits_to_unit(random_bits(key, counter++)); };
        LightPair::Points chosen = pair_.points(item);
        double sum = pair_.kernel(chosen);
        for (int candidate = 1; candidate < 16; ++candidate) {
            const LightPair::Points points = pair_.points({random(), random(), random(), random()});
            const double kernel = pair_.kernel(points);
            sum += kernel;
            if (random() * sum < kernel)
                chosen = points;
        }
        return chosen;
    }

    const Scene& scene_;
    std::uint32_t patch_;
    std::uint32_t light_surface_;
    LightPair pair_;
};

/// The sum before each patch; one entry more than patches.
std::vector<double> deserved_before(const GatherPairs& pairs, const std::vector<double>& deserved, double offset)
{
    std::vector<double> before;
    before.reserve(pairs.first_pair.size());
    double sum = offset;
    std::size_t k = 0;
    for (const std::size_t first : pairs.first_pair) {
        for (; k < first; ++k)
            sum += deserved[k];
        before.push_back(sum);
    }
    return before;
}

Look choose_look(const Scene& scene, std::uint32_t patch, const GatherPairs& pairs, std::size_t k, double rays)
{
    constexpr double many = 8.0;  // the bias of a ratio of two sums, about 1 / (2 rays), is then below its noise
    constexpr double wide = 0.05; // share of the directions in which the light is; fewer would mostly miss it
    if (rays < many)
        return Look::at_likely_points;
    const double width = static_cast<double>(pairs.pairs[k].exchange) / scene.area(patch);
    if (width < wide || !light_pair(scene, patch, pairs.lights[pairs.pairs[k].light]).is_near())
        return Look::at_all_points;
    return rays * width < many ? Look::at_likely_points : Look::around;
}

} // namespace

std::vector<Look> choose_looks(const Scene& scene, const GatherPairs& pairs, const std::vector<double>& rays)
{
    std::vector<Look> looks;
    looks.reserve(pairs.pairs.size());
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        for (std::size_t k = pairs.first_pair[patch]; k < pairs.first_pair[patch + 1]; ++k)
            looks.push_back(choose_look(scene, patch, pairs, k, rays[k]));
    return looks;
}

std::uint64_t cast_shadow_rays(const Scene& scene, const GatherPairs& pairs, const std::vector<Look>& looks,
                               const ShadowRays& rays, const Sequence& sequence, const RunControl& run,
                               std::vector<Sight>& sights)
{
    constexpr std::uint64_t most_items = 4096;
    const Blocks patches = {scene.patch_count(), patches_per_block};
    const std::vector<double> before = deserved_before(pairs, rays.deserved, rays.offset);
    const auto look_from = [&](std::uint32_t patch, std::vector<Item>& items) {
        double sum = before[patch];
        SystematicRounding rounding(sum); // goes on from the patch before
        for (std::size_t k = pairs.first_pair[patch]; k < pairs.first_pair[patch + 1]; ++k) {
            std::uint64_t ray = rounding.given();
            sum += rays.deserved[k];
            if (rounding.up_to(sum) == 0)
                continue;
            const PairSight pair(scene, patch, pairs.lights[pairs.pairs[k].light]);
            for (const std::uint64_t end = rounding.given(); ray < end; ray += items.size()) {
                items.resize(static_cast<std::size_t>(std::min(most_items, end - ray)));
                sequence.generate(rays.first_item + ray, items);
                pair.look(looks[k], items, sights[k]);
            }
        }
    };
    const auto first_patch = [&](std::uint64_t block) { return static_cast<std::uint32_t>(patches.first(block)); };
    std::uint64_t next_block = 0;
    const Checkpoint::Part part(run.checkpoint, "shadow rays",
                                [&](Archive& archive) { archive.value<std::uint64_t>("next block", next_block); });
    BlockBuffers<std::vector<Item>> items(run.threads);
    resumable_blocks(
        next_block, patches.count(), run,
        [&](std::uint64_t block, int slot) {
            for (std::uint32_t patch = first_patch(block); patch < first_patch(block + 1); ++patch)
                look_from(patch, items[slot]);
        },
        [&](std::uint64_t block, int) {
            run.count_lines(SystematicRounding(before[first_patch(block)]).up_to(before[first_patch(block + 1)]));
        });
    return SystematicRounding::whole(before[first_patch(next_block)]);
}

std::uint64_t bits_from(const Item& item)
{
    std::uint64_t mixed = 0;
    for (const double x : item) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        mixed = mix_bits(mixed ^ bits) + 1;
    }
    return mix_bits(mixed);
}

} // namespace multipath

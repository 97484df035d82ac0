#include "radiosity/gather_pairs.h"

#include "geometry/exchange_area.h"
#include "geometry/flat_polygon.h"
#include "parallel/ordered_blocks.h"
#include "transport/contact.h"

#include <algorithm>
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
    const std::uint32_t patches = scene.patch_count();
    GatherPairs result{std::move(lights), {}, {0}, {}};
    std::vector<BlockOfPairs> blocks(static_cast<std::size_t>(slot_count(threads)));
    const auto find = [&](std::uint64_t number, int slot) {
        const auto first = static_cast<std::uint32_t>(number * patches_per_block);
        blocks[static_cast<std::size_t>(slot)] =
            pairs_of(scene, result.lights, first, first + std::min(patches_per_block, patches - first));
    };
    const auto append = [&](std::uint64_t, int slot) {
        const BlockOfPairs& block = blocks[static_cast<std::size_t>(slot)];
        result.pairs.insert(result.pairs.end(), block.pairs.begin(), block.pairs.end());
        result.contact.insert(result.contact.end(), block.contact.begin(), block.contact.end());
        for (const std::size_t count : block.count)
            result.first_pair.push_back(result.first_pair.back() + count);
    };
    ordered_blocks((patches + patches_per_block - 1) / patches_per_block, threads, find, append);
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

} // namespace multipath

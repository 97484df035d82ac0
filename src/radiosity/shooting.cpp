#include "radiosity/shooting.h"

#include "parallel/ordered_blocks.h"
#include "radiosity/intersection_list.h"
#include "sampling/warp.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::uint64_t rays_per_block = 4096;

/// Rays number first ... of the whole list of shots, and the place in the list where they begin.
struct RayBlock
{
    std::vector<Item> items;
    std::vector<std::uint32_t> receivers;
};

/// Cumulative number of rays before each shot; one entry more than shots.
std::vector<std::uint64_t> rays_before(const std::vector<Shot>& shots)
{
    std::vector<std::uint64_t> before = {0};
    for (const Shot& shot : shots)
        before.push_back(before.back() + shot.rays);
    return before;
}

std::size_t shot_of_ray(const std::vector<std::uint64_t>& before, std::uint64_t ray)
{
    return static_cast<std::size_t>(std::upper_bound(before.begin(), before.end(), ray) - before.begin()) - 1;
}

void deposit(const Scene& scene, const Shot& shot, std::uint32_t receiver, PowerState& state)
{
    state.unshot[shot.patch] = state.unshot[shot.patch] - shot.power_per_ray;
    if (Segment::is_patch(receiver)) {
        state.incident[receiver] += shot.power_per_ray;
        state.unshot[receiver] += scene.reflectance(receiver) * shot.power_per_ray;
    } else {
        (receiver == Segment::behind ? state.behind : state.escaped) += shot.power_per_ray;
    }
}

} // namespace

Line local_line(const Patch& patch, const Item& item)
{
    // A ray must not start on the border itself, where rounding could put it outside a closed room.
    const auto inside = [](double x) { return std::clamp(x, 0x1p-30, 1.0 - 0x1p-30); };
    const Surface& shape = patch.shape;
    Barycentric place{inside(item[0]), inside(item[1])};
    if (shape.shape == Shape::triangle)
        place = square_to_uniform_triangle(place.u, place.v);

    const Vec3 normal = shape.normal();
    const Vec3 tangent = normalized(shape.edge_u);
    const Vec3 bitangent = cross(normal, tangent);
    const Vec3 local = square_to_cosine_hemisphere(item[2], item[3]);
    return {shape.at(place.u, place.v), local.x * tangent + local.y * bitangent + local.z * normal};
}

std::uint32_t receiver(const Scene& scene, std::uint32_t surface, const Line& ray)
{
    const std::optional<Hit> hit = scene.intersector().closest_hit_from(surface, ray);
    if (!hit)
        return Segment::outside;
    const std::uint32_t patch = scene.patch_at(hit->surface, hit->u, hit->v, hit->front);
    return patch == Scene::no_patch ? Segment::behind : patch;
}

void shoot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const std::vector<Shot>& shots,
           int threads, PowerState& state, const LineCounter& count_lines)
{
    const std::vector<std::uint64_t> before = rays_before(shots);
    const std::uint64_t ray_count = before.back();
    const std::uint64_t block_count = (ray_count + rays_per_block - 1) / rays_per_block;
    std::vector<RayBlock> blocks(static_cast<std::size_t>(slot_count(threads)));

    const auto trace = [&](std::uint64_t number, int slot) {
        RayBlock& block = blocks[static_cast<std::size_t>(slot)];
        const std::uint64_t first = number * rays_per_block;
        block.items.resize(static_cast<std::size_t>(std::min(rays_per_block, ray_count - first)));
        block.receivers.clear();
        sequence.generate(first_item + first, block.items);
        std::size_t shot = shot_of_ray(before, first);
        Patch patch = scene.patch(shots[shot].patch);
        for (std::size_t k = 0; k < block.items.size(); ++k) {
            if (first + k >= before[shot + 1]) {
                shot = shot_of_ray(before, first + k);
                patch = scene.patch(shots[shot].patch);
            }
            block.receivers.push_back(receiver(scene, patch.surface, local_line(patch, block.items[k])));
        }
    };
    const auto deposit_all = [&](std::uint64_t number, int slot) {
        const RayBlock& block = blocks[static_cast<std::size_t>(slot)];
        const std::uint64_t first = number * rays_per_block;
        std::size_t shot = shot_of_ray(before, first);
        for (std::size_t k = 0; k < block.receivers.size(); ++k) {
            if (first + k >= before[shot + 1])
                shot = shot_of_ray(before, first + k);
            deposit(scene, shots[shot], block.receivers[k], state);
        }
        count_lines(block.receivers.size());
    };
    ordered_blocks(block_count, threads, trace, deposit_all);
}

} // namespace multipath

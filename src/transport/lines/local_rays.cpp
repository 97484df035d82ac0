#include "transport/lines/local_rays.h"

#include "sampling/warp.h"
#include "sampling/warp_kernel.h"
#include "transport/lines/line_segments.h"

#include <algorithm>
#include <optional>

namespace multipath {

namespace {

/// A patch, and the frame in which the directions of its rays are given.
struct Sender
{
    Surface shape;
    ObliqueAxes axes;

    explicit Sender(const Patch& patch) : shape(patch.shape), axes(patch.shape, patch.shape.normal()) {}

    /// The ray of an item; `local`: its direction in the frame, square_to_cosine_hemisphere(item[2], item[3]).
    Line ray(const Item& item, Vec3 local) const
    {
        // A ray must not start on the border of the patch, where rounding could put it outside a closed room.
        const auto inside = [](double x) { return std::clamp(x, 0x1p-30, 1.0 - 0x1p-30); };
        return {square_to_uniform_surface(shape, inside(item[0]), inside(item[1])), axes.turned(local)};
    }
};

} // namespace

Line local_line(const Patch& patch, const Item& item)
{
    return Sender(patch).ray(item, square_to_cosine_hemisphere(item[2], item[3]));
}

void local_lines(const Scene& scene, const std::uint32_t* patches, const Item* items, std::size_t count, Line* lines)
{
    WarpedPoints local;
    std::optional<Sender> sender;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t lane = k % warp_block;
        if (lane == 0)
            warp_kernel().cosine_hemisphere(items + k, std::min(warp_block, count - k), 2, local);
        if (k == 0 || patches[k] != patches[k - 1])
            sender.emplace(scene.patch(patches[k]));
        lines[k] = sender->ray(items[k], local[lane]);
    }
}

std::uint32_t receiver(const Scene& scene, std::uint32_t surface, const Line& ray)
{
    const std::optional<Hit> hit = scene.intersector().closest_hit_from(surface, ray);
    return hit ? receiving_patch(scene, *hit) : Segment::outside;
}

std::uint32_t receiving_patch(const Scene& scene, const Hit& hit)
{
    const std::uint32_t patch = scene.patch_at(hit.surface, hit.u, hit.v, hit.front);
    return patch == Scene::no_patch ? Segment::behind : patch;
}

void RayBlock::trace(const Scene& scene)
{
    const std::size_t count = patches.size();
    surfaces_.resize(count);
    for (std::size_t k = 0; k < count; ++k)
        surfaces_[k] = scene.surface_of(patches[k]);
    lines_.resize(count);
    local_lines(scene, patches.data(), items.data(), count, lines_.data());
    scene.intersector().closest_hits_from(surfaces_.data(), lines_.data(), count, hits_);
    receivers.resize(count);
    for (std::size_t k = 0; k < count; ++k)
        receivers[k] = hits_.is_hit(k) ? receiving_patch(scene, hits_[k]) : Segment::outside;
}

} // namespace multipath

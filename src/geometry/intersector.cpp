// Few surfaces are all tested, in a loop that the compiler vectorises; many are found through a hierarchy. Both end in
// SurfaceTable::hit, so they agree to the last bit.

#include "geometry/intersector.h"

#include <algorithm>
#include <numeric>

namespace multipath {

namespace {

constexpr std::size_t few_surfaces = 96; // where testing all of them stops being faster than the hierarchy
constexpr std::uint32_t no_plane = 0xffffffffu;

/// Hits are computed on shared planes: a surface may be met a little beside where its corners say.
Bounds with_play(const Bounds& box, double play)
{
    const Vec3 margin = {play, play, play};
    return {box.low - margin, box.high + margin};
}

Bounds box_of(const std::vector<Surface>& surfaces)
{
    Bounds box;
    for (const Surface& surface : surfaces)
        box.include(surface.bounds());
    return widened(with_play(box, 2.0 * coplanar_distance * box.diagonal()));
}

std::vector<Bounds> boxes_of(const std::vector<Surface>& surfaces, double play)
{
    std::vector<Bounds> boxes;
    boxes.reserve(surfaces.size());
    for (const Surface& surface : surfaces)
        boxes.push_back(with_play(surface.bounds(), play));
    return boxes;
}

/// Smallest first; of equal ones the later.
std::vector<std::uint32_t> size_ranks(const std::vector<Surface>& surfaces)
{
    std::vector<double> areas;
    areas.reserve(surfaces.size());
    for (const Surface& surface : surfaces)
        areas.push_back(surface.area());
    std::vector<std::uint32_t> order(surfaces.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return areas[a] < areas[b] || (areas[a] == areas[b] && a > b); });
    std::vector<std::uint32_t> rank(surfaces.size());
    for (std::uint32_t place = 0; place < order.size(); ++place)
        rank[order[place]] = place;
    return rank;
}

/// The volume that the fronts of the surfaces bound from outside, negative for a room seen from inside (divergence
/// theorem). A room without one wall still counts as a room.
bool encloses(const std::vector<Surface>& surfaces, const Bounds& box)
{
    double volume = 0.0;
    for (const Surface& surface : surfaces)
        volume += surface.area() * dot(surface.normal(), surface.centre() - box.centre()) / 3.0;
    const double size = box.diagonal();
    return volume < -1e-9 * size * size * size;
}

bool may_meet(const Bounds& box, const Line& line)
{
    const Vec3 inverse = {1.0 / line.direction.x, 1.0 / line.direction.y, 1.0 / line.direction.z};
    const Slab slab = clip_to_box(box, line.origin, inverse, line.t_max);
    return slab.entry <= slab.exit;
}

} // namespace

Intersector::Intersector(const std::vector<Surface>& surfaces) : Intersector(surfaces, share_planes(surfaces)) {}

Intersector::Intersector(const std::vector<Surface>& surfaces, const SharedPlanes& planes)
    : table_(surfaces, planes),
      box_(box_of(surfaces)),
      bvh_(surfaces.size() > few_surfaces ? Bvh(boxes_of(surfaces, 2.0 * coplanar_distance * box_.diagonal())) : Bvh()),
      outside_is_solid_(encloses(surfaces, box_)),
      plane_(planes.plane_number),
      size_rank_(size_ranks(surfaces)),
      plane_is_shared_(planes.is_shared)
{
}

void Intersector::all_hits(const Line& line, std::vector<Hit>& hits) const
{
    hits.clear();
    const auto collect = [&](std::uint32_t surface) {
        if (const std::optional<Hit> hit = table_.hit(line, surface))
            hits.push_back(*hit);
    };
    if (!bvh_.empty())
        bvh_.for_each_met(
            line, [&] { return line.t_max; }, collect);
    else if (may_meet(box_, line)) // a third of the chords of the scene's sphere pass its box
        table_.for_each_candidate(line, collect);
    sort_along_line(hits);
    order_coincident_hits(hits, outside_is_solid_);
}

bool Intersector::comes_before(const Hit& a, const Hit& b) const
{
    return a.t < b.t || (a.t == b.t && size_rank_[a.surface] < size_rank_[b.surface]);
}

/// Insertion sort: a line meets a handful of surfaces.
void Intersector::sort_along_line(std::vector<Hit>& hits) const
{
    if (hits.size() > 64) {
        std::sort(hits.begin(), hits.end(), [this](const Hit& a, const Hit& b) { return comes_before(a, b); });
        return;
    }
    for (std::size_t i = 1; i < hits.size(); ++i) {
        const Hit moving = hits[i];
        std::size_t place = i;
        for (; place > 0 && comes_before(moving, hits[place - 1]); --place)
            hits[place] = hits[place - 1];
        hits[place] = moving;
    }
}

std::optional<Hit> Intersector::closest_hit(const Line& line) const
{
    return nearest(line, no_plane);
}

std::optional<Hit> Intersector::closest_hit_from(std::uint32_t from, const Line& ray) const
{
    // Where another face lies on the start, its place in the order of coincident faces decides whether the ray meets
    // it.
    if (plane_is_shared_[plane_[from]] && !coincident_surfaces(from, ray.origin).empty())
        return next_along_whole_line(from, ray);
    return nearest(ray, plane_[from]);
}

std::optional<Hit> Intersector::nearest(const Line& line, std::uint32_t excluded_plane) const
{
    std::optional<Hit> best;
    const auto limit = [&] { return best ? best->t : line.t_max; };
    const auto consider = [&](std::uint32_t surface) {
        if (plane_[surface] == excluded_plane)
            return;
        const std::optional<Hit> hit = table_.hit(line, surface);
        if (!hit)
            return;
        const bool on_top =
            best && hit->t == best->t && (hit->front != best->front ? hit->front : comes_before(*hit, *best));
        if (!best || hit->t < best->t || on_top)
            best = hit;
    };
    if (bvh_.empty())
        table_.for_each_candidate(line, consider);
    else
        bvh_.for_each_met(line, limit, consider);
    return best;
}

std::vector<std::uint32_t> Intersector::coincident_surfaces(std::uint32_t of, Vec3 point) const
{
    std::vector<std::uint32_t> found;
    const auto consider = [&](std::uint32_t surface) {
        if (surface != of && plane_[surface] == plane_[of] && table_.hit_at_point(point, {}, surface))
            found.push_back(surface);
    };
    if (bvh_.empty())
        for (std::uint32_t surface = 0; surface < table_.size(); ++surface)
            consider(surface);
    else
        bvh_.for_each_met(
            {point, {1.0, 1.0, 1.0}, 0.0}, [] { return 0.0; }, consider);
    return found;
}

std::optional<Hit> Intersector::next_along_whole_line(std::uint32_t from, const Line& ray) const
{
    const double reach = (box_.diagonal() + length(ray.origin - box_.centre())) / length(ray.direction);
    std::vector<Hit> hits;
    all_hits({ray.at(-reach), ray.direction}, hits);
    const auto own = std::find_if(hits.begin(), hits.end(), [&](const Hit& hit) { return hit.surface == from; });
    if (own == hits.end()) // rounding put the start beyond the border
        return nearest(ray, plane_[from]);
    const auto next = own + 1;
    if (next == hits.end())
        return std::nullopt;
    Hit result = *next;
    result.t = std::max(0.0, result.t - reach);
    return result;
}

} // namespace multipath

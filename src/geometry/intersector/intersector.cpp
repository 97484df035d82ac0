// Order of hits along a line, which of several hits at the same t comes first, and queries that are not about many
// lines. Those for one line are searches for a batch of one (batches.cpp).

#include "geometry/intersector/core.h"
#include "parallel/thread_memory.h"

#include <algorithm>

namespace multipath {

void Intersector::all_hits(const Line* lines, std::size_t count, HitLists& lists) const
{
    core_->all_hits(lines, count, lists);
}

void Intersector::all_hits(const Line& line, std::vector<Hit>& hits) const
{
    HitLists& lists = thread_memory<HitLists>();
    core_->all_hits(&line, 1, lists);
    hits.assign(lists[0].begin(), lists[0].end());
}

void Intersector::closest_hits_from(const std::uint32_t* from, const Line* rays, std::size_t count,
                                    FirstHits& found) const
{
    core_->find_first({from, nullptr, rays, count, found});
}

std::optional<Hit> Intersector::closest_hit_from(std::uint32_t from, const Line& ray) const
{
    FirstHits& found = thread_memory<FirstHits>();
    core_->find_first({&from, nullptr, &ray, 1, found});
    return found.is_hit(0) ? std::optional<Hit>(found[0]) : std::nullopt;
}

std::optional<Hit> Intersector::closest_hit(const Line& line) const
{
    return closest_hit_from(no_surface, line);
}

void Intersector::hits_on_targets(const std::uint32_t* from, const std::uint32_t* targets, const Line* rays,
                                  std::size_t count, FirstHits& found) const
{
    core_->find_first({from, targets, rays, count, found});
    for (std::size_t i = 0; i < count; ++i)
        found.is_hit_[i] = every(found.is_hit_[i] != 0, found.hits_[i].surface == targets[i]);
}

/// Sorts the hits of a line, including coincident ones. Most lines have a handful of hits: insertion sort.
void Intersector::Core::put_in_order(Hit* hits, std::size_t count) const
{
    constexpr std::size_t handful = 64;
    if (count > handful) {
        std::sort(hits, hits + count, [this](const Hit& a, const Hit& b) { return comes_before(a, b); });
        order_coincident(hits, count);
        return;
    }
    bool coincide = false;
    for (std::size_t i = 1; i < count; ++i) {
        const Hit moving = hits[i];
        std::size_t slot = i;
        for (; slot > 0 && comes_before(moving, hits[slot - 1]); --slot)
            hits[slot] = hits[slot - 1];
        hits[slot] = moving;
        coincide |= slot > 0 && hits[slot - 1].t == moving.t;
        coincide |= slot < i && hits[slot + 1].t == moving.t;
    }
    if (coincide)
        order_coincident(hits, count);
}

/// Orders hits with the same t as if there were no enclosing shell, which does not tell whether the line begins in the
/// open or, below a floor that is seen from its back, in a solid.
void Intersector::Core::order_coincident(Hit* hits, std::size_t count) const
{
    const auto is_inside = [this](const Hit& hit) { return hit.surface < first_enclosing_; };
    Hit* const first = std::find_if(hits, hits + count, is_inside);
    std::size_t inside = count - static_cast<std::size_t>(first - hits);
    while (inside > 0 && !is_inside(first[inside - 1]))
        --inside;
    order_coincident_hits(first, inside, outside_is_solid_, has_shell());
}

/// Updates `nearest` if the line meets the surface, unless it lies in the excluded plane.
void Intersector::Core::take_surface(const Line& line, std::uint32_t excluded_plane, std::uint32_t surface,
                                     NearestHit& nearest) const
{
    Hit hit;
    if (plane_[surface] == excluded_plane || !table_.decide(line, surface, hit) || hit.t > nearest.best.t)
        return;
    if (hit.t == nearest.best.t) {
        take_coincident(hit, nearest);
    } else {
        nearest.best = hit;
        nearest.has_back = false;
    }
}

/// Updates `nearest` with a hit at the same t as nearest.best. Of faces that look the same way the ray meets, as a
/// whole line does (order_coincident_hits), the first front or the last back.
void Intersector::Core::take_coincident(const Hit& hit, NearestHit& nearest) const
{
    if (hit.front == nearest.best.front) {
        nearest.best = comes_before(hit, nearest.best) == hit.front ? hit : nearest.best;
        return;
    }
    const Hit& back = hit.front ? nearest.best : hit;
    nearest.back = nearest.has_back && comes_before(back, nearest.back) ? nearest.back : back;
    nearest.has_back = true;
    nearest.best = hit.front ? hit : nearest.best;
}

/// Calls visit(surface) for all surfaces that may lie in the plane of a surface and contain a point of it.
template <class Visit>
void Intersector::Core::for_each_around(std::uint32_t of, Vec3 point, const Visit& visit) const
{
    if (neighbours_.is_listed(of)) {
        neighbours_.for_each_around(of, frame_.to_frame(point), visit);
        return;
    }
    for (const std::uint32_t surface : unfiltered_)
        visit(surface);
    const Vec3 place = frame_.to_frame(point);
    tree_.for_each_near({place, place}, [&](std::uint32_t surface) {
        visit(surface);
        return true;
    });
}

/// Calls visit(surface) for the surfaces that coincident_surfaces returns.
template <class Visit>
void Intersector::Core::for_each_coincident(std::uint32_t of, Vec3 point, const Visit& visit) const
{
    for_each_around(of, point, [&](std::uint32_t surface) {
        if (surface != of && plane_[surface] == plane_[of] && table_.holds(point, surface))
            visit(surface);
    });
}

/// True if another surface in the plane of `from` contains the point.
bool Intersector::Core::is_covered(std::uint32_t from, Vec3 point) const
{
    bool covered = false;
    for_each_coincident(from, point, [&](std::uint32_t) { covered = true; });
    return covered;
}

std::vector<std::uint32_t> Intersector::coincident_surfaces(std::uint32_t of, Vec3 point) const
{
    std::vector<std::uint32_t> found;
    core_->for_each_coincident(of, point, [&](std::uint32_t surface) { found.push_back(surface); });
    return found;
}

std::size_t Intersector::surfaces_around(std::uint32_t of, Vec3 point) const
{
    std::size_t count = 0;
    core_->for_each_around(of, point, [&](std::uint32_t) { ++count; });
    return count;
}

std::vector<std::uint32_t> Intersector::surfaces_near(const Bounds& box) const
{
    constexpr double rounding = 1e-6; // of coordinates in the frame, in single precision
    const Vec3 margin = {rounding, rounding, rounding};
    std::vector<std::uint32_t> found = core_->unfiltered_;
    core_->tree_.for_each_near({core_->frame_.to_frame(box.low) - margin, core_->frame_.to_frame(box.high) + margin},
                               [&](std::uint32_t surface) {
                                   found.push_back(surface);
                                   return true;
                               });
    return found;
}

/// A value of t at which the ray, followed forwards or backwards, has left the scene.
double Intersector::Core::reach_of(const Line& ray) const
{
    return (2.0 * frame_.radius() + length(ray.origin - frame_.centre())) / length(ray.direction);
}

std::optional<Hit> Intersector::hit_on(const Line& line, std::uint32_t surface) const
{
    Hit hit;
    return core_->table_.decide(line, surface, hit) ? std::optional<Hit>(hit) : std::nullopt;
}

bool Intersector::is_over(std::uint32_t a, std::uint32_t b) const
{
    return core_->is_over(a, b);
}

} // namespace multipath

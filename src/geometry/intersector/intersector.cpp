// Queries for one line. Filters in single precision test 16 surfaces at a time and leave a few candidates, which
// SurfaceTable decides in double precision. So the results are, to the last bit, those of testing all surfaces in
// double precision. In a small scene all surfaces are filtered; a large scene has a hierarchy, whose leaves are
// filtered.
//
// Rays that start on a surface ignore its plane. Only if another surface covers the start does the order of coincident
// faces matter: then the ray is extended backwards to the whole line, whose hits are found and ordered, and the hit
// after the ray's own surface is taken.

#include "geometry/intersector/core.h"

#include <algorithm>
#include <array>

namespace multipath {

namespace {

constexpr std::size_t flat_words = FlatSurfaces::most / 64;

} // namespace

FlatSurfaces Intersector::Core::flat_surfaces() const
{
    return {blocks_.data(),
            flat_plane_.data(),
            flat_number_.data(),
            flat_triangles_,
            static_cast<unsigned>(framed_.others.size()),
            static_cast<unsigned>(lane_number_.size()),
            framed_.frames.data(),
            static_cast<unsigned>(framed_.frames.size()),
            framed_.rectangles.data()};
}

/// Fills a batch with one line.
LineCourse Intersector::Core::place_one(const Line& line, LineBatch& batch) const
{
    FilterLine placed;
    const LineCourse course = frame_.place(line, placed);
    batch.put(0, placed, course);
    return course;
}

/// Calls visit(surface) for every surface that the line may meet: a small superset of those that it meets.
template <class Visit>
void Intersector::Core::for_each_candidate(const Line& line, const Visit& visit) const
{
    LineBatch batch;
    const LineCourse course = place_one(line, batch);
    if (course == LineCourse::unfit) {
        for (std::uint32_t surface = 0; surface < table_.size(); ++surface)
            visit(surface);
        return;
    }
    for (const std::uint32_t surface : unfiltered_)
        visit(surface);
    if (course == LineCourse::misses) // a third of the chords of the scene's sphere
        return;
    if (!tree_.empty()) {
        thread_local CandidateScratch work; // keeps its buffers
        constexpr std::uint32_t only = 0;
        search_tree(batch, &only, 1, work);
        for (std::size_t i = 0; i < work.found.count; ++i)
            visit(work.found.elements[i].surface);
        return;
    }
    std::array<std::uint64_t, flat_words> masks{};
    kernel_->filter_line(blocks_.data(), static_cast<std::uint32_t>(blocks_.size()), batch.line(0), masks.data());
    for (std::size_t word = 0; word < flat_words; ++word)
        for (std::uint64_t mask = masks[word]; mask != 0; mask &= mask - 1)
            visit(lane_number_[64 * word + static_cast<unsigned>(__builtin_ctzll(mask))]);
}

void Intersector::all_hits(const Line& line, std::vector<Hit>& hits) const
{
    core_->all_hits(line, hits);
}

void Intersector::Core::all_hits(const Line& line, std::vector<Hit>& hits) const
{
    hits.clear();
    for_each_candidate(line, [&](std::uint32_t surface) {
        Hit hit;
        if (table_.decide(line, surface, hit))
            hits.push_back(hit);
    });
    put_in_order(hits.data(), hits.size());
}

/// Sorts many hits by comes_before, with the keys copied into one array because the ranks are scattered in memory.
void Intersector::Core::sort_many(Hit* hits, std::size_t count) const
{
    struct Key
    {
        double t;
        std::uint32_t rank;
        std::uint32_t index;
    };
    std::vector<Key> keys(count);
    for (std::size_t i = 0; i < count; ++i)
        keys[i] = {hits[i].t, size_rank_[hits[i].surface], static_cast<std::uint32_t>(i)};
    std::sort(keys.begin(), keys.end(),
              [](const Key& a, const Key& b) { return a.t < b.t || (a.t == b.t && a.rank < b.rank); });
    const std::vector<Hit> unsorted(hits, hits + count);
    for (std::size_t i = 0; i < count; ++i)
        hits[i] = unsorted[keys[i].index];
}

/// Sorts the hits of a line, including coincident ones. Most lines have a handful of hits: insertion sort.
void Intersector::Core::put_in_order(Hit* hits, std::size_t count) const
{
    constexpr std::size_t handful = 64;
    if (count > handful) {
        sort_many(hits, count);
        order_coincident_hits(hits, count, outside_is_solid_);
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
        order_coincident_hits(hits, count, outside_is_solid_);
}

std::optional<Hit> Intersector::closest_hit(const Line& line) const
{
    return core_->nearest(line, Core::no_plane);
}

std::optional<Hit> Intersector::closest_hit_from(std::uint32_t from, const Line& ray) const
{
    // If another face covers the start, the order of coincident faces decides whether the ray meets it.
    if (!core_->is_covered(from, ray.origin))
        return core_->nearest(ray, core_->plane_[from]);
    std::vector<Hit> along;
    all_hits(core_->whole_line(ray), along);
    return core_->next_along(along, from, ray);
}

/// True if another surface in the plane of `from` contains the point.
bool Intersector::Core::is_covered(std::uint32_t from, Vec3 point) const
{
    bool covered = false;
    for_each_coincident(from, point, [&](std::uint32_t) { covered = true; });
    return covered;
}

/// Updates `nearest` with a hit.
void Intersector::Core::take(const Hit& hit, NearestHit& nearest) const
{
    if (hit.t < nearest.best.t) {
        nearest.best = hit;
        nearest.has_back = false;
    } else if (hit.t == nearest.best.t) {
        take_coincident(hit, nearest);
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

/// First hit of a line, ignoring the surfaces in one plane.
std::optional<Hit> Intersector::Core::nearest(const Line& line, std::uint32_t excluded_plane) const
{
    NearestHit nearest;
    LineBatch batch;
    if (!tree_.empty() && unfiltered_.empty() && place_one(line, batch) == LineCourse::passes) {
        thread_local FirstHitScratch work; // keeps its buffers
        work.rays.assign(1, searched_ray(0, excluded_plane));
        work.nearest.assign(1, nearest);
        search_first(batch, &line, false, work);
        nearest = work.nearest[0];
    } else {
        for_each_candidate(line, [&](std::uint32_t surface) {
            Hit hit;
            if (plane_[surface] != excluded_plane && table_.decide(line, surface, hit))
                take(hit, nearest);
        });
    }
    return first_of(nearest, line, excluded_plane);
}

/// Chooses between the front and the back that a ray meets at the same t: the front, unless the two have different
/// outlines (a floor seen from below with an object on it). Then the order along the whole line decides, as in
/// all_hits.
std::optional<Hit> Intersector::Core::first_of(const NearestHit& nearest, const Line& line,
                                               std::uint32_t excluded_plane) const
{
    if (!nearest.is_hit())
        return std::nullopt;
    if (!nearest.has_back || excluded_plane == no_plane || have_same_outline(nearest.best, nearest.back))
        return nearest.best;
    std::vector<Hit> along;
    all_hits(whole_line(line), along);
    const auto best =
        std::find_if(along.begin(), along.end(), [&](const Hit& hit) { return hit.surface == nearest.best.surface; });
    for (auto hit = along.begin(); hit != best && best != along.end(); ++hit) {
        Hit result;
        if (hit->t == best->t && plane_[hit->surface] != excluded_plane && table_.decide(line, hit->surface, result) &&
            result.t == nearest.best.t)
            return result;
    }
    return nearest.best;
}

/// Calls visit(surface) for all surfaces that may lie in the plane of a surface and contain a point of it.
template <class Visit>
void Intersector::Core::for_each_around(std::uint32_t of, Vec3 point, const Visit& visit) const
{
    if (neighbours_.is_listed(of)) {
        neighbours_.for_each_around(of, frame_.to_frame(point), visit);
        return;
    }
    if (tree_.empty())
        for (std::uint32_t surface = 0; surface < table_.size(); ++surface)
            visit(surface);
    else
        for (const std::uint32_t surface : unfiltered_)
            visit(surface);
    tree_.for_each_around(frame_.to_frame(point), [&](std::uint32_t surface) {
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

std::size_t Intersector::surfaces_around(std::uint32_t of, Vec3 point) const
{
    std::size_t count = 0;
    core_->for_each_around(of, point, [&](std::uint32_t) { ++count; });
    return count;
}

std::vector<std::uint32_t> Intersector::coincident_surfaces(std::uint32_t of, Vec3 point) const
{
    std::vector<std::uint32_t> found;
    core_->for_each_coincident(of, point, [&](std::uint32_t surface) { found.push_back(surface); });
    return found;
}

std::optional<std::vector<std::uint32_t>> Intersector::surfaces_near(const Bounds& box) const
{
    if (core_->tree_.empty())
        return std::nullopt;
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

Line Intersector::Core::whole_line(const Line& ray) const
{
    return {ray.at(-reach_of(ray)), ray.direction};
}

/// The hit after surface `from` along the whole line of a ray, as a hit of the ray.
std::optional<Hit> Intersector::Core::next_along(HitLists::List whole_line, std::uint32_t from, const Line& ray) const
{
    const auto own =
        std::find_if(whole_line.begin(), whole_line.end(), [&](const Hit& hit) { return hit.surface == from; });
    if (own == whole_line.end()) // by rounding the start lies outside of its surface
        return nearest(ray, plane_[from]);
    const auto next = own + 1;
    if (next == whole_line.end())
        return std::nullopt;
    Hit result = *next;
    result.t = std::max(0.0, result.t - reach_of(ray));
    return result;
}

std::optional<Hit> Intersector::hit_on(const Line& line, std::uint32_t surface) const
{
    Hit hit;
    return core_->table_.decide(line, surface, hit) ? std::optional<Hit>(hit) : std::nullopt;
}

bool Intersector::is_over(std::uint32_t a, std::uint32_t b) const
{
    return core_->size_rank_[a] < core_->size_rank_[b];
}

} // namespace multipath

// Lines are filtered in single precision, 16 surfaces at a time, and the few surfaces left are decided in double
// precision by SurfaceTable, so that the results are those of deciding all surfaces, to the last bit. Few surfaces are
// all filtered; many are found through a hierarchy, whose leaves are filtered.

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

/// Calls visit(surface) for every surface that the line may meet: all that it does and hardly any other.
template <class Visit>
void Intersector::Core::for_each_candidate(const Line& line, const Visit& visit) const
{
    FilterLine placed;
    const LineCourse course = frame_.place(line, placed);
    if (course == LineCourse::unfit) {
        for (std::uint32_t surface = 0; surface < table_.size(); ++surface)
            visit(surface);
        return;
    }
    for (const std::uint32_t surface : unfiltered_)
        visit(surface);
    if (course == LineCourse::misses) // as a third of the chords of the scene's sphere do
        return;
    if (!tree_.empty()) {
        struct Context
        {
            const std::uint32_t* number;
            const Visit& visit;
        } context{lane_number_.data(), visit};
        const auto visit_blocks = [](void* pointer, const BlockLanes* found, unsigned count) {
            const Context& in = *static_cast<const Context*>(pointer);
            for (unsigned i = 0; i < count; ++i)
                for (unsigned lanes = found[i].lanes; lanes != 0; lanes &= lanes - 1)
                    in.visit(
                        in.number[SurfaceBlock::lanes * found[i].block + static_cast<unsigned>(__builtin_ctz(lanes))]);
        };
        kernel_->visit_all(tree_.nodes(), blocks_.data(), placed, visit_blocks, &context);
        return;
    }
    std::array<std::uint64_t, flat_words> masks{};
    kernel_->filter_line(blocks_.data(), static_cast<std::uint32_t>(blocks_.size()), placed, masks.data());
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

/// As comes_before, with the keys side by side: ranks are far apart in memory.
void Intersector::Core::sort_many(Hit* hits, std::size_t count) const
{
    struct Key
    {
        double t;
        std::uint32_t rank;
        std::uint32_t place;
    };
    std::vector<Key> keys(count);
    for (std::size_t i = 0; i < count; ++i)
        keys[i] = {hits[i].t, size_rank_[hits[i].surface], static_cast<std::uint32_t>(i)};
    std::sort(keys.begin(), keys.end(),
              [](const Key& a, const Key& b) { return a.t < b.t || (a.t == b.t && a.rank < b.rank); });
    const std::vector<Hit> unsorted(hits, hits + count);
    for (std::size_t i = 0; i < count; ++i)
        hits[i] = unsorted[keys[i].place];
}

/// Insertion sort, since most lines meet a handful of surfaces.
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
        std::size_t place = i;
        for (; place > 0 && comes_before(moving, hits[place - 1]); --place)
            hits[place] = hits[place - 1];
        hits[place] = moving;
        coincide |= place > 0 && hits[place - 1].t == moving.t;
        coincide |= place < i && hits[place + 1].t == moving.t;
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
    // Where another face lies on the start, the order of coincident faces decides whether the ray meets it.
    if (!core_->is_covered(from, ray.origin))
        return core_->nearest(ray, core_->plane_[from]);
    std::vector<Hit> along;
    all_hits(core_->whole_line(ray), along);
    return core_->next_along(along, from, ray);
}

bool Intersector::Core::is_covered(std::uint32_t from, Vec3 point) const
{
    bool covered = false;
    for_each_coincident(from, point, [&](std::uint32_t) { covered = true; });
    return covered;
}

/// Keeps the first of the hits it is shown.
struct Intersector::Core::Nearest
{
    const Core& all;
    const Line& line;
    std::uint32_t excluded_plane;
    double middle_t = 0.0;
    float limit = 0.0f;
    Hit best = {};
    bool found = false;
    Hit back = {}; ///< the first that is met from behind where the best is met, from the front
    bool has_back = false;

    void consider(std::uint32_t surface)
    {
        Hit hit;
        if (all.plane_[surface] == excluded_plane || !all.table_.decide(line, surface, hit))
            return;
        if (!found || hit.t < best.t) {
            best = hit;
            has_back = false;
        } else if (hit.t == best.t) {
            take_coincident(hit);
        }
        found = true;
    }

    void take_coincident(const Hit& hit)
    {
        if (hit.front == best.front) {
            best = all.comes_before(hit, best) ? hit : best;
            return;
        }
        const Hit& behind = hit.front ? best : hit;
        back = has_back && all.comes_before(back, behind) ? back : behind;
        has_back = true;
        best = hit.front ? hit : best;
    }

    static float visit_block(void* self, std::uint32_t block, unsigned lanes)
    {
        Nearest& nearest = *static_cast<Nearest*>(self);
        for (; lanes != 0; lanes &= lanes - 1)
            nearest.consider(
                nearest.all.lane_number_[SurfaceBlock::lanes * block + static_cast<unsigned>(__builtin_ctz(lanes))]);
        if (nearest.found)
            nearest.limit = std::min(nearest.limit, static_cast<float>(nearest.best.t - nearest.middle_t));
        return nearest.limit;
    }
};

std::optional<Hit> Intersector::Core::nearest(const Line& line, std::uint32_t excluded_plane) const
{
    FilterLine placed;
    if (!tree_.empty() && unfiltered_.empty() && frame_.place(line, placed) == LineCourse::passes)
        return nearest_in_tree(line, placed, excluded_plane);
    Nearest nearest{*this, line, excluded_plane};
    for_each_candidate(line, [&](std::uint32_t surface) { nearest.consider(surface); });
    return first_of(nearest);
}

std::optional<Hit> Intersector::Core::nearest_in_tree(const Line& line, const FilterLine& placed,
                                                      std::uint32_t excluded_plane) const
{
    Nearest nearest{*this, line, excluded_plane, placed.middle_t, placed.half_length};
    kernel_->visit_nearest(tree_.nodes(), blocks_.data(), placed, Nearest::visit_block, &nearest);
    return first_of(nearest);
}

/// At one place a front is met before a back. Where a ray meets faces of unlike outline, as from below a floor on which
/// something stands, the order along the whole line decides, as it does for lines.
std::optional<Hit> Intersector::Core::first_of(const Nearest& nearest) const
{
    if (!nearest.found)
        return std::nullopt;
    if (!nearest.has_back || nearest.excluded_plane == no_plane || have_same_outline(nearest.best, nearest.back))
        return nearest.best;
    std::vector<Hit> along;
    all_hits(whole_line(nearest.line), along);
    const auto best =
        std::find_if(along.begin(), along.end(), [&](const Hit& hit) { return hit.surface == nearest.best.surface; });
    for (auto hit = along.begin(); hit != best && best != along.end(); ++hit) {
        Hit result;
        if (hit->t == best->t && plane_[hit->surface] != nearest.excluded_plane &&
            table_.decide(nearest.line, hit->surface, result) && result.t == nearest.best.t)
            return result;
    }
    return nearest.best;
}

/// Calls visit(surface) for all that may share the plane of a surface and hold a point of it.
template <class Visit>
void Intersector::Core::for_each_around(std::uint32_t of, Vec3 point, const Visit& visit) const
{
    if (neighbours_.is_listed(of)) {
        neighbours_.for_each(of, visit);
        return;
    }
    if (tree_.empty())
        for (std::uint32_t surface = 0; surface < table_.size(); ++surface)
            visit(surface);
    else
        for (const std::uint32_t surface : unfiltered_)
            visit(surface);
    tree_.for_each_around(frame_.to_frame(point), visit);
}

/// Calls visit(surface) for what coincident_surfaces lists.
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
    constexpr double rounding = 1e-6; // of the frame's coordinates, in single precision
    const Vec3 margin = {rounding, rounding, rounding};
    std::vector<std::uint32_t> found = core_->unfiltered_;
    core_->tree_.for_each_near({core_->frame_.to_frame(box.low) - margin, core_->frame_.to_frame(box.high) + margin},
                               [&](std::uint32_t surface) { found.push_back(surface); });
    return found;
}

double Intersector::Core::reach_of(const Line& ray) const
{
    return (2.0 * frame_.radius() + length(ray.origin - frame_.centre())) / length(ray.direction);
}

Line Intersector::Core::whole_line(const Line& ray) const
{
    return {ray.at(-reach_of(ray)), ray.direction};
}

std::optional<Hit> Intersector::Core::next_along(HitLists::List whole_line, std::uint32_t from, const Line& ray) const
{
    const auto own =
        std::find_if(whole_line.begin(), whole_line.end(), [&](const Hit& hit) { return hit.surface == from; });
    if (own == whole_line.end()) // rounding put the start beyond the border
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

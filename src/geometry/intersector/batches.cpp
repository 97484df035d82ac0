// Searches for many lines at a time, in phases, each of which does one thing for a batch of lines. All hits: the lines
// are placed in the frame; filters in single precision leave a few candidates; double precision decides these
// (SurfaceTable); the hits are put in order. So the results are, to the last bit, those of testing all surfaces in
// double precision. Surfaces that cannot be filtered are candidates of every line, and all surfaces are candidates of a
// line that cannot be filtered.

#include "geometry/intersector/core.h"
#include "parallel/thread_memory.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace multipath {

/// Places as many of the lines as are searched together, and returns their number: lines that can be filtered, or a
/// single line that cannot.
std::size_t Intersector::Core::place_lines(const Line* lines, std::size_t count, LineBatch& batch) const
{
    constexpr std::size_t most_unfiltered = 1u << 16; // candidates, so that memory stays limited
    const std::size_t most =
        std::clamp<std::size_t>(most_unfiltered / (unfiltered_.size() + 1), 1, std::min(count, LineBatch::most));
    kernel_->place_lines(frame_, lines, most, batch);
    const auto* const unfit = std::find(batch.course, batch.course + most, LineCourse::unfit);
    return std::max<std::size_t>(1, static_cast<std::size_t>(unfit - batch.course));
}

void Intersector::Core::all_hits(const Line* lines, std::size_t count, HitLists& lists) const
{
    CandidateBuffers& work = thread_memory<CandidateBuffers>();
    lists.end_.assign(count, 0);
    std::size_t begin = 0; // of the hits of the batch
    for (std::size_t first = 0; first < count;) {
        const std::size_t together = place_lines(lines + first, count - first, work.batch);
        find_candidates(together, work);
        const std::size_t room = begin + work.candidates.size() + 1;
        if (lists.hits_.size() < room)
            lists.hits_.resize(2 * room);
        std::size_t* const ends = lists.end_.data() + first;
        kernel_->decide_candidates(table_, lines + first, work.candidates.data(), work.candidates.size(),
                                   lists.hits_.data() + begin, ends);
        std::size_t from = begin;
        for (std::size_t i = 0; i < together; ++i) {
            const std::size_t to = std::max(from, begin + ends[i]);
            if (to > from + 1)
                put_in_order(lists.hits_.data() + from, to - from);
            ends[i] = from = to;
        }
        begin = from;
        first += together;
    }
}

/// Lists the surfaces that each of the first `count` lines of the batch may meet.
void Intersector::Core::find_candidates(std::size_t count, CandidateBuffers& work) const
{
    if (work.batch.course[0] == LineCourse::unfit) {
        work.candidates.clear();
        for (std::uint32_t surface = 0; surface < table_.size(); ++surface)
            work.candidates.push_back({0, surface});
        return;
    }
    work.passing.resize(count);
    std::size_t passing = 0;
    for (std::uint32_t i = 0; i < count; ++i) { // branch-free: whether a line passes is hard to predict
        work.passing[passing] = i;
        passing += work.batch.passes(i);
    }
    work.passing.resize(passing);
    const bool by_line = filters_all(count);
    if (by_line)
        filter_few(count, work);
    else
        search_tree(work);
    for (const std::uint32_t surface : unfiltered_)
        for (std::uint32_t line = 0; line < count; ++line)
            work.found.push_back({line, surface});
    if (count == 1 || (by_line && unfiltered_.empty())) { // already sorted
        work.candidates.swap(work.found);
        return;
    }
    std::array<std::size_t, LineBatch::most + 1> slot{}; // counting sort by line: slot of its next candidate
    for (const LineCandidate& candidate : work.found)
        ++slot[candidate.line + 1];
    std::partial_sum(slot.begin(), slot.end(), slot.begin());
    work.candidates.resize(work.found.size());
    for (const LineCandidate& candidate : work.found)
        work.candidates[slot[candidate.line]++] = candidate;
}

/// True if so many lines are tested against all surfaces sooner than searched in the hierarchy. A few lines are not,
/// because all lanes of a vector take as long as one.
bool Intersector::Core::filters_all(std::size_t lines) const
{
    constexpr std::size_t per_line = 32; // surfaces that are tested while one line is searched
    return is_few_ && (per_line * lines >= flat_.count || tree_.empty());
}

/// Finds the candidates of the passing lines among all surfaces, line by line.
void Intersector::Core::filter_few(std::size_t count, CandidateBuffers& work) const
{
    const unsigned words = (flat_.count + 31) / 32;
    kernel_->filter_flat(flat_, work.batch, count, work.marks);
    work.found.resize(work.passing.size() * flat_.count);
    LineCandidate* next = work.found.data();
    for (const std::uint32_t line : work.passing)
        for (unsigned word = 0; word < words; ++word)
            for (std::uint32_t marks = work.marks.word[word][line]; marks != 0; marks &= marks - 1)
                *next++ = {line, flat_surface_[32 * word + static_cast<unsigned>(__builtin_ctz(marks))]};
    work.found.resize(static_cast<std::size_t>(next - work.found.data()));
}

/// Finds the candidates of the passing lines in the hierarchy, in any order.
void Intersector::Core::search_tree(CandidateBuffers& work) const
{
    constexpr std::size_t least_room = CandidateSearch::least_room;
    const std::size_t count = work.passing.size();
    work.tree_lines.resize(count);
    work.pending.resize(std::max(work.pending.size(), count + least_room));
    work.found.resize(std::max(work.found.capacity(), least_room));
    kernel_->fill_tree_lines(work.batch, work.passing.data(), count, work.tree_lines.data());
    for (std::uint32_t i = 0; i < count; ++i)
        work.pending[i] = {i, 0};
    CandidateSearch search{work.tree_lines.data(), nullptr, count, 0, nullptr, 0, 0};
    while (search.pending_count > 0) {
        if (work.pending.size() < search.pending_count + least_room)
            work.pending.resize(2 * work.pending.size());
        if (work.found.size() < search.candidate_count + least_room)
            work.found.resize(2 * work.found.size());
        search.pending = work.pending.data();
        search.pending_room = work.pending.size();
        search.candidates = work.found.data();
        search.candidate_room = work.found.size();
        kernel_->find_candidates(tree_view(), search);
    }
    work.found.resize(search.candidate_count);
}

// First hits of many rays, in the same phases. In a small scene a filter finds, for every ray, the surface that may
// come first and a lower bound of t for all others. Only this surface is decided: it is the first hit if its t is below
// the bound. For the rare other rays all candidates are decided. Else the hierarchy is searched in order of distance.
//
// Rays that start on a surface ignore its plane. If another surface covers the start, the order of coincident faces
// matters: then the ray is extended backwards to the whole line, whose hits are found and ordered, and the hit after
// the ray's own surface is taken. The order along the whole line also decides between a front and a back with different
// outlines that a ray meets at the same t (a floor seen from below with an object on it).

void Intersector::Core::find_first(const RayQuery& query) const
{
    FirstHitBuffers& work = thread_memory<FirstHitBuffers>();
    query.found.resize(query.count);
    work.undecided.clear();
    work.ties.clear();
    find_covered(query, work.covered);
    for (std::size_t first = 0; first < query.count;) {
        const std::size_t count = place_lines(query.rays + first, query.count - first, work.batch);
        const bool is_fit = work.batch.course[0] != LineCourse::unfit;
        if (is_fit && !filters_all(count))
            find_first_in_tree(query, first, count, work);
        else if (is_fit && unfiltered_.empty())
            find_first_by_bounds(query, first, count, work);
        else
            for (std::size_t i = 0; i < count; ++i)
                work.undecided.push_back(first + i);
        first += count;
    }
    find_first_of_undecided(query, work);
    order_ties(query, work);
    find_first_of_covered(query, work);
    find_first_of_undecided(query, work);
    order_ties(query, work);
}

/// First hits in a small scene; lists the rays that the bounds leave undecided.
void Intersector::Core::find_first_by_bounds(const RayQuery& query, std::size_t first, std::size_t count,
                                             FirstHitBuffers& work) const
{
    alignas(64) std::array<float, LineBatch::most> own_plane{};
    for (std::size_t i = 0; i < count; ++i)
        own_plane[i] = static_cast<float>(plane_of(query.from[first + i]));
    NearestCandidates candidates;
    kernel_->nearest_flat(flat_, work.batch, count, own_plane.data(), candidates);
    std::array<std::uint32_t, LineBatch::most> surface;
    for (std::size_t i = 0; i < count; ++i)
        surface[i] = flat_surface_[static_cast<std::size_t>(candidates.number[i])];
    Hit* const hits = query.found.hits_.data() + first;
    std::uint32_t* const is_hit = query.found.is_hit_.data() + first;
    kernel_->decide_nearest(table_, query.rays + first, surface.data(), count, hits, is_hit);
    for (std::size_t i = 0; i < count; ++i) {
        const bool passes = work.batch.passes(i);
        const bool alone = candidates.second[i] == FlatSurfaces::never;
        const double second = work.batch.middle_t[i] + static_cast<double>(candidates.second[i]);
        is_hit[i] = every(passes, candidates.first[i] < FlatSurfaces::never, is_hit[i] != 0);
        if (!any(!passes, alone, every(is_hit[i] != 0, hits[i].t < second)))
            work.undecided.push_back(first + i);
    }
}

/// The first hits of the undecided rays, of all their candidates.
void Intersector::Core::find_first_of_undecided(const RayQuery& query, FirstHitBuffers& work) const
{
    work.lines.clear();
    for (const std::size_t ray : work.undecided)
        work.lines.push_back(query.rays[ray]);
    for (std::size_t first = 0; first < work.undecided.size();) {
        const Line* const lines = work.lines.data() + first;
        const std::size_t* const rays = work.undecided.data() + first;
        const std::size_t count = place_lines(lines, work.undecided.size() - first, work.candidates.batch);
        find_candidates(count, work.candidates);
        work.nearest.assign(count, NearestHit());
        for (const auto& [line, surface] : work.candidates.candidates)
            take_surface(lines[line], plane_of(query.from[rays[line]]), surface, work.nearest[line]);
        for (std::size_t i = 0; i < count; ++i)
            put(query, rays[i], work.nearest[i], work.ties);
        first += count;
    }
}

/// First hits by a search in the hierarchy, but not of rays whose start is covered. With targets, only rays that meet
/// their targets are searched, and only up to them.
void Intersector::Core::find_first_in_tree(const RayQuery& query, std::size_t first, std::size_t count,
                                           FirstHitBuffers& work) const
{
    const Line* const rays = query.rays + first;
    const std::uint32_t* const targets = query.targets == nullptr ? nullptr : query.targets + first;
    const Hit* const hits = query.found.hits_.data() + first;
    work.searched.clear();
    work.nearest.assign(count, NearestHit());
    if (targets != nullptr) {
        for (std::size_t i = 0; i < count; ++i)
            prefetch_all(table_.row(targets[i]));
        kernel_->decide_nearest(table_, rays, targets, count, query.found.hits_.data() + first,
                                query.found.is_hit_.data() + first);
    }
    auto covered = std::lower_bound(work.covered.begin(), work.covered.end(), first);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (covered != work.covered.end() && *covered == first + i) {
            ++covered;
            continue;
        }
        const std::uint32_t own_plane = plane_of(query.from[first + i]);
        if (targets != nullptr && (plane_[targets[i]] == own_plane || !query.found.is_hit(first + i)))
            continue;
        if (targets != nullptr)
            work.nearest[i].best = hits[i];
        for (const std::uint32_t surface : unfiltered_)
            take_surface(rays[i], own_plane, surface, work.nearest[i]);
        if (work.batch.passes(i))
            work.searched.push_back({i, query.from[first + i], static_cast<double>(own_plane)});
    }
    const std::uint32_t stack_size = tree_.most_pending() + 2; // writes above the top are unconditional
    const std::size_t together = std::min<std::size_t>(work.searched.size(), FirstHitSearch::at_once);
    work.stacks.resize(std::max(work.stacks.size(), together * stack_size));
    const auto take = [](const void* core, NearestHit& nearest, const Hit& hit) {
        static_cast<const Core*>(core)->take_coincident(hit, nearest);
    };
    kernel_->find_first(tree_view(), table_,
                        {work.batch, rays, work.searched.data(), work.searched.size(), work.nearest.data(),
                         targets != nullptr, work.stacks.data(), stack_size, take, this});
    for (std::size_t i = 0; i < count; ++i)
        put(query, first + i, work.nearest[i], work.ties);
}

/// Stores the first hit of a ray. Between a front and a back it is the front, unless a tie is left.
void Intersector::Core::put(const RayQuery& query, std::size_t ray, const NearestHit& nearest,
                            std::vector<Tie>& ties) const
{
    query.found.hits_[ray] = nearest.best;
    query.found.is_hit_[ray] = nearest.is_hit();
    const bool may_be_gap = (has_shell() && outside_is_solid_) || !have_same_outline(nearest.best, nearest.back);
    if (nearest.has_back && query.from[ray] != no_surface && may_be_gap)
        ties.push_back({ray, nearest});
}

/// Rays extended backwards to whole lines, and their hits.
struct WholeLines
{
    std::vector<Line> lines;
    HitLists along;
};

/// Calls visit(k, hits) with the hits along the whole line of each ray: the ray, extended backwards to a line that
/// starts before the scene.
template <class Visit>
void Intersector::Core::for_each_whole_line(const std::vector<Line>& rays, const Visit& visit) const
{
    auto& [lines, along] = thread_memory<WholeLines>();
    lines.clear();
    for (const Line& ray : rays)
        lines.push_back({ray.at(-reach_of(ray)), ray.direction});
    for (std::size_t first = 0; first < lines.size(); first += LineBatch::most) {
        const std::size_t count = std::min(LineBatch::most, lines.size() - first);
        all_hits(lines.data() + first, count, along);
        for (std::size_t k = 0; k < count; ++k)
            visit(first + k, along[k]);
    }
}

/// Overwrites the results of ties: of the hits at the same t, the first one along the whole line.
void Intersector::Core::order_ties(const RayQuery& query, FirstHitBuffers& work) const
{
    work.lines.clear();
    for (const Tie& tie : work.ties)
        work.lines.push_back(query.rays[tie.ray]);
    for_each_whole_line(work.lines, [&](std::size_t k, HitLists::List along) {
        const auto& [ray, nearest] = work.ties[k];
        const std::uint32_t front = nearest.best.surface;
        const auto* const best =
            std::find_if(along.begin(), along.end(), [&](const Hit& hit) { return hit.surface == front; });
        for (const Hit* hit = along.begin(); hit != best && best != along.end(); ++hit) {
            Hit result;
            if (hit->t == best->t && plane_[hit->surface] != plane_of(query.from[ray]) &&
                table_.decide(work.lines[k], hit->surface, result) && result.t == nearest.best.t) {
                query.found.hits_[ray] = result;
                return;
            }
        }
    });
}

/// Lists the rays whose start is covered by another surface.
void Intersector::Core::find_covered(const RayQuery& query, std::vector<std::size_t>& covered) const
{
    covered.clear();
    for (std::size_t i = 0; i < query.count; ++i)
        if (query.from[i] != no_surface && neighbours_.may_have_some(query.from[i]) &&
            is_covered(query.from[i], query.rays[i].origin))
            covered.push_back(i);
}

/// Overwrites the results of rays whose start is covered by another surface; lists those that stay undecided.
void Intersector::Core::find_first_of_covered(const RayQuery& query, FirstHitBuffers& work) const
{
    work.undecided.clear();
    work.ties.clear();
    work.lines.clear();
    for (const std::size_t ray : work.covered)
        work.lines.push_back(query.rays[ray]);
    for_each_whole_line(work.lines, [&](std::size_t k, HitLists::List along) {
        const std::size_t i = work.covered[k];
        const auto* const own =
            std::find_if(along.begin(), along.end(), [&](const Hit& hit) { return hit.surface == query.from[i]; });
        if (own == along.end()) { // by rounding the start lies outside of its surface
            work.undecided.push_back(i);
            return;
        }
        query.found.is_hit_[i] = own + 1 != along.end();
        if (query.found.is_hit(i)) {
            query.found.hits_[i] = own[1];
            query.found.hits_[i].t = std::max(0.0, own[1].t - reach_of(work.lines[k]));
        }
    });
}

} // namespace multipath

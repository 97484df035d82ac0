// Queries for many lines, in batches of LineBatch::most. A batch goes through phases: all lines are transformed into
// the frame, then all are filtered in single precision, then all candidates are decided in double precision, then all
// hits are sorted. Branches are predictable within a phase; they would not be if each line went through all steps
// alone. Batches with a line that does not fit into single precision, and scenes with unfiltered surfaces, take the
// slow path: one line at a time.

#include "geometry/intersector/core.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace multipath {

HitLists::HitLists() : scratch_(std::make_unique<Scratch>()) {}

HitLists::HitLists(const HitLists& other) : hits_(other.hits_), end_(other.end_), scratch_(std::make_unique<Scratch>())
{
}

HitLists& HitLists::operator=(const HitLists& other)
{
    hits_ = other.hits_;
    end_ = other.end_;
    return *this;
}

HitLists::~HitLists() = default;

FirstHits::FirstHits() : scratch_(std::make_unique<Scratch>()) {}

FirstHits::FirstHits(const FirstHits& other)
    : hits_(other.hits_), is_hit_(other.is_hit_), scratch_(std::make_unique<Scratch>())
{
}

FirstHits& FirstHits::operator=(const FirstHits& other)
{
    hits_ = other.hits_;
    is_hit_ = other.is_hit_;
    return *this;
}

FirstHits::~FirstHits() = default;

void Intersector::all_hits(const Line* lines, std::size_t count, HitLists& lists) const
{
    lists.end_.clear();
    for (std::size_t first = 0; first < count; first += LineBatch::most) {
        const std::size_t last = std::min(count, first + LineBatch::most);
        if (!core_->unfiltered_.empty() || !core_->place_lines(lines + first, last - first, *lists.scratch_)) {
            append_one_by_one(lines, first, last, lists);
            continue;
        }
        core_->find_candidates(*lists.scratch_);
        core_->decide_candidates(lines + first, first, last, lists);
    }
}

/// First phase: transforms the lines into the frame and lists those that pass through the box. Returns false if a line
/// must be decided in double precision only.
bool Intersector::Core::place_lines(const Line* lines, std::size_t count, HitLists::Scratch& work) const
{
    kernel_->place_lines(frame_, lines, count, work.batch);
    work.passing.resize(count);
    std::size_t passing = 0;
    std::uint32_t courses = 0;
    std::uint32_t whole = 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t passes = work.batch.course[i] == static_cast<std::uint32_t>(LineCourse::passes);
        work.passing[passing] = i;
        passing += passes;
        courses |= work.batch.course[i];
        whole &= work.batch.whole[i] | (1 - passes);
    }
    work.passing.resize(passing);
    work.all_whole = whole != 0;
    return (courses & static_cast<std::uint32_t>(LineCourse::unfit)) == 0;
}

void Intersector::Core::find_candidates(HitLists::Scratch& work) const
{
    if (tree_.empty())
        find_among_few(work);
    else
        find_in_tree(work);
}

void Intersector::Core::find_among_few(HitLists::Scratch& work) const
{
    const FlatSurfaces surfaces = flat_surfaces();
    const unsigned words = (surfaces.count + 31) / 32;
    const std::size_t lines = work.passing.empty() ? 0 : work.passing.back() + 1;
    kernel_->filter_flat(surfaces, work.batch, lines, work.all_whole, work.marks);
    work.candidates.reserve(work.passing.size() * surfaces.count);
    std::size_t found = 0;
    for (const std::uint32_t line : work.passing)
        for (unsigned word = 0; word < words; ++word)
            for (std::uint32_t marks = work.marks.word[word][line]; marks != 0; marks &= marks - 1)
                work.candidates.elements[found++] = {
                    line, lane_number_[32 * word + static_cast<unsigned>(__builtin_ctz(marks))]};
    work.candidates.count = found;
}

/// Finds the candidates of the lines with these indices in the batch by a search in the hierarchy, in any order.
void Intersector::Core::search_tree(const LineBatch& batch, const std::uint32_t* lines, std::size_t count,
                                    CandidateScratch& work) const
{
    work.lines.resize(count);
    work.pending.resize(std::max(work.pending.size(), count + CandidateSearch::least_room));
    work.found.reserve(CandidateSearch::least_room);
    kernel_->fill_tree_lines(batch, lines, count, work.lines.data());
    for (std::uint32_t i = 0; i < count; ++i)
        work.pending[i] = {i, 0};
    CandidateSearch search{work.lines.data(), nullptr, count, 0, nullptr, 0, 0};
    while (search.pending_count > 0) {
        if (work.pending.size() < search.pending_count + CandidateSearch::least_room)
            work.pending.resize(2 * work.pending.size());
        work.found.reserve(search.candidate_count + CandidateSearch::least_room);
        search.pending = work.pending.data();
        search.pending_room = work.pending.size();
        search.candidates = work.found.elements.data();
        search.candidate_room = work.found.elements.size();
        kernel_->find_candidates(tree_view(), search);
    }
    work.found.count = search.candidate_count;
}

void Intersector::Core::find_in_tree(HitLists::Scratch& work) const
{
    search_tree(work.batch, work.passing.data(), work.passing.size(), work.in_tree);
    const CandidateList& found = work.in_tree.found;
    std::array<std::size_t, LineBatch::most + 1> offset{}; // counting sort by line: slot of its next candidate
    for (std::size_t i = 0; i < found.count; ++i)
        ++offset[found.elements[i].line + 1];
    std::partial_sum(offset.begin(), offset.end(), offset.begin());
    work.candidates.reserve(found.count);
    work.candidates.count = found.count;
    for (std::size_t i = 0; i < found.count; ++i)
        work.candidates.elements[offset[found.elements[i].line]++] = found.elements[i];
}

void Intersector::Core::decide_candidates(const Line* lines, std::size_t first, std::size_t last, HitLists& lists) const
{
    const std::size_t begin = first == 0 ? 0 : lists.end_[first - 1];
    if (lists.hits_.size() < begin + lists.scratch_->candidates.count + 1)
        lists.hits_.resize(2 * (begin + lists.scratch_->candidates.count + 1));
    lists.end_.resize(last, 0);
    kernel_->decide_candidates(table_, lines, lists.scratch_->candidates.elements.data(),
                               lists.scratch_->candidates.count, lists.hits_.data() + begin, lists.end_.data() + first);
    std::size_t from = begin;
    for (std::size_t i = first; i < last; ++i) {
        const std::size_t to = std::max(from, begin + lists.end_[i]);
        if (to > from + 1)
            put_in_order(lists.hits_.data() + from, to - from);
        lists.end_[i] = from = to;
    }
}

void Intersector::append_one_by_one(const Line* lines, std::size_t first, std::size_t last, HitLists& lists) const
{
    std::vector<Hit> hits;
    for (std::size_t i = first; i < last; ++i) {
        all_hits(lines[i], hits);
        const std::size_t begin = i == 0 ? 0 : lists.end_[i - 1];
        if (lists.hits_.size() < begin + hits.size())
            lists.hits_.resize(2 * (begin + hits.size()));
        std::copy(hits.begin(), hits.end(), lists.hits_.begin() + static_cast<std::ptrdiff_t>(begin));
        lists.end_.push_back(begin + hits.size());
    }
}

// First hits of many rays, in the same phases. In a small scene the filter finds, for every ray, the surface that may
// come first and a lower bound of t for all others. Only this surface is decided: it is the first hit if its t is below
// the bound. The rare other rays are searched one by one. In a large scene the hierarchy is searched in order of
// distance. Rays whose start is covered by another surface are repeated at the end along the whole line.

void Intersector::closest_hits_from(const std::uint32_t* from, const Line* rays, std::size_t count,
                                    FirstHits& found) const
{
    find_first(from, nullptr, rays, count, found);
}

void Intersector::hits_on_targets(const std::uint32_t* from, const std::uint32_t* targets, const Line* rays,
                                  std::size_t count, FirstHits& found) const
{
    find_first(from, targets, rays, count, found);
    for (std::size_t i = 0; i < count; ++i)
        found.is_hit_[i] = every(found.is_hit_[i] != 0, found.hits_[i].surface == targets[i]);
}

void Intersector::find_first(const std::uint32_t* from, const std::uint32_t* targets, const Line* rays,
                             std::size_t count, FirstHits& found) const
{
    found.resize(count);
    for (std::size_t first = 0; first < count; first += LineBatch::most) {
        const std::size_t together = std::min(count - first, LineBatch::most);
        core_->kernel_->place_lines(core_->frame_, rays + first, together, found.scratch_->batch);
        std::uint32_t courses = 0;
        for (std::size_t i = 0; i < together; ++i)
            courses |= found.scratch_->batch.course[i];
        if (!core_->unfiltered_.empty() || (courses & static_cast<std::uint32_t>(LineCourse::unfit)) != 0)
            for (std::size_t i = first; i < first + together; ++i)
                found.put(i, core_->nearest(rays[i], core_->plane_of(from[i])));
        else if (core_->tree_.empty())
            core_->find_first_among_few(from, rays, first, together, found);
        else
            core_->find_first_in_tree(from, targets, rays, first, together, found);
    }
    find_first_of_covered(from, rays, count, found);
}

void Intersector::Core::find_first_among_few(const std::uint32_t* from, const Line* rays, std::size_t first,
                                             std::size_t count, FirstHits& found) const
{
    alignas(64) std::array<float, LineBatch::most> own_plane{};
    for (std::size_t i = 0; i < count; ++i)
        own_plane[i] = static_cast<float>(plane_of(from[first + i]));
    NearestCandidates candidates;
    kernel_->nearest_flat(flat_surfaces(), found.scratch_->batch, count, own_plane.data(), candidates);
    std::array<std::uint32_t, LineBatch::most> surface;
    for (std::size_t i = 0; i < count; ++i)
        surface[i] = static_cast<std::uint32_t>(static_cast<std::int32_t>(candidates.number[i]));
    kernel_->decide_nearest(table_, rays + first, surface.data(), count, found.hits_.data() + first,
                            found.is_hit_.data() + first);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t ray = first + i;
        const bool passes = found.scratch_->batch.course[i] == static_cast<std::uint32_t>(LineCourse::passes);
        const bool is_hit = every(passes, candidates.first[i] < FlatSurfaces::never, found.is_hit_[ray] != 0);
        const bool alone = candidates.second[i] == FlatSurfaces::never;
        const double second = found.scratch_->batch.middle_t[i] + static_cast<double>(candidates.second[i]);
        found.is_hit_[ray] = is_hit;
        if (!any(!passes, alone, every(is_hit, found.hits_[ray].t < second)))
            found.put(ray, nearest(rays[ray], plane_of(from[ray])));
    }
}

SearchedRay Intersector::Core::searched_ray(std::uint32_t number, std::uint32_t excluded_plane)
{
    return {number, excluded_plane == no_plane ? SearchedRay::no_plane : static_cast<double>(excluded_plane)};
}

/// Finds the first hits of work.rays, starting from those already in work.nearest. `lines`: the lines of the batch.
/// `any`: any nearer hit ends the search of a ray.
void Intersector::Core::search_first(const LineBatch& batch, const Line* lines, bool any, FirstHitScratch& work) const
{
    const std::uint32_t stack_size = tree_.most_pending() + 2; // writes above the top are unconditional
    const std::size_t together = std::min<std::size_t>(work.rays.size(), FirstHitSearch::at_once);
    work.stacks.resize(std::max(work.stacks.size(), together * stack_size));
    const auto take_coincident_hit = [](const void* core, NearestHit& nearest, const Hit& hit) {
        static_cast<const Core*>(core)->take_coincident(hit, nearest);
    };
    kernel_->find_first(tree_view(), table_,
                        {batch, lines, work.rays.data(), work.rays.size(), work.nearest.data(), any, work.stacks.data(),
                         stack_size, take_coincident_hit, this});
}

/// First hits by a search in the hierarchy. With targets, only rays that meet their targets are searched, and only up
/// to them.
void Intersector::Core::find_first_in_tree(const std::uint32_t* from, const std::uint32_t* targets, const Line* rays,
                                           std::size_t first, std::size_t count, FirstHits& found) const
{
    FirstHitScratch& work = found.scratch_->in_tree;
    work.rays.clear();
    work.nearest.assign(count, NearestHit());
    if (targets != nullptr) {
        for (std::size_t i = first; i < first + count; ++i)
            prefetch_all(table_.row(targets[i]));
        kernel_->decide_nearest(table_, rays + first, targets + first, count, found.hits_.data() + first,
                                found.is_hit_.data() + first);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::size_t ray = first + i;
        if (found.scratch_->batch.course[i] != static_cast<std::uint32_t>(LineCourse::passes))
            continue;
        if (targets != nullptr) {
            if (plane_[targets[ray]] == plane_of(from[ray]) || found.is_hit_[ray] == 0)
                continue;
            work.nearest[i].best = found.hits_[ray];
        }
        work.rays.push_back(searched_ray(i, plane_of(from[ray])));
    }
    search_first(found.scratch_->batch, rays + first, targets != nullptr, work);
    for (std::size_t i = 0; i < count; ++i) {
        const NearestHit& nearest = work.nearest[i];
        found.hits_[first + i] = nearest.best;
        found.is_hit_[first + i] = nearest.is_hit();
        if (nearest.has_back)
            found.put(first + i, first_of(nearest, rays[first + i], plane_of(from[first + i])));
    }
}

/// Overwrites the results of rays whose start is covered by another surface, as closest_hit_from does for one ray.
void Intersector::find_first_of_covered(const std::uint32_t* from, const Line* rays, std::size_t count,
                                        FirstHits& found) const
{
    found.scratch_->covered.clear();
    found.scratch_->whole_lines.clear();
    for (std::size_t i = 0; i < count; ++i)
        if (from[i] != no_surface && core_->neighbours_.may_have_some(from[i]) &&
            core_->is_covered(from[i], rays[i].origin)) {
            found.scratch_->covered.push_back(static_cast<std::uint32_t>(i));
            found.scratch_->whole_lines.push_back(core_->whole_line(rays[i]));
        }
    // In parts of limited memory, because each line may meet thousands of surfaces.
    constexpr std::size_t most_hits = 1u << 15;
    std::size_t part = 16;
    for (std::size_t first = 0; first < found.scratch_->covered.size();) {
        const std::size_t end = std::min(first + part, found.scratch_->covered.size());
        all_hits(found.scratch_->whole_lines.data() + first, end - first, found.scratch_->along);
        part = std::clamp<std::size_t>(most_hits * (end - first) / (found.scratch_->along.hit_count() + 1), 1,
                                       LineBatch::most);
        for (const std::size_t of_part = first; first < end; ++first) {
            const std::uint32_t i = found.scratch_->covered[first];
            found.put(i, core_->next_along(found.scratch_->along[first - of_part], from[i], rays[i]));
        }
    }
}

} // namespace multipath

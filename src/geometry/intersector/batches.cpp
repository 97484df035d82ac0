// All hits of many lines, in phases: all lines are placed, then all filtered, then all candidates decided, then all
// hits put in order. A processor guesses ahead well within a phase, and badly where each line takes another course.

#include "geometry/intersector/core.h"

#include <algorithm>

namespace multipath {

void IntersectorCore::all_hits(const Line* lines, std::size_t count, HitLists& lists) const
{
    lists.end_.clear();
    for (std::size_t first = 0; first < count; first += LineBatch::most) {
        const std::size_t last = std::min(count, first + LineBatch::most);
        if (!unfiltered_.empty() || !place_lines(lines + first, last - first, *lists.scratch_)) {
            append_one_by_one(lines, first, last, lists);
            continue;
        }
        find_candidates(*lists.scratch_);
        decide_candidates(lines + first, first, last, lists);
    }
}

/// False if a line can only be decided in double precision.
bool IntersectorCore::place_lines(const Line* lines, std::size_t count, HitLists::Scratch& work) const
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

void IntersectorCore::find_candidates(HitLists::Scratch& work) const
{
    if (tree_.empty())
        find_among_few(work);
    else
        find_in_tree(work);
}

void IntersectorCore::find_among_few(HitLists::Scratch& work) const
{
    const FlatSurfaces surfaces = flat_surfaces();
    const unsigned words = (surfaces.count + 31) / 32;
    const std::size_t lines = work.passing.empty() ? 0 : work.passing.back() + 1;
    kernel_->filter_flat(surfaces, work.batch, lines, work.all_whole, work.marks);
    work.reserve_candidates(work.passing.size() * surfaces.count);
    std::size_t found = 0;
    for (const std::uint32_t line : work.passing)
        for (unsigned word = 0; word < words; ++word)
            for (std::uint32_t marks = work.marks.word[word][line]; marks != 0; marks &= marks - 1)
                work.candidates[found++] = {line,
                                            lane_number_[32 * word + static_cast<unsigned>(__builtin_ctz(marks))]};
    work.candidate_count = found;
}

void IntersectorCore::find_in_tree(HitLists::Scratch& work) const
{
    struct Context
    {
        const std::uint32_t* number;
        HitLists::Scratch& work;
        std::uint32_t line;
    } context{lane_number_.data(), work, 0};
    const auto visit = [](void* pointer, const BlockLanes* found, unsigned count) {
        const Context& in = *static_cast<const Context*>(pointer);
        in.work.reserve_candidates(in.work.candidate_count + std::size_t{SurfaceBlock::lanes} * count);
        std::size_t end = in.work.candidate_count;
        for (unsigned i = 0; i < count; ++i)
            for (unsigned lanes = found[i].lanes; lanes != 0; lanes &= lanes - 1)
                in.work.candidates[end++] = {
                    in.line,
                    in.number[SurfaceBlock::lanes * found[i].block + static_cast<unsigned>(__builtin_ctz(lanes))]};
        in.work.candidate_count = end;
    };
    work.candidate_count = 0;
    for (const std::uint32_t i : work.passing) {
        context.line = i;
        kernel_->visit_all(tree_.nodes(), blocks_.data(), work.batch.line(i), visit, &context);
    }
}

void IntersectorCore::decide_candidates(const Line* lines, std::size_t first, std::size_t last, HitLists& lists) const
{
    const std::size_t begin = first == 0 ? 0 : lists.end_[first - 1];
    if (lists.hits_.size() < begin + lists.scratch_->candidate_count + 1)
        lists.hits_.resize(2 * (begin + lists.scratch_->candidate_count + 1));
    lists.end_.resize(last, 0);
    kernel_->decide_candidates(table_, lines, lists.scratch_->candidates.data(), lists.scratch_->candidate_count,
                               lists.hits_.data() + begin, lists.end_.data() + first);
    std::size_t from = begin;
    for (std::size_t i = first; i < last; ++i) {
        const std::size_t to = std::max(from, begin + lists.end_[i]);
        if (to > from + 1)
            put_in_order(lists.hits_.data() + from, to - from);
        lists.end_[i] = from = to;
    }
}

void IntersectorCore::append_one_by_one(const Line* lines, std::size_t first, std::size_t last, HitLists& lists) const
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

} // namespace multipath

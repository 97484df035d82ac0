// All hits of many lines, in phases: all lines are placed, then all filtered, then all candidates decided, then all
// hits put in order. A processor guesses ahead well within a phase, and badly where each line takes another course.

#include "geometry/intersector/intersector.h"

#include <algorithm>

namespace multipath {

void Intersector::all_hits(const Line* lines, std::size_t count, HitLists& lists) const
{
    lists.end_.clear();
    for (std::size_t first = 0; first < count; first += LineBatch::most) {
        const std::size_t last = std::min(count, first + LineBatch::most);
        if (!unfiltered_.empty() || !place_lines(lines + first, last - first, lists)) {
            append_one_by_one(lines, first, last, lists);
            continue;
        }
        find_candidates(lists);
        decide_candidates(lines + first, first, last, lists);
    }
}

/// False if a line can only be decided in double precision.
bool Intersector::place_lines(const Line* lines, std::size_t count, HitLists& lists) const
{
    kernel_->place_lines(frame_, lines, count, lists.batch_);
    lists.passing_.resize(count);
    std::size_t passing = 0;
    std::uint32_t courses = 0;
    std::uint32_t whole = 1;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t passes = lists.batch_.course[i] == static_cast<std::uint32_t>(LineCourse::passes);
        lists.passing_[passing] = i;
        passing += passes;
        courses |= lists.batch_.course[i];
        whole &= lists.batch_.whole[i] | (1 - passes);
    }
    lists.passing_.resize(passing);
    lists.all_whole_ = whole != 0;
    return (courses & static_cast<std::uint32_t>(LineCourse::unfit)) == 0;
}

void Intersector::find_candidates(HitLists& lists) const
{
    if (tree_.empty())
        find_among_few(lists);
    else
        find_in_tree(lists);
}

void Intersector::find_among_few(HitLists& lists) const
{
    const FlatSurfaces surfaces = flat_surfaces();
    const unsigned words = (surfaces.count + 31) / 32;
    const std::size_t lines = lists.passing_.empty() ? 0 : lists.passing_.back() + 1;
    kernel_->filter_flat(surfaces, lists.batch_, lines, lists.all_whole_, lists.marks_);
    lists.reserve_candidates(lists.passing_.size() * surfaces.count);
    std::size_t found = 0;
    for (const std::uint32_t line : lists.passing_)
        for (unsigned word = 0; word < words; ++word)
            for (std::uint32_t marks = lists.marks_.word[word][line]; marks != 0; marks &= marks - 1)
                lists.candidates_[found++] = {line,
                                              lane_number_[32 * word + static_cast<unsigned>(__builtin_ctz(marks))]};
    lists.candidate_count_ = found;
}

void Intersector::find_in_tree(HitLists& lists) const
{
    struct Context
    {
        const std::uint32_t* number;
        HitLists& lists;
        std::uint32_t line;
    } context{lane_number_.data(), lists, 0};
    const auto visit = [](void* pointer, const BlockLanes* found, unsigned count) {
        const Context& in = *static_cast<const Context*>(pointer);
        in.lists.reserve_candidates(in.lists.candidate_count_ + std::size_t{SurfaceBlock::lanes} * count);
        std::size_t end = in.lists.candidate_count_;
        for (unsigned i = 0; i < count; ++i)
            for (unsigned lanes = found[i].lanes; lanes != 0; lanes &= lanes - 1)
                in.lists.candidates_[end++] = {
                    in.line,
                    in.number[SurfaceBlock::lanes * found[i].block + static_cast<unsigned>(__builtin_ctz(lanes))]};
        in.lists.candidate_count_ = end;
    };
    lists.candidate_count_ = 0;
    for (const std::uint32_t i : lists.passing_) {
        context.line = i;
        kernel_->visit_all(tree_.nodes(), blocks_.data(), lists.batch_.line(i), visit, &context);
    }
}

void Intersector::decide_candidates(const Line* lines, std::size_t first, std::size_t last, HitLists& lists) const
{
    const std::size_t begin = first == 0 ? 0 : lists.end_[first - 1];
    if (lists.hits_.size() < begin + lists.candidate_count_ + 1)
        lists.hits_.resize(2 * (begin + lists.candidate_count_ + 1));
    lists.end_.resize(last, 0);
    kernel_->decide_candidates(table_, lines, lists.candidates_.data(), lists.candidate_count_,
                               lists.hits_.data() + begin, lists.end_.data() + first);
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

} // namespace multipath

#pragma once

#include "geometry/hit.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// The hits of several lines, concatenated in one array: the result of Intersector::all_hits. Passing the same object
/// to all_hits again reuses its buffers.
class HitLists
{
public:
    /// View of the hits of one line, in order along the line.
    struct List
    {
        const Hit* first;
        const Hit* last;

        List(const Hit* begin, const Hit* end) : first(begin), last(end) {}
        List(const std::vector<Hit>& hits) : first(hits.data()), last(hits.data() + hits.size()) {}

        const Hit* begin() const { return first; }
        const Hit* end() const { return last; }
        std::size_t size() const { return static_cast<std::size_t>(last - first); }
        bool empty() const { return first == last; }
        const Hit& operator[](std::size_t i) const { return first[i]; }
    };

    std::size_t size() const { return end_.size(); } ///< number of lines
    /// Total number of hits of all lines.
    std::size_t hit_count() const { return end_.empty() ? 0 : end_.back(); }
    /// The hits of a line, valid until the object changes.
    List operator[](std::size_t line) const
    {
        return {hits_.data() + (line == 0 ? 0 : end_[line - 1]), hits_.data() + end_[line]};
    }

private:
    friend class Intersector;

    std::vector<Hit> hits_;        ///< may be longer than the lists need
    std::vector<std::size_t> end_; ///< per line: end of its list in hits_, where the next list begins
};

/// The first hit, if any, of each of several rays: the result of Intersector::closest_hits_from and hits_on_targets.
/// Passing the same object to these functions again reuses its buffers.
class FirstHits
{
public:
    std::size_t size() const { return is_hit_.size(); } ///< number of rays
    bool is_hit(std::size_t ray) const { return is_hit_[ray] != 0; }
    const Hit& operator[](std::size_t ray) const { return hits_[ray]; } ///< requires is_hit(ray)

private:
    friend class Intersector;

    void resize(std::size_t rays)
    {
        hits_.resize(rays);
        is_hit_.resize(rays);
    }
    std::vector<Hit> hits_;
    std::vector<std::uint32_t> is_hit_; ///< 0 or 1 per ray
};

} // namespace multipath

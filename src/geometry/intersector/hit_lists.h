#pragma once

#include "geometry/hit.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace multipath {

/// The hits of several lines, line after line in one array; what Intersector::all_hits fills. Reuses its memory.
class HitLists
{
public:
    /// The hits of one line, in order.
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

    HitLists();
    HitLists(const HitLists& other); ///< without the work space
    HitLists& operator=(const HitLists& other);
    ~HitLists();

    std::size_t size() const { return end_.size(); } ///< number of lines
    std::size_t hit_count() const { return end_.empty() ? 0 : end_.back(); }
    List operator[](std::size_t line) const
    {
        return {hits_.data() + (line == 0 ? 0 : end_[line - 1]), hits_.data() + end_[line]};
    }

private:
    friend class Intersector;

    struct Scratch;

    std::vector<Hit> hits_; ///< may hold more than the lines need
    std::vector<std::size_t> end_;
    std::unique_ptr<Scratch> scratch_;
};

/// For each of many rays the first surface that it meets, or none; what Intersector::closest_hits_from fills. Reuses
/// its memory.
class FirstHits
{
public:
    FirstHits();
    FirstHits(const FirstHits& other); ///< without the work space
    FirstHits& operator=(const FirstHits& other);
    ~FirstHits();

    std::size_t size() const { return is_hit_.size(); } ///< number of rays
    bool is_hit(std::size_t ray) const { return is_hit_[ray] != 0; }
    const Hit& operator[](std::size_t ray) const { return hits_[ray]; } ///< of a ray that has one

private:
    friend class Intersector;

    struct Scratch;

    void resize(std::size_t rays)
    {
        hits_.resize(rays);
        is_hit_.resize(rays);
    }
    void put(std::size_t ray, const std::optional<Hit>& hit)
    {
        is_hit_[ray] = hit.has_value();
        if (hit)
            hits_[ray] = *hit;
    }

    std::vector<Hit> hits_;
    std::vector<std::uint32_t> is_hit_;
    std::unique_ptr<Scratch> scratch_;
};

} // namespace multipath

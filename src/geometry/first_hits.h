#pragma once

#include "geometry/filter_line.h"
#include "geometry/hit.h"
#include "geometry/hit_lists.h"
#include "geometry/line.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace multipath {

/// For each of many rays the first surface that it meets, or none; what Intersector::closest_hits_from fills. Its
/// memory serves again.
class FirstHits
{
public:
    std::size_t size() const { return is_hit_.size(); } ///< number of rays
    bool is_hit(std::size_t ray) const { return is_hit_[ray] != 0; }
    const Hit& operator[](std::size_t ray) const { return hits_[ray]; } ///< of a ray that has one

private:
    friend class Intersector;

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

    // What passes from one phase to the next.
    LineBatch batch_{};
    std::vector<std::uint32_t> covered_; ///< rays that start below another surface
    std::vector<Line> whole_lines_;      ///< along these
    HitLists along_;
};

} // namespace multipath

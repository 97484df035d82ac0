#pragma once

#include "geometry/intersector/intersector.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/intersector/surface_sizes.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace multipath {

/// What an Intersector must find: every surface decided in double precision, nothing filtered.
class BruteForce
{
public:
    explicit BruteForce(const SurfaceList& surfaces)
        : planes_(share_planes(surfaces, from_large_to_small(surfaces))),
          table_(surfaces, planes_),
          rank_(size_ranks(from_large_to_small(surfaces))),
          outside_is_solid_(form_a_room(surfaces))
    {
    }

    void all_hits(const Line& line, std::vector<Hit>& hits) const
    {
        hits.clear();
        Hit hit;
        for (std::uint32_t s = 0; s < table_.size(); ++s)
            if (table_.decide(line, s, hit))
                hits.push_back(hit);
        std::sort(hits.begin(), hits.end(), [this](const Hit& a, const Hit& b) {
            return a.t < b.t || (a.t == b.t && rank_[a.surface] < rank_[b.surface]);
        });
        order_coincident_hits(hits, outside_is_solid_);
    }

    /// The closest of the hits of a line: at equal t a front, then the smaller.
    std::optional<Hit> closest(const std::vector<Hit>& hits) const
    {
        const auto best = std::min_element(hits.begin(), hits.end(), [this](const Hit& a, const Hit& b) {
            if (a.t != b.t)
                return a.t < b.t;
            return a.front != b.front ? a.front : rank_[a.surface] < rank_[b.surface];
        });
        return best == hits.end() ? std::optional<Hit>() : *best;
    }

    /// The first of the hits of a ray that leaves `from` where nothing else lies in its plane.
    std::optional<Hit> closest_from(std::uint32_t from, std::vector<Hit> hits) const
    {
        const auto in_plane = [&](const Hit& hit) {
            return planes_.plane_number[hit.surface] == planes_.plane_number[from];
        };
        hits.erase(std::remove_if(hits.begin(), hits.end(), in_plane), hits.end());
        return closest(hits);
    }

    std::vector<std::uint32_t> coincident_surfaces(std::uint32_t of, Vec3 point) const
    {
        std::vector<std::uint32_t> found;
        for (std::uint32_t s = 0; s < table_.size(); ++s)
            if (s != of && planes_.plane_number[s] == planes_.plane_number[of] && table_.holds(point, s))
                found.push_back(s);
        return found;
    }

private:
    SharedPlanes planes_;
    SurfaceTable table_;
    std::vector<std::uint32_t> rank_;
    bool outside_is_solid_;
};

/// To the last bit.
inline bool same(const Hit& a, const Hit& b)
{
    return a.t == b.t && a.surface == b.surface && a.u == b.u && a.v == b.v && a.front == b.front;
}

inline bool same(const std::optional<Hit>& a, const std::optional<Hit>& b)
{
    return a.has_value() == b.has_value() && (!a || same(*a, *b));
}

} // namespace multipath

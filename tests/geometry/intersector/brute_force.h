#pragma once

#include "geometry/intersector/intersector.h"
#include "geometry/intersector/line_batch.h"
#include "geometry/intersector/shared_planes.h"
#include "geometry/intersector/surface_sizes.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

namespace multipath {

/// What an Intersector must find: every surface decided in double precision, nothing filtered.
class BruteForce
{
public:
    explicit BruteForce(const SurfaceList& surfaces)
        : planes_(share_planes(surfaces, order_by_descending_area(surfaces))),
          table_(surfaces, planes_),
          rank_(surfaces.size()),
          outside_is_solid_(is_interior(surfaces)),
          frame_(box_around(surfaces))
    {
        auto rank = static_cast<std::uint32_t>(surfaces.size());
        for (const std::uint32_t surface : order_by_descending_area(surfaces))
            rank_[surface] = --rank;
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
        order_coincident_hits(hits.data(), hits.size(), outside_is_solid_);
    }

    /// The closest of the hits of a line: at equal t a front, then the smaller of fronts and the larger of backs.
    std::optional<Hit> closest(const std::vector<Hit>& hits) const
    {
        const auto best = std::min_element(hits.begin(), hits.end(), [this](const Hit& a, const Hit& b) {
            if (a.t != b.t)
                return a.t < b.t;
            if (a.front != b.front)
                return a.front;
            return a.front ? rank_[a.surface] < rank_[b.surface] : rank_[a.surface] > rank_[b.surface];
        });
        return best == hits.end() ? std::optional<Hit>() : *best;
    }

    /// The first of the hits of a ray that leaves `from` where nothing else lies in its plane. Where it meets a front
    /// and a back of unlike outline together, the one that comes first along the whole line.
    std::optional<Hit> closest_from(std::uint32_t from, std::vector<Hit> hits, const Line& ray) const
    {
        const auto in_plane = [&](const Hit& hit) {
            return planes_.plane_number[hit.surface] == planes_.plane_number[from];
        };
        hits.erase(std::remove_if(hits.begin(), hits.end(), in_plane), hits.end());
        const std::optional<Hit> best = closest(hits);
        if (!best || !best->front)
            return best;
        std::vector<Hit> together;
        std::copy_if(hits.begin(), hits.end(), std::back_inserter(together),
                     [&](const Hit& hit) { return hit.t == best->t; });
        std::vector<Hit> backs;
        std::copy_if(together.begin(), together.end(), std::back_inserter(backs),
                     [](const Hit& hit) { return !hit.front; });
        const std::optional<Hit> back = closest(backs);
        if (!back || have_same_outline(*best, *back))
            return best;
        std::vector<Hit> along;
        const double before = (2.0 * frame_.radius() + length(ray.origin - frame_.centre())) / length(ray.direction);
        all_hits({ray.at(-before), ray.direction}, along); // to the last bit the line that an intersector asks for
        const auto end =
            std::find_if(along.begin(), along.end(), [&](const Hit& h) { return h.surface == best->surface; });
        for (auto hit = along.begin(); hit != end && end != along.end(); ++hit)
            for (const Hit& candidate : together)
                if (hit->t == end->t && hit->surface == candidate.surface)
                    return candidate;
        return best;
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
    FilterFrame frame_;
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

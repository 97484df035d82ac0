// The first hits of many rays, in phases like all hits of many lines. Of every ray the surface that may come first is
// decided; it does come first if no other can be met before it. Where that is in doubt, which is rare, and where the
// start of a ray is covered, more is looked at.

#include "geometry/intersector/core.h"

#include <algorithm>
#include <array>

namespace multipath {

void IntersectorCore::closest_hits_from(const std::uint32_t* from, const Line* rays, std::size_t count,
                                        FirstHits& found) const
{
    found.resize(count);
    for (std::size_t first = 0; first < count; first += LineBatch::most) {
        const std::size_t together = std::min(count - first, LineBatch::most);
        kernel_->place_lines(frame_, rays + first, together, found.scratch_->batch);
        std::uint32_t courses = 0;
        for (std::size_t i = 0; i < together; ++i)
            courses |= found.scratch_->batch.course[i];
        if (!unfiltered_.empty() || (courses & static_cast<std::uint32_t>(LineCourse::unfit)) != 0)
            for (std::size_t i = first; i < first + together; ++i)
                found.put(i, nearest(rays[i], plane_[from[i]]));
        else if (tree_.empty())
            find_first_among_few(from, rays, first, together, found);
        else
            find_first_in_tree(from, rays, first, together, found);
    }
    find_first_of_covered(from, rays, count, found);
}

void IntersectorCore::find_first_among_few(const std::uint32_t* from, const Line* rays, std::size_t first,
                                           std::size_t count, FirstHits& found) const
{
    alignas(64) std::array<float, LineBatch::most> own_plane{};
    for (std::size_t i = 0; i < count; ++i)
        own_plane[i] = static_cast<float>(plane_[from[first + i]]);
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
            found.put(ray, nearest(rays[ray], plane_[from[ray]]));
    }
}

void IntersectorCore::find_first_in_tree(const std::uint32_t* from, const Line* rays, std::size_t first,
                                         std::size_t count, FirstHits& found) const
{
    for (std::size_t i = 0; i < count; ++i) {
        const bool passes = found.scratch_->batch.course[i] == static_cast<std::uint32_t>(LineCourse::passes);
        found.put(first + i,
                  passes ? nearest_in_tree(rays[first + i], found.scratch_->batch.line(i), plane_[from[first + i]])
                         : std::nullopt);
    }
}

/// Overwrites what was found for rays that start where another surface lies: closest_hit_from for each of them.
void IntersectorCore::find_first_of_covered(const std::uint32_t* from, const Line* rays, std::size_t count,
                                            FirstHits& found) const
{
    found.scratch_->covered.clear();
    found.scratch_->whole_lines.clear();
    for (std::size_t i = 0; i < count; ++i)
        if (neighbours_.may_have_some(from[i]) && is_covered(from[i], rays[i].origin)) {
            found.scratch_->covered.push_back(static_cast<std::uint32_t>(i));
            found.scratch_->whole_lines.push_back(whole_line(rays[i]));
        }
    // In parts, since each of the lines may meet thousands of surfaces.
    constexpr std::size_t most_hits = 1u << 15;
    std::size_t part = 16;
    for (std::size_t first = 0; first < found.scratch_->covered.size();) {
        const std::size_t end = std::min(first + part, found.scratch_->covered.size());
        all_hits(found.scratch_->whole_lines.data() + first, end - first, found.scratch_->along);
        part = std::clamp<std::size_t>(most_hits * (end - first) / (found.scratch_->along.hit_count() + 1), 1,
                                       LineBatch::most);
        for (const std::size_t of_part = first; first < end; ++first) {
            const std::uint32_t i = found.scratch_->covered[first];
            found.put(i, next_along(found.scratch_->along[first - of_part], from[i], rays[i]));
        }
    }
}

} // namespace multipath

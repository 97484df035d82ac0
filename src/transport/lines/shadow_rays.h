#pragma once

#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "geometry/line.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Shadow rays that are traced together, in reusable buffers, each with a Note that tells what it is for.
template <class Note>
class ShadowRays
{
public:
    /// Adds a ray from the surface `from` to a point of the surface `to`.
    void add(std::uint32_t from, std::uint32_t to, const Line& ray, const Note& note)
    {
        from_.push_back(from);
        to_.push_back(to);
        rays_.push_back(ray);
        notes_.push_back(note);
    }

    std::size_t size() const { return rays_.size(); }

    /// Traces the rays in order, calls take(note, hit) for each that meets its surface first, and removes them all.
    template <class Take>
    void trace(const Scene& scene, const Take& take)
    {
        scene.intersector().hits_on_targets(from_.data(), to_.data(), rays_.data(), rays_.size(), hits_);
        for (std::size_t k = 0; k < rays_.size(); ++k)
            if (hits_.is_hit(k))
                take(notes_[k], hits_[k]);
        from_.clear();
        to_.clear();
        rays_.clear();
        notes_.clear();
    }

private:
    std::vector<std::uint32_t> from_; ///< surfaces
    std::vector<std::uint32_t> to_;
    std::vector<Line> rays_;
    std::vector<Note> notes_;
    FirstHits hits_;
};

} // namespace multipath

#pragma once

#include "geometry/line.h"
#include "parallel/run_control.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/exchange/exchange_estimate.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Sampler of rays between two patches. The weight of a ray is proportional to the light that it carries, so that
/// weighted means over the rays estimate means over all lines that join the patches. Distant pairs take uniform points
/// of both patches, near ones a uniform point of the first and a direction uniform in the solid angle of the second
/// (Arvo 1995).
class RayPair
{
public:
    struct Ray
    {
        Line line;     ///< from the first patch towards a point of the second
        double weight; ///< 0 if one of the two points is behind the plane of the other patch
    };

    /// The rays of two patches of the scene; they leave the smaller one.
    RayPair(const Scene& scene, std::uint32_t one, std::uint32_t other);
    /// The rays from `from`, which should be the smaller one, to `to`. Each may be any part of its surface.
    RayPair(const Scene& scene, const Patch& from, const Patch& to);

    /// The ray of one item: item[0], item[1] for the point of the first patch, item[2], item[3] for the second. The
    /// weights of near pairs are bounded, even when the patches touch.
    Ray ray(const Item& item) const;

    /// Expected weight of a ray, given the unoccluded exchange [m^2] of the pair.
    double mean_weight(double unoccluded) const;

    std::uint32_t from_surface() const { return from_.surface; }
    std::uint32_t to_surface() const { return to_.surface; }
    /// True if unoccluded rays meet the front of to_surface(), false if they meet its back.
    bool to_front() const { return to_front_; }

private:
    Ray towards_point(Vec3 start, double u, double v) const;
    Ray into_solid_angle(Vec3 start, double u, double v) const;

    Patch from_;
    Patch to_;
    bool to_front_;
    Vec3 from_normal_;
    Vec3 to_normal_;
    double sampled_area_; ///< area of the sampled points: that of the first patch [m^2], or the product of both [m^4]
    bool near_;           ///< samples the solid angle of the second patch instead of its area
};

/// Rays to be cast between pairs of patches, to estimate their mutual visibility.
struct PairRays
{
    std::uint64_t first_item = 0; ///< of the sequence; one item per ray (RayPair::ray)
    std::uint64_t rays = 0;       ///< total number
    std::uint64_t seed = 0;       ///< of the rounding to whole rays
};

/// Refines the estimate with shadow rays between pairs, allotted so that the error (1) falls most (Neyman 1934): to
/// pairs that exchange much light and whose visibility is uncertain. `radiosity` [W/m^2] need only be roughly right.
/// The estimate must come from estimate_exchange with the same `crossing_area` [m^2]. It is refined in place, row by
/// row, so a checkpoint must also hold it. If the run is stopped or is a shard, only some rows are refined.
void refine_by_rays(ExchangeEstimate& estimate, const Scene& scene, const PairMatrix<float>& unoccluded,
                    double crossing_area, const std::vector<Rgb>& radiosity, const Sequence& sequence,
                    const PairRays& plan, const RunControl& run);

} // namespace multipath

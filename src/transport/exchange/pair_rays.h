#pragma once

#include "base/elementary.h"
#include "geometry/line.h"
#include "parallel/run_control.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/exchange/exchange_estimate.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Sampler of rays between two patches; they leave the first patch towards the second. The weight of a ray is
/// proportional to the light that the ray carries, so that weighted means over the rays estimate means over all lines
/// that join the patches. For distant pairs the rays join uniform points of both patches. For near pairs they start at
/// a uniform point of the first patch, in a direction uniform in the solid angle of the second (Arvo 1995).
class RayPair
{
public:
    struct Ray
    {
        Line line;     ///< from the first patch towards a point of the second
        double weight; ///< [1/m^2] for distant pairs, [sr] for near ones; 0 if the ray carries no light, since one of
                       ///< its ends is behind the plane of the other patch
    };

    /// Rays between two patches of the scene, given by their indices. The smaller patch is the first.
    RayPair(const Scene& scene, std::uint32_t one, std::uint32_t other);
    /// Rays between two parts of surfaces, which need not be patches of the scene. `from` is the first patch, and
    /// should be the smaller one.
    RayPair(const Scene& scene, const Patch& from, const Patch& to);

    /// The ray of one item: item[0] and item[1] choose the point of the first patch, item[2] and item[3] the point of
    /// the second or the direction towards it. The weights of near pairs are bounded, even when the patches touch.
    Ray ray(const Item& item) const;

    /// Expected weight of a ray, in the unit of the weights, given the unoccluded exchange [m^2] of the pair.
    double mean_weight(double unoccluded) const { return pi * unoccluded / sampled_area_; }

    std::uint32_t from_surface() const { return from_.surface; }
    std::uint32_t to_surface() const { return to_.surface; }
    /// True if unoccluded rays meet the front of to_surface(), false if they meet its back.
    bool to_front() const { return to_front_; }

private:
    Patch from_;
    Patch to_;
    bool to_front_;
    Vec3 from_normal_;
    Vec3 to_normal_;
    double sampled_area_; ///< area of the sampled points: that of the first patch [m^2], or the product of both [m^4]
    bool near_;           ///< true if the solid angle of the second patch is sampled instead of its area
};

/// Rays to be cast between pairs of patches, to estimate their mutual visibility.
struct PairRays
{
    std::uint64_t first_item = 0; ///< ray k takes item (point) first_item + k of the sequence
    std::uint64_t rays = 0;       ///< total number of rays; no ray is cast if no pair is uncertain
    std::uint64_t seed = 0;       ///< seed of the random rounding to whole rays per pair
};

/// Refines a result of estimate_exchange() with shadow rays between pairs of patches. The rays are allotted so that the
/// mean square error of the radiosity falls most (Neyman 1934): to pairs that exchange much light and whose visibility
/// is uncertain. `radiosity` [W/m^2] need only be roughly right. `unoccluded` [m^2] and `crossing_area` [m^2] must be
/// those that estimate_exchange() was given. The estimate changes row by row, so the caller must save it in the
/// checkpoint. If the run is stopped or is a shard, only some rows are refined.
void refine_by_rays(ExchangeEstimate& estimate, const Scene& scene, const PairMatrix<float>& unoccluded,
                    double crossing_area, const std::vector<Rgb>& radiosity, const Sequence& sequence,
                    const PairRays& plan, const RunControl& run);

} // namespace multipath

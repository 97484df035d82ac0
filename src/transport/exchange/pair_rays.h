#pragma once

#include "geometry/line.h"
#include "parallel/run_control.h"
#include "sampling/sequence.h"
#include "scene/scene.h"
#include "transport/exchange/exchange_estimate.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Rays between the points of two patches, each with the weight of the light that it would carry: averages over them
/// are averages over the lines that join the patches.
class RayPair
{
public:
    struct Ray
    {
        Line line;     ///< from the smaller patch towards a point of the larger one
        double weight; ///< 0 when one of the points is behind the other patch
    };

    RayPair(const Scene& scene, std::uint32_t one, std::uint32_t other);
    /// Either may be a part of its surface, or all of it. The rays leave the first, which should be the smaller one.
    RayPair(const Scene& scene, const Patch& from, const Patch& to);

    /// Two numbers for each patch. Weights of near pairs are bounded, also when the patches touch.
    Ray ray(const Item& item) const;

    /// Of all rays of a pair with this exchange without obstacles [m^2].
    double mean_weight(double unoccluded) const;

    std::uint32_t from_surface() const { return from_.surface; }
    std::uint32_t to_surface() const { return to_.surface; }
    bool to_front() const { return to_front_; } ///< a free ray meets the front of the surface, else its back

private:
    Ray towards_point(Vec3 start, double u, double v) const;
    Ray into_solid_angle(Vec3 start, double u, double v) const;

    Patch from_;
    Patch to_;
    bool to_front_;
    Vec3 from_normal_;
    Vec3 to_normal_;
    double sampled_area_; ///< of which the rays are uniform, of one patch [m^2] or of both [m^4]
    bool near_;
};

/// Rays between the points of pairs of patches, to learn how much of each other they see.
struct PairRays
{
    std::uint64_t first_item = 0; ///< of the sequence; one item per ray: a point on each of the two patches
    std::uint64_t rays = 0;       ///< in all
    std::uint64_t seed = 0;       ///< of the rounding to whole rays
};

/// Casts rays where they lower the error (1) most: between pairs that exchange much light and are neither surely free
/// nor surely hidden; `radiosity` [W/m^2] need only be roughly right. The estimate must come from lines of
/// `crossing_area`; it gets better row by row, and a checkpoint must hold it besides what this function makes it hold.
void refine_by_rays(ExchangeEstimate& estimate, const Scene& scene, const PairMatrix<float>& unoccluded,
                    double crossing_area, const std::vector<Rgb>& radiosity, const Sequence& sequence,
                    const PairRays& plan, const RunControl& run);

} // namespace multipath

#pragma once

#include "parallel/blocks.h"
#include "scene/scene.h"
#include "transport/exchange/exchange_estimate.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Shares a number of rays among pairs that have had some lines already: like water poured into vessels of different
/// depth, each gets what it lacks of level * importance, if anything.
class FillLevel
{
public:
    FillLevel();

    /// A pair of this importance (> 0) that is as well known as by so many lines.
    void add(double importance, double lines);
    void add(const FillLevel& others);

    /// The level to which the rays fill all vessels together, to a few percent.
    double level(double rays) const;

private:
    struct Vessels
    {
        double importance = 0.0;
        double lines = 0.0;
    };

    std::vector<Vessels> by_depth_; ///< by lines / importance, the level at which they begin to fill
};

/// The rays of the pairs (i, j < i) of one row i, in order of j.
struct RowOfRays
{
    struct Target
    {
        std::uint32_t patch; ///< j
        std::uint64_t rays;
    };

    std::uint64_t first_ray = 0; ///< number among the rays of all rows
    std::uint64_t end_ray = 0;
    std::vector<Target> targets; ///< that get any
};

/// Which pair of patches gets how many rays, so that the error (1) becomes as small as so many rays can make it. Rows
/// that have their rays may be refined while others are asked for.
class PairRayAllotment
{
public:
    /// The estimate must come from lines of `crossing_area`; `radiosity` [W/m^2] need only be roughly right. Keeps
    /// references to the estimate and to `unoccluded`.
    PairRayAllotment(const ExchangeEstimate& estimate, const Scene& scene, const PairMatrix<float>& unoccluded,
                     double crossing_area, const std::vector<Rgb>& radiosity);

    /// Looks at all rows, before any of them is refined. `seed` of the rounding to whole rays.
    void allot(std::uint64_t rays, std::uint64_t seed, int threads);

    bool any() const { return level_ > 0.0; }
    RowOfRays row(std::uint32_t i) const;
    SharedRange rows_of(Share share) const; ///< those with its part of the rays

    void visit(Archive& archive); ///< for a checkpoint

private:
    double importance(std::uint32_t i, std::uint32_t j, double spread) const;
    template <class Visit>
    void for_uncertain_pairs(std::uint32_t i, const Visit& visit) const;
    double fill_level(std::uint64_t rays, int threads) const;
    std::vector<double> deserved_rays(std::uint32_t i) const;

    const ExchangeEstimate& estimate_;
    const PairMatrix<float>& unoccluded_;
    double crossing_area_;
    std::vector<Rgb> receives_;  ///< rho^2 / A
    std::vector<Rgb> sends_;     ///< B^2
    double level_ = 0.0;         ///< lines and rays that a pair should have for its importance
    double rate_ = 0.0;          ///< rays per ray deserved, so that their number comes out
    std::vector<double> before_; ///< rays before each row, and after the last
};

} // namespace multipath

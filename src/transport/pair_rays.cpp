#include "transport/pair_rays.h"

#include "geometry/first_hits.h"
#include "parallel/ordered_blocks.h"
#include "parallel/shared_blocks.h"
#include "transport/pair_ray_allotment.h"
#include "transport/ray_pair.h"

#include <vector>

namespace multipath {

namespace {

/// Rays of several pairs, traced together.
class SightBlock
{
public:
    explicit SightBlock(const Scene& scene) : scene_(scene) {}

    /// Adds the rays of a pair.
    void add(const RayPair& pair, const Item* items, std::uint64_t rays)
    {
        pairs_.push_back({pair.to_surface(), pair.to_front(), weights_.size(), 0});
        for (std::uint64_t k = 0; k < rays; ++k) {
            const RayPair::Ray ray = pair.ray(items[k]);
            if (!(ray.weight > 0.0))
                continue;
            surfaces_.push_back(pair.from_surface());
            rays_.push_back(ray.line);
            weights_.push_back(ray.weight);
        }
        pairs_.back().end = weights_.size();
    }

    /// Of each pair the visible share, weighted like the light that the rays would carry; below zero if they tell
    /// nothing. Forgets the rays.
    std::vector<double> visible_shares()
    {
        scene_.intersector().closest_hits_from(surfaces_.data(), rays_.data(), rays_.size(), hits_);
        std::vector<double> shares;
        for (const PairOfBlock& pair : pairs_)
            shares.push_back(visible_share(pair));
        pairs_.clear();
        surfaces_.clear();
        rays_.clear();
        weights_.clear();
        return shares;
    }

private:
    struct PairOfBlock
    {
        std::uint32_t to_surface;
        bool to_front;
        std::size_t begin, end; ///< its rays
    };

    double visible_share(const PairOfBlock& pair) const
    {
        double all = 0.0;
        double free = 0.0;
        for (std::size_t k = pair.begin; k < pair.end; ++k) {
            all += weights_[k];
            if (hits_.is_hit(k) && hits_[k].surface == pair.to_surface && hits_[k].front == pair.to_front)
                free += weights_[k];
        }
        return all > 0.0 ? free / all : -1.0;
    }

    const Scene& scene_;
    std::vector<PairOfBlock> pairs_;
    std::vector<std::uint32_t> surfaces_;
    std::vector<Line> rays_;
    std::vector<double> weights_;
    FirstHits hits_;
};

/// Takes what some rays tell of a pair into its estimate, weighted by what both are worth.
void refine(ExchangeEstimate& estimate, const PairMatrix<float>& unoccluded, double crossing_area, std::uint32_t i,
            const RowOfRays::Target& target, double share)
{
    const auto free_exchange = static_cast<double>(unoccluded.at(i, target.patch));
    const double lines = free_exchange / crossing_area; // what the first estimate is worth
    const double part = static_cast<double>(target.rays) / (static_cast<double>(target.rays) + lines);
    float& exchange = estimate.exchange.at(i, target.patch);
    exchange = static_cast<float>((1.0 - part) * static_cast<double>(exchange) + part * free_exchange * share);
    float& variance = estimate.variance.at(i, target.patch);
    variance = static_cast<float>((1.0 - part) * static_cast<double>(variance));
}

} // namespace

void refine_by_rays(ExchangeEstimate& estimate, const Scene& scene, const PairMatrix<float>& unoccluded,
                    double crossing_area, const std::vector<Rgb>& radiosity, const Sequence& sequence,
                    const PairRays& plan, const RunControl& run)
{
    if (plan.rays == 0)
        return;
    const std::uint32_t n = scene.patch_count();
    PairRayAllotment allotment(estimate, scene, unoccluded, crossing_area, radiosity);
    SharedRange rows = {n, 0, 0, n, 1};
    const Checkpoint::Part part(run.checkpoint, "pair rays", [&](Archive& archive) {
        allotment.visit(archive);
        rows.visit(archive);
    });
    if (!part.resumed()) {
        allotment.allot(plan.rays, plan.seed, run.threads);
        if (run.is_share() && allotment.any())
            rows = allotment.rows_of(run.share);
    }
    if (!allotment.any())
        return;

    std::vector<SightBlock> sights(static_cast<std::size_t>(slot_count(run.threads)), SightBlock(scene));
    const auto cast_row = [&](std::uint32_t i, SightBlock& sight) {
        const RowOfRays row = allotment.row(i);
        std::vector<Item> items(static_cast<std::size_t>(row.end_ray - row.first_ray));
        sequence.generate(plan.first_item + row.first_ray, items);
        const Item* next = items.data();
        for (const RowOfRays::Target& target : row.targets) {
            sight.add(RayPair(scene, i, target.patch), next, target.rays);
            next += target.rays;
        }
        const std::vector<double> shares = sight.visible_shares();
        for (std::size_t k = 0; k < shares.size(); ++k)
            if (shares[k] >= 0.0)
                refine(estimate, unoccluded, crossing_area, i, row.targets[k], shares[k]);
        return row.end_ray - row.first_ray;
    };
    std::vector<std::uint64_t> cast(n);
    shared_blocks(
        rows, run,
        [&](std::uint64_t i, int slot) {
            cast[i] = cast_row(static_cast<std::uint32_t>(i), sights[static_cast<std::size_t>(slot)]);
        },
        [&](std::uint64_t i, int) { run.count_lines(cast[i]); });
}

} // namespace multipath

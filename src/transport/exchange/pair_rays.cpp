// Between points x, y that are uniform on their patches a ray weighs cos cos' / r^2. Where the patches come close this
// grows without bound and a few rays would decide everything. There the direction is drawn uniformly from the solid
// angle of the larger patch at x instead; then the weight is the solid angle times the cosine at x.

#include "transport/exchange/pair_rays.h"

#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "parallel/blocks.h"
#include "sampling/warp.h"
#include "transport/exchange/ray_allocation.h"

#include <algorithm>
#include <vector>

namespace multipath {

namespace {

Vec3 point_at(const Surface& shape, double u, double v)
{
    if (shape.shape == Shape::parallelogram)
        return shape.at(u, v);
    const Barycentric place = square_to_uniform_triangle(u, v);
    return shape.at(place.u, place.v);
}

/// No point of the shape is farther from its centre.
double radius(const Surface& shape)
{
    return length(shape.edge_u) + length(shape.edge_v);
}

} // namespace

RayPair::RayPair(const Scene& scene, std::uint32_t one, std::uint32_t other)
{
    const bool one_is_smaller = scene.area(one) <= scene.area(other);
    const std::uint32_t from = one_is_smaller ? one : other;
    const std::uint32_t to = one_is_smaller ? other : one;
    from_ = scene.patch(from);
    to_ = scene.patch(to);
    from_normal_ = from_.shape.normal();
    to_normal_ = to_.shape.normal();
    to_front_ = dot(to_normal_, scene.surfaces()[to_.surface].normal()) > 0.0;
    near_ = length(to_.shape.centre() - from_.shape.centre()) < radius(from_.shape) + radius(to_.shape);
}

RayPair::Ray RayPair::ray(const Item& item) const
{
    const Vec3 start = point_at(from_.shape, item[0], item[1]);
    return near_ ? into_solid_angle(start, item[2], item[3]) : towards_point(start, item[2], item[3]);
}

RayPair::Ray RayPair::towards_point(Vec3 start, double u, double v) const
{
    const Vec3 d = point_at(to_.shape, u, v) - start;
    const double leaving = dot(from_normal_, d);
    const double arriving = -dot(to_normal_, d);
    if (leaving <= 0.0 || arriving <= 0.0)
        return {{start, d}, 0.0};
    const double square = dot(d, d);
    return {{start, d}, leaving * arriving / (square * square)};
}

RayPair::Ray RayPair::into_solid_angle(Vec3 start, double u, double v) const
{
    if (!(dot(to_normal_, start - to_.shape.origin) > 0.0))
        return {{start, to_normal_}, 0.0};
    const auto corner = [&](double a, double b) { return normalized(to_.shape.at(a, b) - start); };
    const SphericalTriangle first(corner(0, 0), corner(1, 0), corner(0, 1));
    const bool has_second = to_.shape.shape == Shape::parallelogram;
    const SphericalTriangle second = has_second ? SphericalTriangle(corner(1, 1), corner(0, 1), corner(1, 0)) : first;
    const double all = first.solid_angle() + (has_second ? second.solid_angle() : 0.0);
    if (!(all > 0.0))
        return {{start, to_normal_}, 0.0};
    const double split = first.solid_angle() / all;
    const Vec3 d = u < split ? first.direction(u / split, v) : second.direction((u - split) / (1.0 - split), v);
    return {{start, d}, all * std::max(0.0, dot(from_normal_, d))};
}

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

    BlockBuffers<SightBlock> sights(run.threads, SightBlock(scene));
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
        rows, run, [&](std::uint64_t i, int slot) { cast[i] = cast_row(static_cast<std::uint32_t>(i), sights[slot]); },
        [&](std::uint64_t i, int) { run.count_lines(cast[i]); });
}

} // namespace multipath

// A pair whose exchange is known with the variance s^2 / m after m rays adds s^2 / m (rho_i^2 B_j^2 / A_i + rho_j^2
// B_i^2 / A_j) to the error (1), up to factors that all pairs share. For a given number of rays in all the sum is
// smallest when m is proportional to s times the root of the bracket.

#include "transport/pair_rays.h"

#include "geometry/first_hits.h"
#include "parallel/ordered_blocks.h"
#include "parallel/shared_blocks.h"
#include "sampling/random.h"
#include "transport/fill_level.h"
#include "transport/ray_pair.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace multipath {

namespace {

double sum_of_products(Rgb a, Rgb b)
{
    return a.r * b.r + a.g * b.g + a.b * b.b;
}

/// How much a pair deserves to be looked at.
class Importance
{
public:
    Importance(const Scene& scene, const std::vector<Rgb>& radiosity)
    {
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const Rgb rho = scene.reflectance(i);
            receives_.push_back((1.0 / scene.area(i)) * (rho * rho));
            sends_.push_back(radiosity[i] * radiosity[i]);
        }
    }
    /// `spread` [m^4]: the variance of the exchange if one ray told it.
    double of(std::uint32_t i, std::uint32_t j, double spread) const
    {
        return std::sqrt(spread *
                         (sum_of_products(receives_[i], sends_[j]) + sum_of_products(receives_[j], sends_[i])));
    }

private:
    std::vector<Rgb> receives_; ///< rho^2 / A
    std::vector<Rgb> sends_;    ///< B^2
};

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

/// The rays of one row of pairs. A running sum over all pairs of what each deserves passes whole numbers: each of them
/// is a ray.
struct RowOfRays
{
    struct Target
    {
        std::uint32_t patch;
        std::uint64_t rays;
    };

    /// The pairs of this row get `rate` times what they deserve; those of the rows before got `before`.
    RowOfRays(const std::vector<double>& deserved, double rate, double before)
        : first_ray(static_cast<std::uint64_t>(std::floor(before))), end_ray(first_ray)
    {
        double sum = 0.0;
        for (std::uint32_t j = 0; j < deserved.size(); ++j) {
            sum += deserved[j];
            const auto reached = static_cast<std::uint64_t>(std::floor(before + rate * sum));
            if (reached > end_ray)
                targets.push_back({j, reached - end_ray});
            end_ray = reached;
        }
    }

    std::uint64_t first_ray;
    std::uint64_t end_ray;
    std::vector<Target> targets;
};

/// Calls visit(j, importance, lines) for the pairs (i, j < i) that leave doubt; the estimate is worth so many lines.
template <class Visit>
void for_uncertain_pairs(const ExchangeEstimate& estimate, const PairMatrix<float>& unoccluded, double crossing_area,
                         const Importance& importance, std::uint32_t i, const Visit& visit)
{
    const float* variance = estimate.variance.row(i);
    const float* free_exchange = unoccluded.row(i);
    for (std::uint32_t j = 0; j < i; ++j)
        if (variance[j] > 0.0f) {
            const double lines = static_cast<double>(free_exchange[j]) / crossing_area;
            const double deserves = importance.of(i, j, static_cast<double>(variance[j]) * lines);
            if (deserves > 0.0)
                visit(j, deserves, lines);
        }
}

/// How many lines and rays a pair should have for its importance.
double fill_level(const ExchangeEstimate& estimate, const PairMatrix<float>& unoccluded, double crossing_area,
                  const Importance& importance, std::uint64_t rays, int threads)
{
    constexpr std::uint32_t parts = 32; // sums of each part in order: the same bits for any number of threads
    const std::uint32_t n = estimate.exchange.size();
    std::vector<FillLevel> levels(parts);
    parallel_blocks(parts, threads, [&](std::uint64_t part) {
        for (auto i = static_cast<std::uint32_t>(part); i < n; i += parts)
            for_uncertain_pairs(
                estimate, unoccluded, crossing_area, importance, i,
                [&](std::uint32_t, double deserves, double lines) { levels[part].add(deserves, lines); });
    });
    FillLevel all;
    for (const FillLevel& level : levels)
        all.add(level);
    return all.level(static_cast<double>(rays));
}

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

/// Which pair gets how many rays.
class RayAllotment
{
public:
    RayAllotment(const ExchangeEstimate& estimate, const PairMatrix<float>& unoccluded, double crossing_area,
                 const Importance& importance)
        : estimate_(estimate), unoccluded_(unoccluded), crossing_area_(crossing_area), importance_(importance)
    {
    }

    /// Looks at all rows, before any of them is refined.
    void allot(const PairRays& plan, int threads)
    {
        const std::uint32_t n = estimate_.exchange.size();
        level_ = fill_level(estimate_, unoccluded_, crossing_area_, importance_, plan.rays, threads);
        std::vector<double> row_sums(n);
        parallel_blocks(n, threads, [&](std::uint64_t number) {
            const auto i = static_cast<std::uint32_t>(n - 1 - number); // long rows first
            for (const double x : deserved_rays(i))
                row_sums[i] += x;
        });
        rate_ = static_cast<double>(plan.rays) / std::accumulate(row_sums.begin(), row_sums.end(), 0.0);
        before_ = {bits_to_unit(random_bits(mix_bits(plan.seed ^ 0x243f6a8885a308d3u), 0))};
        for (const double sum : row_sums)
            before_.push_back(before_.back() + rate_ * sum);
    }

    bool any() const { return level_ > 0.0; }
    RowOfRays row(std::uint32_t i) const { return {deserved_rays(i), rate_, before_[i]}; }

    /// The rows of a share, with its part of the rays.
    SharedRange rows_of(Share share) const
    {
        const std::uint64_t n = before_.size() - 1;
        const auto first_row = [&](std::uint64_t number) -> std::uint64_t {
            if (number == 0 || number == share.of)
                return number == 0 ? 0 : n;
            const double part = static_cast<double>(number) / static_cast<double>(share.of);
            const double rays = before_.front() + part * (before_.back() - before_.front());
            const auto row = std::lower_bound(before_.begin(), before_.end(), rays) - before_.begin();
            return std::min(n, static_cast<std::uint64_t>(row));
        };
        const std::uint64_t first = first_row(share.number);
        return {n, first, first, first_row(share.number + 1)};
    }

    void visit(Archive& archive)
    {
        archive.value<double>("fill level", level_);
        archive.value<double>("rays per deserved ray", rate_);
        archive.growing_list<double>("rays before", before_);
        if (before_.size() != std::size_t{estimate_.exchange.size()} + 1)
            throw ArchiveError("the state is damaged: no such rows");
    }

private:
    std::vector<double> deserved_rays(std::uint32_t i) const
    {
        std::vector<double> row(i);
        for_uncertain_pairs(
            estimate_, unoccluded_, crossing_area_, importance_, i,
            [&](std::uint32_t j, double deserves, double lines) { row[j] = std::max(0.0, level_ * deserves - lines); });
        return row;
    }

    const ExchangeEstimate& estimate_;
    const PairMatrix<float>& unoccluded_;
    double crossing_area_;
    const Importance& importance_;
    double level_ = 0.0;
    double rate_ = 0.0;
    std::vector<double> before_; ///< rays before each row, and after the last
};

} // namespace

void refine_by_rays(ExchangeEstimate& estimate, const Scene& scene, const PairMatrix<float>& unoccluded,
                    double crossing_area, const std::vector<Rgb>& radiosity, const Sequence& sequence,
                    const PairRays& plan, const RunControl& run)
{
    if (plan.rays == 0)
        return;
    const std::uint32_t n = scene.patch_count();
    const Importance importance(scene, radiosity);
    RayAllotment allotment(estimate, unoccluded, crossing_area, importance);
    SharedRange rows = {n, 0, 0, n};
    const Checkpoint::Part part(run.checkpoint, "pair rays", [&](Archive& archive) {
        allotment.visit(archive);
        rows.visit(archive);
    });
    if (!part.resumed()) {
        allotment.allot(plan, run.threads);
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

#include "transport/exchange/pair_rays.h"

#include "base/errors.h"
#include "parallel/blocks.h"
#include "sampling/allotment.h"
#include "sampling/random.h"
#include "sampling/warp.h"
#include "transport/lines/shadow_rays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace multipath {

// A ray between points x, y that are uniform on their patches has the weight cos cos' / r^2. For patches close to each
// other this kernel is unbounded, and a few rays would dominate the mean. For such pairs the direction is uniform in
// the solid angle of the larger patch seen from x instead; the weight is then the solid angle times the cosine at x.

RayPair::RayPair(const Scene& scene, std::uint32_t one, std::uint32_t other)
    : RayPair(scene, scene.patch(scene.area(one) <= scene.area(other) ? one : other),
              scene.patch(scene.area(one) <= scene.area(other) ? other : one))
{
}

RayPair::RayPair(const Scene& scene, const Patch& from, const Patch& to) : from_(from), to_(to)
{
    from_normal_ = from_.shape.normal();
    to_normal_ = to_.shape.normal();
    to_front_ = dot(to_normal_, scene.surfaces()[to_.surface].normal()) > 0.0;
    // Upper bound of the distance of a point of the shape from its centre.
    const auto radius = [](const Surface& shape) { return length(shape.edge_u) + length(shape.edge_v); };
    near_ = length(to_.shape.centre() - from_.shape.centre()) < radius(from_.shape) + radius(to_.shape);
    sampled_area_ = from_.shape.area() * (near_ ? 1.0 : to_.shape.area());
}

RayPair::Ray RayPair::ray(const Item& item) const
{
    const Vec3 start = square_to_uniform_surface(from_.shape, item[0], item[1]);
    const double u = item[2];
    const double v = item[3];
    if (!near_) {
        const Vec3 d = square_to_uniform_surface(to_.shape, u, v) - start;
        const double leaving = dot(from_normal_, d);
        const double arriving = -dot(to_normal_, d);
        const double square = dot(d, d);
        const double weight = leaving > 0.0 && arriving > 0.0 ? leaving * arriving / (square * square) : 0.0;
        return {{start, d}, weight};
    }
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

// Neyman allocation (Neyman 1934). If m rays estimate the exchange of a pair with variance sigma^2 / m, the pair adds
// sigma^2 / m (rho_i^2 B_j^2 / A_i + rho_j^2 B_i^2 / A_j) to the error (1), up to factors common to all pairs. For a
// given total number of rays the sum over the pairs is smallest if m is proportional to sigma times the root of the
// bracket, the importance of the pair. The global lines count as rays that a pair already has, so water-filling finds
// the rest.

namespace {

/// The rays of the pairs (i, j < i) of one row i, in order of j.
struct RowOfRays
{
    struct Target
    {
        std::uint32_t patch; ///< j
        std::uint64_t rays;
        bool to_front = false; ///< see RayPair::to_front
        double all = 0.0;      ///< sum of weights
        double free = 0.0;     ///< that of unoccluded rays
    };

    std::uint64_t first_ray = 0; ///< number of its first ray among the rays of all rows
    std::uint64_t end_ray = 0;   ///< first_ray of the next row
    std::vector<Target> targets; ///< those that get any rays
};

struct RayOfPair
{
    RowOfRays::Target* pair;
    double weight;
};

double sum_of_products(Rgb a, Rgb b)
{
    return a.r * b.r + a.g * b.g + a.b * b.b;
}

/// Allots rays to pairs of patches so that the error (1) becomes as small as possible. row() is thread-safe, also while
/// other rows of the estimate are being refined.
class PairRayAllotment
{
public:
    /// The estimate must come from estimate_exchange with the same `crossing_area` [m^2]; `radiosity` [W/m^2] need only
    /// be roughly right. Keeps references to the estimate and to `unoccluded`.
    PairRayAllotment(const ExchangeEstimate& estimate, const Scene& scene, const PairMatrix<float>& unoccluded,
                     double crossing_area, const std::vector<Rgb>& radiosity)
        : estimate_(estimate), unoccluded_(unoccluded), crossing_area_(crossing_area)
    {
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const Rgb rho = scene.reflectance(i);
            receives_.push_back((1.0 / scene.area(i)) * (rho * rho));
            sends_.push_back(radiosity[i] * radiosity[i]);
        }
    }

    /// Allots `rays` rays, before any row is refined. `seed`: of the rounding to whole rays.
    void allot(std::uint64_t rays, std::uint64_t seed, int threads)
    {
        const std::uint32_t n = estimate_.exchange.size();
        level_ = water_level(rays, threads);
        std::vector<double> row_sums(n);
        parallel_blocks(n, threads, [&](std::uint64_t number) {
            const auto i = static_cast<std::uint32_t>(n - 1 - number); // long rows first
            for (const double x : deserved_rays(i))
                row_sums[i] += x;
        });
        rate_ = static_cast<double>(rays) / std::accumulate(row_sums.begin(), row_sums.end(), 0.0);
        before_ = {bits_to_unit(random_bits(random_key(RandomStream::pair_rays, seed), 0))};
        for (const double sum : row_sums)
            before_.push_back(before_.back() + rate_ * sum);
    }

    bool any() const { return level_ > 0.0; } ///< true if some pair gets rays

    RowOfRays row(std::uint32_t i) const
    {
        const std::vector<double> deserved = deserved_rays(i);
        RowOfRays row;
        row.first_ray = row.end_ray = whole_part(before_[i]); // continues the running sum of the rows before
        double sum = 0.0;
        for (std::uint32_t j = 0; j < deserved.size(); ++j) {
            sum += deserved[j];
            const std::uint64_t end = whole_part(before_[i] + rate_ * sum);
            if (end > row.end_ray)
                row.targets.push_back({j, end - row.end_ray});
            row.end_ray = end;
        }
        return row;
    }

    /// The rows of a shard, with about equal numbers of rays for all shards.
    ShardRange rows_of(Shard shard) const
    {
        const std::uint64_t n = before_.size() - 1;
        const auto first_row = [&](std::uint64_t number) {
            const double part = static_cast<double>(number) / static_cast<double>(shard.of);
            const double rays = before_.front() + part * (before_.back() - before_.front());
            const auto row = std::lower_bound(before_.begin(), before_.end(), rays) - before_.begin();
            return number == shard.of ? n : std::min(n, static_cast<std::uint64_t>(row));
        };
        const std::uint64_t first = first_row(shard.number);
        return {n, first, first, first_row(shard.number + 1), shard.of};
    }

    void visit(Archive& archive) ///< saves to or restores from a checkpoint
    {
        archive.value<double>("fill level", level_);
        archive.value<double>("rays per deserved ray", rate_);
        archive.growing_list<double>("rays before", before_);
        if (before_.size() != std::size_t{estimate_.exchange.size()} + 1)
            throw ArchiveError("the state is damaged: no such rows");
    }

private:
    /// Calls visit(j, importance, lines) for the pairs (i, j < i) whose exchange is uncertain. `lines` is the expected
    /// number of global lines through the pair, from which its estimate comes.
    template <class Visit>
    void for_uncertain_pairs(std::uint32_t i, const Visit& visit) const
    {
        const float* variance = estimate_.variance.row(i);
        const float* free_exchange = unoccluded_.row(i);
        for (std::uint32_t j = 0; j < i; ++j)
            if (variance[j] > 0.0f) {
                const double lines = static_cast<double>(free_exchange[j]) / crossing_area_;
                const double spread = static_cast<double>(variance[j]) * lines; // variance by a single ray [m^4]
                const double importance = std::sqrt(
                    spread * (sum_of_products(receives_[i], sends_[j]) + sum_of_products(receives_[j], sends_[i])));
                if (importance > 0.0)
                    visit(j, importance, lines);
            }
    }

    double water_level(std::uint64_t rays, int threads) const
    {
        constexpr std::uint32_t parts = 32; // added in order: the same bits for any number of threads
        const std::uint32_t n = estimate_.exchange.size();
        std::vector<WaterFilling> levels(parts);
        parallel_blocks(parts, threads, [&](std::uint64_t part) {
            const auto add = [&](std::uint32_t, double importance, double lines) {
                levels[part].add(importance, lines);
            };
            for (auto i = static_cast<std::uint32_t>(part); i < n; i += parts)
                for_uncertain_pairs(i, add);
        });
        WaterFilling all;
        for (const WaterFilling& level : levels)
            all.add(level);
        return all.level(static_cast<double>(rays));
    }

    /// The rays that the water level gives to the pairs (i, j < i), not rounded.
    std::vector<double> deserved_rays(std::uint32_t i) const
    {
        std::vector<double> row(i);
        for_uncertain_pairs(i, [&](std::uint32_t j, double importance, double lines) {
            row[j] = std::max(0.0, level_ * importance - lines);
        });
        return row;
    }

    const ExchangeEstimate& estimate_;
    const PairMatrix<float>& unoccluded_;
    double crossing_area_;
    std::vector<Rgb> receives_;  ///< per patch: rho^2 / A
    std::vector<Rgb> sends_;     ///< per patch: B^2
    double level_ = 0.0;         ///< water level: lines and rays of a pair, per importance
    double rate_ = 0.0;          ///< factor of all deserved rays that makes their sum exact
    std::vector<double> before_; ///< per row: expected rays of all rows before it; then the total
};

/// Combines the estimate of a pair with that of its rays, each weighted by its number of lines or rays.
void refine(ExchangeEstimate& estimate, const PairMatrix<float>& unoccluded, double crossing_area, std::uint32_t i,
            const RowOfRays::Target& target)
{
    const auto free_exchange = static_cast<double>(unoccluded.at(i, target.patch));
    const double lines = free_exchange / crossing_area; // expected number, of the first estimate
    const double part = static_cast<double>(target.rays) / (static_cast<double>(target.rays) + lines);
    const double share = target.free / target.all;
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
    ShardRange rows = {n, 0, 0, n, 1};
    const Checkpoint::Part part(run.checkpoint, "pair rays", [&](Archive& archive) {
        allotment.visit(archive);
        rows.visit(archive);
    });
    if (!part.resumed()) {
        allotment.allot(plan.rays, plan.seed, run.threads);
        if (run.is_shard() && allotment.any())
            rows = allotment.rows_of(run.shard);
    }
    if (!allotment.any())
        return;

    struct Buffer
    {
        std::vector<Item> items;
        ShadowRays<RayOfPair> rays;
        void trace(const Scene& scene)
        {
            rays.trace(scene, [](const RayOfPair& ray, const Hit& hit) {
                if (hit.front == ray.pair->to_front)
                    ray.pair->free += ray.weight;
            });
        }
    };
    BlockBuffers<Buffer> buffers(run.threads);
    std::vector<std::uint64_t> cast(n);
    const auto cast_row = [&](std::uint64_t number, int slot) {
        constexpr std::size_t most_rays = 1u << 14; // at once: bounds the memory, however many rays a pair has
        const auto i = static_cast<std::uint32_t>(number);
        auto& [items, rays] = buffers[slot];
        RowOfRays row = allotment.row(i);
        std::uint64_t next_item = plan.first_item + row.first_ray;
        for (RowOfRays::Target& target : row.targets) {
            const RayPair pair(scene, i, target.patch);
            target.to_front = pair.to_front();
            for (const std::uint64_t end = next_item + target.rays; next_item < end; next_item += items.size()) {
                items.resize(std::min<std::size_t>(end - next_item, most_rays - rays.size()));
                sequence.generate(next_item, items);
                for (const Item& item : items)
                    if (const RayPair::Ray ray = pair.ray(item); ray.weight > 0.0) {
                        rays.add(pair.from_surface(), pair.to_surface(), ray.line, {&target, ray.weight});
                        target.all += ray.weight;
                    }
                if (rays.size() == most_rays)
                    buffers[slot].trace(scene);
            }
        }
        buffers[slot].trace(scene);
        for (const RowOfRays::Target& target : row.targets)
            if (target.all > 0.0)
                refine(estimate, unoccluded, crossing_area, i, target);
        cast[i] = row.end_ray - row.first_ray;
    };
    shard_blocks(rows, run, cast_row, [&](std::uint64_t i, int) { run.count_lines(cast[i]); });
}

} // namespace multipath

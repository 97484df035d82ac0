// Neyman allocation (Neyman 1934). Let a single ray from a patch of area A and reflectance rho estimate the power that
// it receives with standard deviation A sigma. Then m rays give its radiosity the variance rho^2 sigma^2 / m, which
// adds rho^2 sigma^2 A / m to the error (1), up to a factor that all patches share. For a given total number of rays,
// the sum over the patches is smallest with m in proportion to rho sigma sqrt(A), while global lines would cross the
// patches in proportion to A.
//
// The standard deviations sigma are estimated in rounds. The first rounds are small; each round distributes its rays by
// water-filling, so that together with the earlier rays they come as near as possible to the optimum. After each round
// the light is estimated roughly, and after the last the linear system (R1) is solved.

#include "radiosity/reuse/balanced_reuse.h"

#include "base/elementary.h"
#include "base/errors.h"
#include "base/lists.h"
#include "base/memory.h"
#include "radiosity/reuse/exchange_solver.h"
#include "radiosity/run/memory_estimate.h"
#include "sampling/allotment.h"
#include "sampling/random.h"
#include "transport/exchange/line_counts.h"
#include "transport/exchange/sparse_exchange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace multipath {

namespace {

using Field = std::vector<Rgb>;

constexpr std::uint64_t rounds = 3;

/// Total number of rays at the end of each round. The early rounds cast as many as give most patches an estimate, and
/// no more: in large runs they are a small part of all rays.
std::array<std::uint64_t, rounds> ends_of_rounds(std::uint64_t rays, std::uint64_t patches)
{
    const std::uint64_t first = std::max(std::min(rays / 10, 16 * patches), std::min(rays / 2, 2 * patches));
    const std::uint64_t second = std::max(first, std::min(3 * (rays / 10), 64 * patches));
    return {first, second, rays};
}

constexpr double bytes_per_ray = 10.0; // a note at both ends, and for some rays another one until they are sorted
// The solution is not linear in the counts: with this number of rays its bias is about 0.1 % / (1 - R_ave).
constexpr double least_rays_at_once = 24.0; // per patch

/// [bytes] Memory of a run with this number of rays, without the counts. An empirical formula.
double bytes_without_counts(const Scene& scene, double rays)
{
    constexpr double bytes_per_patch = 540.0;
    constexpr double bytes_of_buffers = 20.0; // for each of the first million rays
    return run_bytes(static_cast<double>(scene.surfaces().size()), 0.0) + bytes_per_patch * scene.patch_count() +
           bytes_of_buffers * std::min(rays, 1e6);
}

/// What gets rays: each patch twice, as number 2 i its shadow rays, as number 2 i + 1 its rays over the hemisphere.
struct Receiver
{
    double importance = 0.0;
    double had = 0.0;  ///< number of rays before
    double gets = 0.0; ///< expected number of rays
};

/// Distributes expected rays so that all that the receivers get adds up to `budget`: beyond what they are given already
/// by water-filling, according to importance and the rays that they had before.
void distribute_rays(double budget, std::vector<Receiver>& receivers)
{
    WaterFilling fill;
    double given = 0.0;
    for (const Receiver& r : receivers) {
        given += r.gets;
        if (r.importance > 0.0)
            fill.add(r.importance, r.had + r.gets);
    }
    const double rest = std::max(0.0, budget - given);
    const double level = fill.level(rest);
    const auto lacks = [&](const Receiver& r) { return std::max(0.0, level * r.importance - r.had - r.gets); };
    const double scale =
        quotient(rest, sum_over(receivers, lacks)); // corrects the level, which is exact to a few percent only
    for (Receiver& r : receivers)
        r.gets += scale * lacks(r);
}

/// The lost power that, with the received power, is nearest to the emitted power [W], in one channel. Shadow rays of
/// the patches have estimated the received power, rays of the lamps the losses, with the variances [W^2] `of_received`
/// and `of_lost`. Each changes in proportion to its variance (least squares), and neither becomes negative; without
/// losses only the received power changes.
double closed_losses(double emitted, double received, double of_received, double lost, double of_lost)
{
    const double share = lost > 0.0 ? of_lost / (of_lost + of_received) : 0.0;
    return std::clamp(lost + share * (emitted - received - lost), 0.0, emitted);
}

std::vector<std::uint32_t> patches_of_sky(const Scene& scene)
{
    const auto patch_of = [&](std::uint32_t k) { return scene.first_patch(scene.own_surfaces() + k); };
    return serial_list(scene.file().sky_surfaces, patch_of);
}

/// The rays of one kind in a round, and the part of them that this run casts.
struct RayBatch
{
    std::uint64_t first_item = 0;
    Allotment allotment;
    ShardRange range; ///< range of blocks of this run

    explicit RayBatch(std::uint32_t patches) : allotment(patches) {}

    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("first item", first_item);
        allotment.visit(archive);
        range.visit(archive);
    }
};

class BalancedReuse
{
public:
    BalancedReuse(const Scene& scene, const SceneLights& lights, const Sequence& sequence, const BalancedRays& rays,
                  double memory, const RunControl& run, PowerState& state)
        : scene_(scene),
          sequence_(sequence),
          rays_(rays),
          memory_(memory),
          run_(run),
          state_(state),
          patches_(lights.patches.get())
    {
        if (rays.direct)
            light_.emplace(scene, lights);
    }

    BalancedResult solve()
    {
        const Checkpoint::Part part(run_.checkpoint, "balanced reuse", [this](Archive& archive) { visit(archive); });
        for (bool planned = part.resumed(); part_ < parts_; planned = false) {
            if (!planned)
                plan();
            if (light_)
                light_->cast(to_lights_.allotment, sequence_, to_lights_.first_item, to_lights_.range, run_);
            if (!run_.stopped())
                count_rays(scene_, hemisphere_.allotment, sequence_, hemisphere_.first_item, hemisphere_.range, run_,
                           fresh_);
            if (!run_.stopped() && hemisphere_.range.is_shard())
                run_.checkpoint->publish_shard(); // stops the run
            if (run_.stopped())
                return stopped();
            end_of_round();
        }
        return result(true);
    }

private:
    BalancedResult result(bool solved)
    {
        return {next_item_ - rays_.first_item, solved, solved ? std::move(variance_) : std::vector<Rgb>()};
    }

    void visit(Archive& archive)
    {
        fresh_.merge(run_.threads);
        archive.value<std::uint64_t>("round", round_);
        archive.value<std::uint64_t>("part", part_);
        archive.value<std::uint64_t>("parts", parts_);
        archive.value<std::uint64_t>("next item", next_item_);
        archive.object("to lights", to_lights_);
        archive.object("hemisphere", hemisphere_);
        archive.list<double>("expected", expected_);
        archive.list<double>("rays of counts", rays_of_counts_);
        find_densities();
        archive.list<double>("source", source_);
        archive.list<double>("first guess", guess_);
        archive.list<double>("variance", variance_);
        if (light_)
            light_->visit(archive);
        archive.object("counts", counts_);
        archive.object("fresh counts", fresh_);
        if (round_ >= rounds || part_ >= parts_ || to_lights_.range.all != light_blocks() ||
            hemisphere_.range.all != ray_blocks(hemisphere_.allotment).count())
            throw ArchiveError("the state is damaged: no such rays");
    }

    bool is_last() const { return round_ + 1 == rounds; }
    bool any_ray_is_lost() const
    {
        for (std::uint32_t i = 0; i < n_; ++i)
            if (counts_.escaped(i) + counts_.behind(i) > 0)
                return true;
        return false;
    }
    /// Where rays get lost, those of the first round do not count later. What they have found decides, through the
    /// patches around, how many more rays a patch gets: light that one of them finds by chance would count less, among
    /// many, than darkness found by the few rays of other patches.
    bool forgets_first() const { return round_ == 1 && any_ray_is_lost(); }
    std::uint64_t light_blocks() const { return GatheredLight::blocks(n_).count(); }

    /// Plans the rays of the next round, or of the next part of the last one.
    void plan()
    {
        std::vector<double> shadow_rays = large_vector<double>(n_);
        if (part_ == 0) {
            const auto cast_before = static_cast<double>(next_item_ - rays_.first_item);
            const std::vector<Receiver> expected =
                expected_rays(std::max(0.0, static_cast<double>(ends_[round_]) - cast_before));
            for (std::uint32_t i = 0; i < n_; ++i) {
                shadow_rays[i] = expected[2 * std::size_t{i}].gets;
                expected_[i] = expected[2 * std::size_t{i} + 1].gets;
            }
            if (is_last())
                cut_into_parts(expected_);
        }
        std::vector<double> of_part = expected_;
        for (double& rays : of_part)
            rays /= static_cast<double>(parts_);
        const Shard shard =
            is_last() ? run_.shard : Shard{}; // early rounds are small: each shard does all of their work
        to_lights_.first_item = next_item_;
        const double offset = bits_to_unit(bits_from(sequence_.item(next_item_)));
        to_lights_.allotment = Allotment(shadow_rays, offset);
        to_lights_.range = ShardRange::of(light_blocks(), shard);
        next_item_ += to_lights_.allotment.rays();
        hemisphere_.first_item = next_item_;
        // Offsets that add up to 1 make the total number of rays as planned.
        hemisphere_.allotment = Allotment(of_part, std::min(1.0 - offset, below_one));
        hemisphere_.range = ShardRange::of(ray_blocks(hemisphere_.allotment).count(), shard);
        next_item_ += hemisphere_.allotment.rays();
    }

    /// Expected numbers of rays of all receivers for the next round: importance rho s sqrt(A) by the rounds so far. The
    /// first round knows no s, and gives at least one ray of each kind to every patch that can use it.
    std::vector<Receiver> expected_rays(double budget) const
    {
        std::vector<Receiver> receivers = large_vector<Receiver>(2 * std::size_t{n_});
        const std::vector<double> hemisphere = round_ > 0 ? hemisphere_deviations() : std::vector<double>(n_, 1.0);
        const std::vector<double> light = round_ > 0 && light_ ? light_->deviations() : std::vector<double>(n_, 1.0);
        const double source = mean(scene_.lamp_power());
        const bool afresh = forgets_first();
        const std::vector<double> importance_of = round_ > 0 ? importance_of_irradiance() : std::vector<double>();
        parallel_numbers(n_, run_.threads, [&](std::uint32_t i) {
            constexpr double exponent = 0.35; // of the area, as long as the light is unknown
            const double worth =
                round_ > 0 ? importance_of[i] * std::sqrt(scene_.area(i)) : elementary::pow(scene_.area(i), exponent);
            if (scene_.is_sky_patch(i)) // the rays that reach it are enough
                return;
            const bool sees_light = light_ && light_->unoccluded(i) > 0.0;
            // A ray over the hemisphere counts for both of its ends, and denoising removes most of its noise.
            constexpr double left_of_variance = 0.35;
            const double indirect = rays_.indirect ? worth * std::sqrt(left_of_variance) * hemisphere[i] : 0.0;
            const double least = !rays_.indirect ? 0.0 : round_ == 0 ? 1.0 : afresh ? 2.0 : 0.0;
            constexpr double to_see_losses =
                1.0 / 32.0; // fraction of the rays that leave the sources, to estimate losses
            const double of_source =
                light_ ? to_see_losses * budget * scene_.area(i) * mean(scene_.emittance(i)) / source : 0.0;
            receivers[2 * std::size_t{i}] = {sees_light ? worth * light[i] : 0.0, light_ ? light_->rays(i) : 0.0,
                                             sees_light && round_ == 0 ? 1.0 : 0.0};
            receivers[2 * std::size_t{i} + 1] = {indirect, afresh ? 0.0 : rays_of_counts_[i],
                                                 std::max(least, of_source)};
        });
        distribute_rays(budget, receivers);
        return receivers;
    }

    /// [1] How much an error of each patch's irradiance counts: rho, unless some patches are more important (I1). Then
    /// it is the root of rho^2 w + A (rho Z)^2 / (sum of w A), where w is the weight of the patch and Z its influence
    /// on all important patches by what it reflects. Z is the solution of Z_i = sum of F_ij rho_j (root of w_j + Z_j).
    std::vector<double> importance_of_irradiance() const
    {
        constexpr double dark = 0.01; // the irradiance of black patches matters too, though less
        std::vector<double> result =
            parallel_list(n_, run_.threads, [&](std::uint32_t i) { return mean(rho_[i]) + dark; });
        if (!rays_.importance)
            return result;
        constexpr double even = 0.01; // the weight that all patches keep
        const std::vector<double>& weight = rays_.importance->weight;
        double weighted_area = 0.0;
        for (std::uint32_t i = 0; i < n_; ++i)
            weighted_area += weight[i] * scene_.area(i);
        constexpr int reflections = 8; // more of them would add little, and the result only guides sampling
        std::vector<double> influence(n_);
        for (int k = 0; k < reflections; ++k)
            influence = parallel_list(n_, run_.threads, [&](std::uint32_t i) {
                double sum = 0.0;
                double all = 0.0;
                for_row(i, [&](double w, double rays, std::uint32_t j) {
                    all += rays * w;
                    if (j != nothing)
                        sum += rays * w * (mean(rho_[j]) * std::sqrt(weight[j]) + mean(rho_[j]) * influence[j]);
                });
                return quotient(sum, all);
            });
        for (std::uint32_t i = 0; i < n_; ++i) {
            const double reflected = mean(rho_[i]) * influence[i];
            result[i] = std::sqrt((even + weight[i]) * result[i] * result[i] +
                                  scene_.area(i) * reflected * reflected / weighted_area);
        }
        return result;
    }

    /// [W/m^2] Standard deviation of the radiosity that a single ray over the hemisphere of each patch finds, by the
    /// present estimate of the light and the rays of the patches around. By its own rays a patch whose first rays
    /// happened to agree would get few more, and keep what they found.
    std::vector<double> hemisphere_deviations() const
    {
        constexpr double enough = 32.0;
        std::vector<RaySums> found = parallel_list(n_, run_.threads, [&](std::uint32_t i) {
            RaySums sums;
            for_row(i, [&](double w, double rays, std::uint32_t j) {
                const double light = j != nothing ? mean(guess_[j]) : 0.0;
                const double weight = rays * w;
                sums += {0.0, weight, weight * light, weight * light * light};
            });
            const double scale = quotient(rays_of_counts_[i], sums.weight);
            return RaySums{rays_of_counts_[i], scale * sums.weight, scale * sums.value, scale * sums.square};
        });
        found = pooled(patches_, found, enough, OwnRays::left_out, run_.threads);
        std::vector<double> result = large_vector<double>(n_);
        double sum = 0.0;
        for (std::uint32_t i = 0; i < n_; ++i) {
            result[i] = found[i].standard_deviation();
            sum += scene_.is_sky_patch(i) ? 0.0 : scene_.area(i) * result[i];
        }
        // Where all rays have found the same, others may find what these have missed.
        constexpr double least = 0.1;  // of the mean
        constexpr double unlit = 1e-9; // of the sources, if nothing is left to be found but by chance
        const double floor =
            std::max(least * sum / scene_.own_area(), unlit * mean(scene_.source_power()) / scene_.total_area());
        for (double& deviation : result)
            deviation = std::max(deviation, floor);
        return result;
    }

    std::vector<std::uint32_t> sides_of_patches() const
    {
        return parallel_list(n_, run_.threads,
                             [&](std::uint32_t i) { return 2 * scene_.surface_of(i) + (scene_.is_front(i) ? 0 : 1); });
    }

    /// Sets the number of parts of the last round, so that the counts of each part fit into the memory, but with at
    /// least 24 rays per patch. Throws InputError if a shard would need more than one part.
    void cut_into_parts(std::vector<double>& hemisphere)
    {
        double rays = 0.0;
        for (std::uint32_t i = 0; i < n_; ++i)
            rays += hemisphere[i] + rays_of_counts_[i];
        const double left = memory_ - bytes_without_counts(scene_, rays) - (light_ ? light_->cluster_bytes() : 0.0);
        const double bytes = std::max(left, least_rays_at_once * bytes_per_ray * n_);
        parts_ = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ceil(bytes_per_ray * rays / bytes)));
        if (parts_ > 1 && run_.is_shard())
            throw InputError("the counts of so many lines do not fit into the memory, and parts of them cannot be "
                             "shared; expected more memory, or no shards");
        if (parts_ > 1 || any_ray_is_lost())
            give_all_some(hemisphere);
    }

    /// Raises the numbers of rays to a few in each part, and lowers the larger ones as much: the losses, and each part,
    /// have to be found by rays that are not those of the first round, at patches whose early rays all agreed, too.
    /// Emitters keep those that show their losses.
    void give_all_some(std::vector<double>& hemisphere) const
    {
        const auto takes_part = [&](std::uint32_t i) {
            return !scene_.is_sky_patch(i) && scene_.emittance(i) == Rgb{};
        };
        double all = 0.0;
        for (std::uint32_t i = 0; i < n_; ++i)
            all += takes_part(i) ? hemisphere[i] : 0.0;
        const double least = std::min(4.0 * static_cast<double>(parts_), 0.25 * all / n_);
        double lacking = 0.0;
        double above = 0.0;
        for (std::uint32_t i = 0; i < n_; ++i)
            if (takes_part(i))
                (hemisphere[i] < least ? lacking : above) += std::abs(hemisphere[i] - least);
        const double kept = std::max(0.0, 1.0 - quotient(lacking, above));
        for (std::uint32_t i = 0; i < n_; ++i)
            if (takes_part(i))
                hemisphere[i] = least + kept * std::max(0.0, hemisphere[i] - least);
    }

    /// Adds the counts of this round to those of the earlier ones. Counts of an earlier part are not kept after its
    /// solution.
    void take_fresh_counts()
    {
        const Blocks blocks = ray_blocks(hemisphere_.allotment);
        const std::uint64_t first = blocks.first(hemisphere_.range.first);
        const std::uint64_t end = blocks.first(hemisphere_.range.next);
        for (std::uint32_t i = 0; i < n_; ++i) {
            const auto cast_before = [&](std::uint64_t ray) { return std::clamp(ray, first, end); };
            rays_of_counts_[i] += static_cast<double>(cast_before(hemisphere_.allotment.first_ray(i + 1)) -
                                                      cast_before(hemisphere_.allotment.first_ray(i)));
        }
        find_densities();
        counts_.add(std::move(fresh_), run_.threads);
        fresh_ = LineCounts(n_);
    }

    void find_densities()
    {
        density_ =
            parallel_list(n_, run_.threads, [&](std::uint32_t i) { return rays_of_counts_[i] / scene_.area(i); });
    }

    void forget_counts()
    {
        counts_ = LineCounts(n_);
        std::fill(rays_of_counts_.begin(), rays_of_counts_.end(), 0.0);
    }

    void end_of_round()
    {
        if (forgets_first())
            forget_counts();
        take_fresh_counts();
        if (!is_last()) {
            if (rays_.indirect)
                guess_ = rough_radiosity();
            ++round_;
            return;
        }
        solve_part();
        if (++part_ < parts_)
            forget_counts();
    }

    /// The result of a run that is stopped: solves with the rays so far, except in a shard, in the first round, and
    /// after the first part.
    BalancedResult stopped()
    {
        if (run_.is_shard() || round_ == 0 || part_ > 0)
            return result(false);
        take_fresh_counts();
        parts_ = 1;
        solve_part();
        return result(true);
    }

    /// Some Jacobi iterations with the counts as they are: accurate enough to distribute rays.
    Field rough_radiosity() const
    {
        constexpr int bounces = 3;
        PowerState state = state_;
        receive_light(state);
        const Field source = unshot_radiosity(scene_, state);
        Field radiosity = round_ == 0 ? source : guess_;
        for (int k = 0; k < bounces; ++k)
            radiosity = parallel_list(n_, run_.threads, [&](std::uint32_t i) {
                Rgb found;
                double weight = 0.0;
                for_row(i, [&](double w, double rays, std::uint32_t j) {
                    weight += rays * w;
                    if (j != nothing)
                        found += w * radiosity[j];
                });
                return source[i] + quotient(1.0, weight) * (rho_[i] * found);
            });
        return radiosity;
    }

    /// Calls take(weight of a ray, number of rays, patch) for each patch at the other end of patch i's rays; for rays
    /// that escape this is a patch of the sky, or else `nothing`.
    template <class Take>
    void for_row(std::uint32_t i, const Take& take) const
    {
        if (const std::uint64_t escaped = counts_.escaped(i); escaped > 0)
            take(1.0 / density_[i], static_cast<double>(escaped), sky_.empty() ? nothing : sky_.front());
        if (const std::uint64_t behind = counts_.behind(i); behind > 0)
            take(1.0 / density_[i], static_cast<double>(behind), nothing);
        for (const std::uint32_t j : counts_.row(i))
            take(1.0 / (density_[i] + density_[j]), 1.0, j);
    }
    static constexpr std::uint32_t nothing = Scene::no_patch;

    /// Solves (R1) with the present counts, and adds the fraction 1 / parts_ of the light to the state.
    void solve_part()
    {
        if (part_ == 0) {
            receive_light(state_);
            source_ = unshot_radiosity(scene_, state_);
            add_variance_of_direct_light();
        }
        if (!rays_.indirect)
            return;
        const auto solved = [&](double unseen_rays) {
            const SparseExchange exchange(counts_, scene_.areas(), rays_of_counts_, sides_of_patches(), sky_,
                                          unseen_rays, run_.threads);
            ExchangeSolution solution = solve_exchange(exchange, rho_, source_, guess_, run_.threads);
            if (solution.converged) {
                const double share = 1.0 / static_cast<double>(parts_);
                if (exchange.lost_area() > 0.0)
                    correct_returns(exchange, share, solution.radiosity);
                distribute(scene_, exchange, solution.radiosity, share, run_.threads, state_);
                add_variance(solution.radiosity);
            }
            return solution.converged;
        };
        // If the rays join white patches only with each other, their light stays there for ever: no solution exists.
        if (!solved(0.0) && !solved(1.0))
            throw no_solution(scene_);
    }

    /// Corrects a solution for the light that returns along the ray that brought it (SparseExchange::Returns), and adds
    /// the power that distribute() will not find. Closed scenes need no correction: nothing gets lost on the way back.
    void correct_returns(const SparseExchange& exchange, double share, Field& radiosity)
    {
        constexpr double tolerance = 0.05; // of a correction
        constexpr int most_steps = 100;
        const SparseExchange::Returns returns = exchange.returns(radiosity, rho_, run_.threads);
        const Field source = parallel_list(n_, run_.threads, [&](std::uint32_t i) {
            return (1.0 / scene_.area(i)) * (rho_[i] * returns.incident[i]);
        });
        const ExchangeSolution change =
            solve_exchange(exchange, rho_, source, source, run_.threads, tolerance, most_steps);
        if (!change.converged)
            return;
        Rgb sum = returns.escaped + returns.behind;
        for (std::uint32_t i = 0; i < n_; ++i) {
            radiosity[i] += change.radiosity[i];
            state_.incident[i] += share * returns.incident[i];
            state_.unshot[i] += share * (rho_[i] * returns.incident[i]);
            sum += returns.incident[i];
        }
        state_.escaped += share * returns.escaped;
        state_.behind += share * returns.behind;
        state_.emitted += share * sum; // rounding errors
    }

    /// Adds the variance of the light reflected from the hemisphere, a mean over rays of unequal weights. The variance
    /// of a single ray is taken to be at least that of the surrounding patches' rays, as a few rays may agree by
    /// chance.
    void add_variance(const Field& radiosity)
    {
        constexpr double enough = 64.0;
        const double share = 1.0 / static_cast<double>(parts_);
        Field variances = large_vector<Rgb>(n_);
        std::vector<RaySums> rays = large_vector<RaySums>(n_); // `value` sums the variance of a single ray
        parallel_numbers(n_, run_.threads, [&](std::uint32_t i) {
            double weight = 0.0;
            double squared_weight = 0.0;
            Rgb sum;   // of w B
            Rgb cross; // of w^2 B
            Rgb squares;
            for_row(i, [&](double w, double rays_of_weight, std::uint32_t j) {
                const Rgb light = j != nothing ? radiosity[j] : Rgb{};
                weight += rays_of_weight * w;
                squared_weight += rays_of_weight * w * w;
                sum += w * light; // rays that meet no patch are dark
                cross += (w * w) * light;
                squares += (w * w) * (light * light);
            });
            if (!(weight > 0.0))
                return;
            const auto variance = [&](double s, double c, double square) {
                const double mean = s / weight;
                return std::max(0.0, square - 2.0 * mean * c + mean * mean * squared_weight) / (weight * weight);
            };
            variances[i] = by_channel(variance, sum, cross, squares);
            const double count = weight * weight / squared_weight;
            rays[i] = {count, count, count * count * mean(variances[i]), 0.0};
        });
        const std::vector<RaySums> around = pooled(patches_, rays, enough, OwnRays::counted, run_.threads);
        parallel_numbers(n_, run_.threads, [&](std::uint32_t i) {
            if (!(rays[i].rays > 0.0))
                return;
            const double least = around[i].value / around[i].weight / rays[i].rays;
            const double own = mean(variances[i]);
            const Rgb grey = {least, least, least};
            const Rgb all = own >= least ? variances[i] : own > 0.0 ? (least / own) * variances[i] : grey;
            variance_[i] += (share * share) * (rho_[i] * rho_[i] * all);
        });
    }

    void add_variance_of_direct_light()
    {
        if (!light_)
            return;
        const std::vector<double> deviation = light_->deviations();
        for (std::uint32_t i = 0; i < n_; ++i) {
            if (!(light_->rays(i) > 0.0))
                continue;
            const double direct = mean(source_[i]);
            const Rgb colour = direct > 0.0 ? 1.0 / direct * source_[i] : rho_[i];
            const double reflected = direct > 0.0 ? mean(rho_[i]) : 1.0;
            variance_[i] += (reflected * reflected * deviation[i] * deviation[i] / light_->rays(i)) * (colour * colour);
        }
    }

    /// Moves the direct light of the lamps to the patches, with a closed balance. That of the sky is part of (R1).
    void receive_light(PowerState& state) const
    {
        if (!light_)
            return;
        Field incident = light_->incident();
        const std::vector<double> deviation = light_->deviations();
        Rgb received;
        Rgb escaped;
        Rgb behind;
        Rgb of_lost;              // variances [W^2]
        double of_received = 0.0; // of the mean of the channels
        for (std::uint32_t i = 0; i < n_; ++i) {
            if (scene_.is_sky_patch(i)) // no shadow rays leave it
                continue;
            received += incident[i];
            const double deviation_of_power = scene_.area(i) * deviation[i];
            of_received += quotient(deviation_of_power * deviation_of_power, light_->rays(i));
            const double rays = rays_of_counts_[i];
            if (!(rays > 0.0) || scene_.emittance(i) == Rgb{})
                continue;
            const Rgb power = scene_.area(i) * scene_.emittance(i);
            const double open = static_cast<double>(counts_.escaped(i)) / rays;
            const double back = static_cast<double>(counts_.behind(i)) / rays;
            escaped += open * power;
            behind += back * power;
            const double p = ((open + back) * rays + 0.5) / (rays + 1.0);
            of_lost += (p * (1.0 - p) / rays) * (power * power);
        }
        const Rgb source = scene_.lamp_power();
        const Rgb colour = quotient(1.0, mean(received)) * received;
        const Rgb lost = escaped + behind;
        const Rgb closed = by_channel(closed_losses, source, received, of_received * (colour * colour), lost, of_lost);
        const Rgb scale = quotient(source - closed, received);
        escaped = quotient(closed, lost) * escaped;
        behind = quotient(closed, lost) * behind;
        Rgb found = escaped + behind;
        for (std::uint32_t i = 0; i < n_; ++i) {
            if (scene_.is_sky_patch(i))
                continue;
            incident[i] = scale * incident[i];
            found += incident[i];
            state.incident[i] += incident[i];
            state.unshot[i] = rho_[i] * (incident[i] + scene_.area(i) * scene_.sunlight(i));
        }
        state.escaped += escaped;
        state.behind += behind;
        state.emitted += found - source; // rounding errors
    }

    const Scene& scene_;
    const Sequence& sequence_;
    const BalancedRays rays_;
    const double memory_;
    const RunControl& run_;
    PowerState& state_;
    const SurfaceTree& patches_;
    const std::uint32_t n_ = scene_.patch_count();
    const Field rho_ = reflectances(scene_);
    const std::vector<std::uint32_t> sky_ = patches_of_sky(scene_); ///< patches of the sky
    const std::array<std::uint64_t, rounds> ends_ = ends_of_rounds(rays_.rays, n_);
    std::optional<GatheredLight> light_; ///< empty if the direct light was distributed before

    std::uint64_t round_ = 0;
    std::uint64_t part_ = 0; ///< of the last round
    std::uint64_t parts_ = 1;
    std::uint64_t next_item_ = rays_.first_item; ///< of the sequence
    RayBatch to_lights_{n_};
    RayBatch hemisphere_{n_};
    std::vector<double> expected_ = large_vector<double>(n_);       ///< rays over the hemispheres, for all last parts
    std::vector<double> rays_of_counts_ = large_vector<double>(n_); ///< number of rays that left each patch
    std::vector<double> density_ = large_vector<double>(n_);        ///< [1/m^2] these rays per area of the patch
    LineCounts counts_{n_};
    LineCounts fresh_{n_};                   ///< of the current round
    Field source_ = large_vector<Rgb>(n_);   ///< [W/m^2] unshot after the direct light has arrived
    Field guess_ = large_vector<Rgb>(n_);    ///< [W/m^2] radiosity
    Field variance_ = large_vector<Rgb>(n_); ///< [(W/m^2)^2] of the radiosity
};

} // namespace

std::uint64_t min_balanced_rays(const Scene& scene)
{
    return std::uint64_t{8} * scene.patch_count();
}

double min_balanced_bytes(const Scene& scene)
{
    const double rays = least_rays_at_once * scene.patch_count();
    return bytes_without_counts(scene, rays) + bytes_per_ray * rays;
}

BalancedResult reuse_balanced(const Scene& scene, const SceneLights& lights, const Sequence& sequence,
                              const BalancedRays& rays, double memory, const RunControl& run, PowerState& state)
{
    return BalancedReuse(scene, lights, sequence, rays, memory, run, state).solve();
}

} // namespace multipath

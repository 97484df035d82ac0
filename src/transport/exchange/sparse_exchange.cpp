#include "transport/exchange/sparse_exchange.h"

#include "base/disjoint_sets.h"
#include "base/lists.h"
#include "parallel/blocks.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace multipath {

namespace {

constexpr double rounding_of_rows = 1e-6; // of the area of a patch

struct SumsOverRays // over the rays of a patch
{
    double area = 0.0;    ///< [m^2] of G
    double squares = 0.0; ///< of G^2
    Rgb light;            ///< of G B
    Rgb squared;          ///< of G^2 B
};

struct SentBack // what a patch sends along a ray: G even + G^2 (own - back B)
{
    Rgb even, own, back;
    double lost_ray; ///< [m^2] G of a ray that meets no patch
};

} // namespace

SparseExchange::SparseExchange(const LineCounts& counts, const std::vector<double>& area,
                               const std::vector<double>& cast, const std::vector<std::uint32_t>& side,
                               std::vector<std::uint32_t> sky, double unseen_rays, int threads)
    : counts_(counts), area_(area), cast_(cast), sky_(std::move(sky))
{
    double all_escaped = 0.0;
    double all_lost = 0.0;
    for (std::uint32_t i = 0; i < size(); ++i) {
        unit_ += area[i];
        all_escaped += static_cast<double>(counts.escaped(i));
        all_lost += rays_lost(i);
    }
    for (std::uint32_t i = 0; i < size(); ++i)
        factors_.push_back({static_cast<float>(cast[i] / area[i] * unit_), 1.0f});
    if (all_lost > 0.0)
        find_spaces(side);
    std::vector<double> wanted = large_vector<double>(size()); // [m^2] of all rays of a patch
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        if (is_sky(i))
            return;
        const CountRow row = counts_.row(i);
        lost_rays_[i] = quotient(rays_lost(i), cast[i]) * (cast[i] / area[i]) * area[i];
        const double rays = static_cast<double>(row.last - row.first) + lost_rays_[i];
        wanted[i] = area[i] * quotient(rays, rays + unseen_rays);
    });
    balance(wanted, threads);
    const std::vector<SideLosses> of_sides = losses_of_sides(side);
    if (all_lost > 0.0) {
        correct_losses(side, of_sides);
        balance(wanted, threads);
    }
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        lost_[i] = lost(i);
        const double lacks = area_[i] - joined(i) - lost_[i];
        const bool is_unknown = cast[i] == 0.0 && counts_.row(i).first == counts_.row(i).last;
        const bool is_shared = unseen_rays > 0.0 || (loses(i) && !is_unknown);
        if (lacks <= rounding_of_rows * area_[i] || is_sky(i) || !is_shared) {
            own_[i] = lacks;
            return;
        }
        const double more_lost = unseen_rays > 0.0 ? 0.0 : lacks * of_sides[side[i]].share();
        lost_[i] += more_lost;
        unseen_[i] = lacks - more_lost;
    });
    if (unseen_rays > 0.0) { // light gets from everywhere to everywhere
        space_.assign(size(), 0);
        loses_.assign(size(), false);
    }
    // The patches of a space share their deficits. What a patch would share with itself, much if its space has few
    // patches, is lost if any ray of the space is.
    unseen_sum_ = large_vector<double>(space_.size());
    for (std::uint32_t i = 0; i < space_.size(); ++i)
        unseen_sum_[space_[i]] += unseen_[i];
    for (std::uint32_t i = 0; i < space_.size(); ++i)
        if (unseen_[i] > 0.0 && loses(i)) {
            const double own = unseen_[i] * unseen_[i] / unseen_sum_[space_[i]];
            lost_[i] += own;
            own_[i] -= own;
        }
    const double share_of_all = all_lost > 0.0 ? all_escaped / all_lost : 1.0;
    const double open_area = parallel_sum<double>(size(), threads, [&](std::uint32_t i) {
        const double rays = rays_lost(i);
        open_[i] = lost_[i] * (rays > 0.0 ? static_cast<double>(counts_.escaped(i)) / rays : share_of_all);
        return open_[i];
    });
    sky_area_ = sum_over(sky_, [&](std::uint32_t s) { return area[s]; });
    for (const std::uint32_t s : sky_)
        own_[s] = area_[s] * (1.0 - open_area / sky_area_);
}

void SparseExchange::find_spaces(const std::vector<std::uint32_t>& side)
{
    DisjointSets spaces(size());
    for (std::uint32_t i = 0; i < size(); ++i) {
        const CountRow row = counts_.row(i);
        if (row.first == row.last && i > 0 && side[i] == side[i - 1]) // what lies around a patch without rays
            spaces.unite(i, i - 1);
        for (const std::uint32_t j : row)
            if (j < i)
                spaces.unite(i, j);
    }
    space_ = spaces.roots();
    loses_.assign(size(), false);
    for (std::uint32_t i = 0; i < size(); ++i)
        if (rays_lost(i) > 0.0)
            loses_[space_[i]] = true;
}

std::vector<SparseExchange::SideLosses> SparseExchange::losses_of_sides(const std::vector<std::uint32_t>& side) const
{
    std::vector<SideLosses> sides(size() == 0 ? 0 : *std::max_element(side.begin(), side.end()) + std::size_t{1});
    for (std::uint32_t i = 0; i < size(); ++i)
        if (cast_[i] > 0.0) {
            SideLosses& own = sides[side[i]];
            own.area += area_[i];
            own.lost += area_[i] * rays_lost(i) / cast_[i];
            own.rays += rays_lost(i);
        }
    return sides;
}

/// Scales the lost rays of each side so that its patches lose about as much as their own rays say, which is unbiased
/// with any number of rays. With few rays, and many of others, step 1 shrinks what single rays have lost by chance, and
/// loses nothing where by chance no ray was lost. The correction fades where few rays of the side were lost, or nearly
/// all: there it would carry the noise of the own rays into the exchange with patches.
void SparseExchange::correct_losses(const std::vector<std::uint32_t>& side, const std::vector<SideLosses>& of_sides)
{
    constexpr double most = 2.0;
    constexpr double few_rays = 8.0;               // too few lost rays to correct by
    std::vector<double> lost_now(of_sides.size()); // [m^2] by the rays
    std::vector<double> expected(of_sides.size()); // [m^2] by the rays, if the deficits are lost as by own rays
    for (std::size_t k = 0; k < of_sides.size(); ++k)
        expected[k] = of_sides[k].lost;
    for (std::uint32_t i = 0; i < size(); ++i)
        if (cast_[i] > 0.0) {
            lost_now[side[i]] += lost(i);
            expected[side[i]] -= of_sides[side[i]].share() * std::max(0.0, area_[i] - joined(i) - lost(i));
        }
    for (std::uint32_t i = 0; i < size(); ++i) {
        const SideLosses& own = of_sides[side[i]];
        if (!(lost_now[side[i]] > 0.0))
            continue;
        const double excess = expected[side[i]] / lost_now[side[i]] - 1.0;
        const double trusted = (1.0 - own.share()) * own.rays / (own.rays + few_rays);
        lost_rays_[i] *= std::clamp(1.0 + trusted * excess, 1.0 / most, most);
    }
}

/// [m^2] Exchange area of patch i with all patches after step 1.
double SparseExchange::joined(std::uint32_t i) const
{
    double sum = 0.0;
    for (const std::uint32_t j : counts_.row(i))
        sum += scale(j) / (density(i) + density(j));
    return unit_ * scale(i) * sum;
}

/// [m^2] Exchange area of patch i with no patch after step 1.
double SparseExchange::lost(std::uint32_t i) const
{
    return lost_rays_[i] > 0.0 ? unit_ * scale(i) * lost_rays_[i] / density(i) : 0.0;
}

/// Step 1: finds the densities D with which all rays of each patch have the exchange area `wanted` [m^2]. Where there
/// are none, no patch has more than that.
void SparseExchange::balance(const std::vector<double>& wanted, int threads)
{
    // Each step takes 3/4 of the step of Newton's method for 1 / row sum, which is nearly linear in D, as if the other
    // densities stayed, times the previous change to the power of 1/16, the momentum of Polyak's heavy ball (1964).
    // Where the pairs of a row are spread over the scene, as those of rays are, each step divides the errors by
    // about 4. Errors that remain make closed spaces keep light, and groups of patches that exchange with each other
    // only, like two that face each other, hardly converge.
    constexpr int most_steps = 16;
    constexpr double small_error = 2e-7;   // [1] share of the area
    constexpr double most_change = 1024.0; // of a density, within the range of single precision
    constexpr double most_of_step = 4.0;
    const std::vector<float> cast = parallel_list(size(), threads, [&](std::uint32_t i) {
        factors_[i].scale = 1.0f;
        return factors_[i].density;
    });
    std::vector<float> before = cast;
    std::vector<float> next = cast;
    const double all = parallel_sum<double>(size(), threads, [&](std::uint32_t i) { return wanted[i]; });
    double error = 1.0;
    for (int step = 0; step < most_steps && error > small_error; ++step) {
        const double errors = parallel_sum<double>(size(), threads, [&](std::uint32_t i) {
            const double own = density(i);
            if (!(own > 0.0))
                return 0.0;
            double sum = lost_rays_[i] / own;
            double slope = sum; // -dsum/dD, times D
            for (const std::uint32_t j : counts_.row(i)) {
                const double ray = 1.0 / (own + density(j));
                sum += ray;
                slope += own * ray * ray;
            }
            if (!(sum > 0.0))
                return 0.0;
            const double excess = unit_ * sum / wanted[i] - 1.0;
            const double change = std::clamp(1.0 + 0.75 * excess * sum / slope, 1.0 / most_of_step, most_of_step);
            const double momentum = std::sqrt(std::sqrt(std::sqrt(std::sqrt(own / static_cast<double>(before[i])))));
            const auto first = static_cast<double>(cast[i]);
            const double wished = own * change * momentum;
            const double fitted = std::clamp(wished, first / most_change, first * most_change);
            next[i] = static_cast<float>(fitted);
            return fitted == wished ? std::abs(excess) * wanted[i] : 0.0;
        });
        error = quotient(errors, all);
        parallel_numbers(size(), threads, [&](std::uint32_t i) {
            before[i] = factors_[i].density;
            factors_[i].density = next[i];
        });
    }
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const double sum = joined(i) + lost(i);
        constexpr double below_one = 1.0 - 1.5e-7; // keeps the sum below it after rounding to float
        next[i] = static_cast<float>(sum > 0.0 ? std::min(1.0, below_one * wanted[i] / sum) : 1.0);
    });
    parallel_numbers(size(), threads, [&](std::uint32_t i) { factors_[i].scale = next[i]; });
}

/// [W/m^2] Mean of x over the sky.
Rgb SparseExchange::light_of_sky(const std::vector<Rgb>& x) const
{
    return quotient(1.0, sky_area_) * sum_over(sky_, [&](std::uint32_t s) { return area_[s] * x[s]; });
}

/// Adds light [W] that escapes to the patches of the sky.
void SparseExchange::give_to_sky(Rgb light, std::vector<Rgb>& y) const
{
    for (const std::uint32_t s : sky_)
        y[s] += (area_[s] / sky_area_) * light;
}

/// The exchange by the rays that join patches, after step 1.
std::vector<Rgb> SparseExchange::apply_rays(const std::vector<Rgb>& x, int threads) const
{
    // Scale the light by a power of two, which is exact, into the range of single precision.
    const double sum_of_all = parallel_sum<double>(
        size(), threads, [&](std::uint32_t i) { return std::abs(x[i].r) + std::abs(x[i].g) + std::abs(x[i].b); });
    int exponent = 0;
    std::frexp(sum_of_all, &exponent);
    const double unit_of_light = std::ldexp(1.0, exponent);
    const double to_single = std::ldexp(1.0, -exponent);
    struct Sender // small, since it is read at random indices
    {
        float r, g, b; ///< scaled light
        float density;
    };
    const std::vector<Sender> senders = parallel_list(size(), threads, [&](std::uint32_t i) {
        const Rgb light = to_single * scale(i) * x[i];
        return Sender{static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b),
                      factors_[i].density};
    });
    return parallel_list(size(), threads, [&](std::uint32_t i) {
        const double own = density(i);
        Rgb sum;
        for (const std::uint32_t j : counts_.row(i)) {
            const Sender& sender = senders[j];
            sum += (1.0 / (own + static_cast<double>(sender.density))) *
                   Rgb{static_cast<double>(sender.r), static_cast<double>(sender.g), static_cast<double>(sender.b)};
        }
        return unit_of_light * unit_ * scale(i) * sum;
    });
}

std::vector<Rgb> SparseExchange::apply(const std::vector<Rgb>& x, int threads) const
{
    std::vector<Rgb> y = apply_rays(x, threads);
    const Rgb sky = light_of_sky(x);
    std::vector<Rgb> spread(space_.size()); // [W/m^2] mean of x over the unseen area of each space, at its first patch
    for (std::uint32_t i = 0; i < space_.size(); ++i)
        if (unseen_[i] > 0.0)
            spread[space_[i]] += (unseen_[i] / unseen_sum_[space_[i]]) * x[i];
    const Rgb escaped = parallel_sum<Rgb>(size(), threads, [&](std::uint32_t i) {
        y[i] += own_[i] * x[i] + open_[i] * sky;
        if (unseen_[i] > 0.0)
            y[i] += unseen_[i] * spread[space_[i]];
        return open_[i] * x[i];
    });
    give_to_sky(escaped, y);
    return y;
}

SparseExchange::Returns SparseExchange::returns(const std::vector<Rgb>& radiosity, const std::vector<Rgb>& reflectance,
                                                int threads) const
{
    const Rgb sky = light_of_sky(radiosity);
    const auto for_joined = [&](std::uint32_t i, const auto& take) { // with their G [m^2]
        for (const std::uint32_t j : counts_.row(i))
            take(j, unit_ * scale(i) * scale(j) / (density(i) + density(j)));
    };
    const std::vector<SentBack> senders = parallel_list(size(), threads, [&](std::uint32_t i) -> SentBack {
        SumsOverRays sums;
        for_joined(i, [&](std::uint32_t j, double ray) {
            sums.area += ray;
            sums.squares += ray * ray;
            sums.light += ray * radiosity[j];
            sums.squared += (ray * ray) * radiosity[j];
        });
        // Where few of many rays are the patch's own, what is lost follows from all of them: a lost ray counts as
        // several then. The limit is empirical: half of it costs rooms behind a small window 1 % of their light.
        constexpr double most_of_joined = 4.0;
        const CountRow row = counts_.row(i);
        const double joined_ray = quotient(sums.area, static_cast<double>(row.last - row.first));
        const double of_own = quotient(lost_[i], lost_rays_[i]);
        const double lost_ray = joined_ray > 0.0 ? std::min(of_own, most_of_joined * joined_ray) : of_own;
        sums.area += lost_[i];
        sums.squares += lost_[i] * lost_ray;
        sums.light += open_[i] * sky;
        sums.squared += (open_[i] * lost_ray) * sky;
        if (!(sums.area > 0.0))
            return {};
        constexpr double most = 0.5; // of 1 / (n - 1): a patch of one or two rays has no other ones
        const double repeated = sums.squares / (sums.area * sums.area); // 1 / n
        // Quasi-random rays are less correlated than random ones: measured in open boxes and rooms with windows.
        const double even = std::sqrt(std::min(1.0, 16.0 * repeated));
        const double factor = even * (1.0 / std::max(1.0 - repeated, repeated / most));
        const Rgb sent = (factor / sums.area) * reflectance[i];
        const Rgb irradiance = (1.0 / sums.area) * sums.light;
        const Rgb from_all = (1.0 / sums.area) * (sent * (sums.squared - sums.squares * irradiance));
        return {from_all, sent * irradiance, sent, lost_ray};
    });
    const auto per_lost_area = [&](const SentBack& own) { return own.even + own.lost_ray * own.own; };
    Returns result;
    result.incident = parallel_list(size(), threads, [&](std::uint32_t i) {
        Rgb sum;
        for_joined(i, [&](std::uint32_t j, double ray) {
            const SentBack& from = senders[j];
            sum += ray * from.even + (ray * ray) * (from.own - from.back * radiosity[i]);
        });
        return sum;
    });
    result.behind =
        parallel_sum<Rgb>(size(), threads, [&](std::uint32_t i) { return behind(i) * per_lost_area(senders[i]); });
    const Rgb escaped = parallel_sum<Rgb>(size(), threads, [&](std::uint32_t i) {
        return open_[i] * (per_lost_area(senders[i]) - senders[i].lost_ray * (senders[i].back * sky));
    });
    give_to_sky(escaped, result.incident);
    if (sky_.empty())
        result.escaped = escaped;
    return result;
}

double SparseExchange::lost_area() const
{
    return std::accumulate(lost_.begin(), lost_.end(), 0.0);
}

double SparseExchange::self_exchange(std::uint32_t patch) const
{
    return own_[patch] + (unseen_[patch] > 0.0 ? unseen_[patch] * unseen_[patch] / unseen_sum_[space_[patch]] : 0.0);
}

} // namespace multipath

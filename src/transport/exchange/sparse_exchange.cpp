#include "transport/exchange/sparse_exchange.h"

#include "parallel/blocks.h"
#include "parallel/disjoint_sets.h"
#include "parallel/memory.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr double rounding_of_rows = 1e-6; // of the area of a patch

} // namespace

SparseExchange::SparseExchange(const LineCounts& counts, const std::vector<double>& area,
                               const std::vector<double>& density, std::vector<LossCounts> losses,
                               const std::vector<std::uint32_t>& side, std::vector<std::uint32_t> sky,
                               double unseen_rays, int threads)
    : counts_(counts),
      area_(area),
      factors_(vector_with_capacity<Factors>(area.size())),
      losses_(std::move(losses)),
      sky_(std::move(sky)),
      lost_(large_vector<double>(area.size())),
      own_(large_vector<double>(area.size())),
      unseen_(large_vector<double>(area.size()))
{
    LossCounts all = {0.0, 0.0, 0.0};
    for (std::uint32_t i = 0; i < size(); ++i) {
        unit_ += area[i];
        all.cast += losses_[i].cast;
        all.escaped += losses_[i].escaped;
        all.behind += losses_[i].behind;
    }
    const double lost_share = quotient(all.lost(), all.cast);
    escaping_share_ = all.lost() > 0.0 ? all.escaped / all.lost() : 1.0;
    for (const double d : density)
        factors_.push_back({static_cast<float>(d * unit_), 1.0f});
    if (all.lost() > 0.0)
        find_spaces(side);
    std::vector<double> wanted = large_vector<double>(size()); // [m^2] of rays that join patches
    std::vector<double> lost_part = large_vector<double>(size());
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const CountRow row = counts_.row(i);
        const bool is_known = row.first != row.last; // backs of the sky see nothing
        lost_part[i] = losses_[i].cast + unseen_rays > 0.0 ? part_lost(i, unseen_rays) : is_known ? lost_share : 0.0;
        lost_[i] = area[i] * lost_part[i];
        const double left = area[i] - lost_[i];
        const auto joining = static_cast<double>(row.last - row.first);
        wanted[i] = left > rounding_of_rows * area[i] ? left * quotient(joining, joining + unseen_rays) : 0.0;
    });
    for (const std::uint32_t s : sky_) {
        sky_area_ += area[s];
        lost_[s] = 0.0;
    }
    balance(wanted, unseen_rays > 0.0 ? wanted : area, threads);
    std::vector<double> cut = large_vector<double>(size()); // [m^2] of what is lost, since others' rays join too much
    const double unseen_area = parallel_sum<double>(size(), threads, [&](std::uint32_t i) {
        const double left = area_[i] - joined(i);
        cut[i] = std::max(0.0, lost_[i] - left);
        lost_[i] = std::min(lost_[i], left);
        const double lacks = left - lost_[i];
        const bool is_unknown = density[i] == 0.0 && unseen_rays == 0.0 && counts_.row(i).first == counts_.row(i).last;
        if (lacks <= rounding_of_rows * area_[i] || is_sky(i) || is_unknown) {
            own_[i] = lacks;
            return 0.0;
        }
        const double more_lost = lacks * lost_part[i];
        lost_[i] += more_lost;
        unseen_[i] = lacks - more_lost;
        return unseen_[i];
    });
    if (all.lost() > 0.0)
        move_cut_losses(side, cut);
    if (unseen_area > 0.0) {
        if (space_.empty())
            find_spaces(side);
        if (unseen_rays > 0.0) { // light gets from everywhere to everywhere
            space_.assign(size(), 0);
            loses_.assign(size(), false);
        }
        share_deficits();
    } else
        space_.clear();
    const double open_area = parallel_sum<double>(size(), threads, [&](std::uint32_t i) { return open(i); });
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
        if (losses_[i].lost() > 0.0)
            loses_[space_[i]] = true;
    bound_losses_around(space_);
    bound_losses_around(side);
}

/// The patches around may lie in another space, or face another way: no larger share is lost around a patch than by the
/// other patches of its group.
void SparseExchange::bound_losses_around(const std::vector<std::uint32_t>& group)
{
    struct Sums
    {
        double cast = 0.0;
        double lost = 0.0;
    };
    std::vector<Sums> sums(size() == 0 ? 0 : *std::max_element(group.begin(), group.end()) + std::size_t{1});
    for (std::uint32_t i = 0; i < size(); ++i) {
        sums[group[i]].cast += losses_[i].cast;
        sums[group[i]].lost += losses_[i].lost();
    }
    for (std::uint32_t i = 0; i < size(); ++i) {
        LossCounts& own = losses_[i];
        const Sums& all = sums[group[i]];
        if (all.cast > own.cast)
            own.around = std::min(own.around, (all.lost - own.lost()) / (all.cast - own.cast));
    }
}

/// What is cut off the losses of some patches gets lost from the deficits of others on their side.
void SparseExchange::move_cut_losses(const std::vector<std::uint32_t>& side, const std::vector<double>& cut)
{
    const std::size_t sides = size() == 0 ? 0 : *std::max_element(side.begin(), side.end()) + std::size_t{1};
    std::vector<double> cut_off(sides);
    std::vector<double> unseen(sides);
    for (std::uint32_t i = 0; i < size(); ++i) {
        cut_off[side[i]] += cut[i];
        unseen[side[i]] += loses_[space_[i]] ? unseen_[i] : 0.0;
    }
    for (std::uint32_t i = 0; i < size(); ++i) {
        if (!loses_[space_[i]])
            continue;
        const double moved = unseen_[i] * std::min(1.0, quotient(cut_off[side[i]], unseen[side[i]]));
        lost_[i] += moved;
        unseen_[i] -= moved;
    }
}

/// The patches of a space share their deficits. What a patch would share with itself, much if its space has few
/// patches, is lost if any ray of the space is.
void SparseExchange::share_deficits()
{
    unseen_sum_ = large_vector<double>(size());
    for (std::uint32_t i = 0; i < size(); ++i)
        unseen_sum_[space_[i]] += unseen_[i];
    for (std::uint32_t i = 0; i < size(); ++i)
        if (unseen_[i] > 0.0 && loses_[space_[i]]) {
            const double own = unseen_[i] * unseen_[i] / unseen_sum_[space_[i]];
            lost_[i] += own;
            own_[i] -= own;
        }
}

/// [W/m^2] The mean of x over the unseen area of each space, at its first patch.
std::vector<Rgb> SparseExchange::spread_light(const std::vector<Rgb>& x) const
{
    std::vector<Rgb> light(space_.size());
    for (std::uint32_t i = 0; i < space_.size(); ++i)
        if (unseen_[i] > 0.0)
            light[space_[i]] += (unseen_[i] / unseen_sum_[space_[i]]) * x[i];
    return light;
}

/// [1] Part of the exchange of a patch that reaches no patch. The fraction of its own rays is unbiased, but not always
/// the better estimate. If the patches around have cast far more rays that join the patch, the ratio of its lost
/// exchange to all of it says more. And if rays seldom meet anything, those of two patches seldom agree that anything
/// lies between them, and the balance would leave most of the exchange unsampled: then the exchange by all rays counts
/// as it is, which hardly ever exceeds the area of the patch. Only rays of other patches decide that hits are few.
double SparseExchange::part_lost(std::uint32_t i, double unseen_rays) const
{
    const LossCounts& losses = losses_[i];
    const double own = losses.lost() / (losses.cast + unseen_rays);
    const CountRow row = counts_.row(i);
    if (row.first == row.last || (own == 0.0 && losses.around == 0.0))
        return own;
    const double hits = joined(i) / unit_; // exchange by rays that join patches
    const double of_others = std::max(0.0, 1.0 - 2.0 * own_share(i));
    const double lost = quotient(losses.lost() * area_[i], losses.cast) / unit_;
    const double by_many = (1.0 - of_others) * own + of_others * quotient(lost, lost + hits);
    const double expected_hits = losses.cast * (1.0 - losses.around);
    const double of_few = losses.around / (1.0 + expected_hits * expected_hits);
    return std::clamp((1.0 - of_few) * by_many + of_few * (1.0 - hits * unit_ / area_[i]), 0.0, 1.0);
}

/// [1] Expected share of a patch's own rays among those that join it with others; 1/2 where all patches cast alike.
double SparseExchange::own_share(std::uint32_t i) const
{
    const auto density = static_cast<double>(factors_[i].density);
    double own = 0.0;
    for (const std::uint32_t j : counts_.row(i))
        own += density / (density + static_cast<double>(factors_[j].density));
    const CountRow row = counts_.row(i);
    return row.first == row.last ? 0.5 : own / static_cast<double>(row.last - row.first);
}

/// [1] Upper bounds of the factors of step 1 and of their reciprocals. The few rays of a patch that casts less than
/// those around it, as a black one does, hardly sample what such patches exchange with each other. Without the bound,
/// what the rays of the others have found would be scaled up to fill its row, and white patches would lose too much
/// light to black ones. What is then missing is left to step 2. An empirical formula.
std::vector<float> SparseExchange::largest_scales(double most, int threads) const
{
    std::vector<float> result = large_vector<float>(size());
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const double less = 1.0 - 2.0 * own_share(i);
        result[i] = static_cast<float>(less > 1.0 / (most * most) ? std::sqrt(1.0 / less) : most);
    });
    return result;
}

/// [m^2] Exchange area of a patch with the sky, or with the outside of the scene.
double SparseExchange::open(std::uint32_t patch) const
{
    const LossCounts& losses = losses_[patch];
    return lost_[patch] * (losses.lost() > 0.0 ? losses.escaped / losses.lost() : escaping_share_);
}

/// [m^2] Exchange area of patch i with all patches after step 1.
double SparseExchange::joined(std::uint32_t i) const
{
    const auto density = static_cast<double>(factors_[i].density);
    double sum = 0.0;
    for (const std::uint32_t j : counts_.row(i)) {
        const Factors& other = factors_[j];
        sum += static_cast<double>(other.scale) / (density + static_cast<double>(other.density));
    }
    return unit_ * static_cast<double>(factors_[i].scale) * sum;
}

/// Step 1: finds the factors x for which each patch has the exchange area `wanted` [m^2] with all patches.
/// Where there are no such factors, none has more than `most` [m^2].
void SparseExchange::balance(const std::vector<double>& wanted, const std::vector<double>& most, int threads)
{
    // Each step multiplies x_i by (wanted / sum)^(3/4) and by the previous change of x_i to the power of 1/16, the
    // momentum of Polyak's heavy ball (1964). The power 1/2 alone would converge for certain. Where the
    // pairs of a row are spread over the scene, as those of rays are, each step divides the errors by about 4. Errors
    // that remain make closed spaces leak, and bright surfaces multiply the leak. Groups of patches that exchange with
    // each other only, like two that face each other, hardly converge.
    constexpr int most_steps = 16;
    constexpr double small_leak = 2e-7;   // [1] share of the area
    constexpr double most_scale = 1024.0; // where no factors exist, they would leave the range of single precision
    const auto root = [](double x) { return std::sqrt(x); };
    std::vector<float> next = large_vector<float>(size());
    std::vector<float> before = large_vector<float>(size());
    std::fill(before.begin(), before.end(), 1.0f);
    const double all = parallel_sum<double>(size(), threads, [&](std::uint32_t i) { return wanted[i]; });
    double leak = 1.0;
    const std::vector<float> largest = largest_scales(most_scale, threads);
    for (int step = 0; step < most_steps && leak > small_leak; ++step) {
        const double missing = parallel_sum<double>(size(), threads, [&](std::uint32_t i) {
            const double sum = joined(i);
            const auto scale = static_cast<double>(factors_[i].scale);
            const double momentum = root(root(root(root(scale / static_cast<double>(before[i])))));
            const double change = sum > 0.0 ? root(wanted[i] / sum) * root(root(wanted[i] / sum)) * momentum : 1.0;
            const auto most_of_patch = static_cast<double>(largest[i]);
            next[i] = wanted[i] > 0.0
                          ? static_cast<float>(std::clamp(scale * change, 1.0 / most_of_patch, most_of_patch))
                          : 0.0f;
            return std::abs(wanted[i] - sum);
        });
        leak = all > 0.0 ? missing / all : 0.0;
        parallel_numbers(size(), threads, [&](std::uint32_t i) {
            before[i] = factors_[i].scale;
            factors_[i].scale = next[i];
        });
    }
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const double sum = joined(i);
        constexpr double below_one = 1.0 - 1.5e-7; // keeps the sum below it after rounding to float
        const double limit = sum > 0.0 ? std::min(1.0, below_one * most[i] / sum) : 1.0;
        next[i] = static_cast<float>(static_cast<double>(factors_[i].scale) * limit);
    });
    parallel_numbers(size(), threads, [&](std::uint32_t i) { factors_[i].scale = next[i]; });
}

/// [W/m^2] Mean of x over the sky.
Rgb SparseExchange::light_of_sky(const std::vector<Rgb>& x) const
{
    Rgb sum;
    for (const std::uint32_t s : sky_)
        sum += area_[s] * x[s];
    return quotient(1.0, sky_area_) * sum;
}

/// Adds light [W] that escapes to the patches of the sky.
void SparseExchange::give_to_sky(Rgb light, std::vector<Rgb>& y) const
{
    for (const std::uint32_t s : sky_)
        y[s] += (area_[s] / sky_area_) * light;
}

/// The exchange by the rays that join patches, after step 1.
void SparseExchange::multiply_rays(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const
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
    std::vector<Sender> senders = large_vector<Sender>(size());
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const Rgb light = to_single * static_cast<double>(factors_[i].scale) * x[i];
        senders[i] = {static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b),
                      factors_[i].density};
    });
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        const auto density = static_cast<double>(factors_[i].density);
        Rgb sum;
        for (const std::uint32_t j : counts_.row(i)) {
            const Sender& sender = senders[j];
            sum += (1.0 / (density + static_cast<double>(sender.density))) *
                   Rgb{static_cast<double>(sender.r), static_cast<double>(sender.g), static_cast<double>(sender.b)};
        }
        y[i] = unit_of_light * unit_ * static_cast<double>(factors_[i].scale) * sum;
    });
}

void SparseExchange::multiply(const std::vector<Rgb>& x, int threads, std::vector<Rgb>& y) const
{
    multiply_rays(x, threads, y);
    const Rgb sky = light_of_sky(x);
    const std::vector<Rgb> spread = spread_light(x);
    const Rgb escaped = parallel_sum<Rgb>(size(), threads, [&](std::uint32_t i) {
        y[i] += own_[i] * x[i] + open(i) * sky;
        if (unseen_[i] > 0.0)
            y[i] += unseen_[i] * spread[space_[i]];
        return open(i) * x[i];
    });
    give_to_sky(escaped, y);
}

SparseExchange::Returns SparseExchange::returns(const std::vector<Rgb>& radiosity, const std::vector<Rgb>& reflectance,
                                                int threads) const
{
    const Rgb sky = light_of_sky(radiosity);
    Returns result{large_vector<Rgb>(size()), {}, {}};
    std::vector<Rgb> arriving = large_vector<Rgb>(size()); // [W]
    multiply_rays(radiosity, threads, arriving);
    std::vector<Rgb> weight = large_vector<Rgb>(size()); // rho / (n - 1)
    std::vector<Rgb> excess = large_vector<Rgb>(size()); // rho H / (n - 1)
    struct Open
    {
        Rgb escaped, behind;
        Open& operator+=(const Open& other)
        {
            escaped += other.escaped;
            behind += other.behind;
            return *this;
        }
    };
    const Open lost_light = parallel_sum<Open>(size(), threads, [&](std::uint32_t i) -> Open {
        const auto density = static_cast<double>(factors_[i].density);
        const double back = behind(i);
        double area = lost_[i]; // of all rays
        double squares = 0.0;
        for (const std::uint32_t j : counts_.row(i)) {
            const Factors& other = factors_[j];
            const double ray = unit_ * static_cast<double>(factors_[i].scale) * static_cast<double>(other.scale) /
                               (density + static_cast<double>(other.density));
            area += ray;
            squares += ray * ray;
        }
        // Lost rays, too, if few of many rays are the patch's own: what is lost was found from all of them.
        const CountRow row = counts_.row(i);
        const double joined_ray = quotient(area - lost_[i], static_cast<double>(row.last - row.first));
        const double lost_ray = quotient(lost_[i], losses_[i].lost());
        squares += lost_[i] * (joined_ray > 0.0 ? std::min(lost_ray, 2.0 * joined_ray) : lost_ray);
        if (!(area > 0.0))
            return {};
        constexpr double most = 0.5; // of 1 / (n - 1): a patch of one or two rays has no other ones
        // Quasi-random rays are less correlated than random ones: measured in open boxes by (16 / n)^(1/4).
        const double rays = 1.0 / std::max(squares / (area * area), 1e-30);
        const double even = std::sqrt(std::sqrt(std::min(1.0, 16.0 / rays)));
        weight[i] = even * std::min(most, quotient(squares, area * area - squares)) * reflectance[i];
        const Rgb irradiance = (1.0 / area) * (arriving[i] + open(i) * sky);
        excess[i] = weight[i] * irradiance;
        return {open(i) * (excess[i] - weight[i] * sky), back * excess[i]};
    });
    std::vector<Rgb> weights_around = large_vector<Rgb>(size());
    multiply_rays(weight, threads, weights_around);
    multiply_rays(excess, threads, result.incident);
    parallel_numbers(size(), threads, [&](std::uint32_t i) {
        result.incident[i] = result.incident[i] - weights_around[i] * radiosity[i];
    });
    give_to_sky(lost_light.escaped, result.incident);
    result.escaped = sky_.empty() ? lost_light.escaped : Rgb{};
    result.behind = lost_light.behind;
    return result;
}

double SparseExchange::lost_area() const
{
    double area = 0.0;
    for (const double lost : lost_)
        area += lost;
    return area;
}

double SparseExchange::self_exchange(std::uint32_t patch) const
{
    return own_[patch] + (unseen_[patch] > 0.0 ? unseen_[patch] * unseen_[patch] / unseen_sum_[space_[patch]] : 0.0);
}

double SparseExchange::unseen_share() const
{
    double area = 0.0;
    double unseen = 0.0;
    for (std::uint32_t i = 0; i < size(); ++i) {
        area += area_[i];
        unseen += unseen_[i];
    }
    return quotient(unseen, area);
}

} // namespace multipath

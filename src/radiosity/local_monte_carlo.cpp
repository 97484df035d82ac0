// A particle that meets a patch survives with the mean of the channels of rho and is then coloured by rho over that
// mean: the expectation of what goes on is rho times what arrived, channel by channel, and in a grey scene every
// particle keeps its power.

#include "radiosity/local_monte_carlo.h"

#include "parallel/ordered_blocks.h"
#include "radiosity/first_shot.h"
#include "radiosity/intersection_list.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr std::uint64_t particles_per_block = 1024;

/// One end of a segment.
struct Arrival
{
    std::uint32_t where; ///< patch, Segment::behind or Segment::outside
    Rgb power;           ///< [W] that arrives
    Rgb goes_on;         ///< [W] that leaves again; black where the particle ends
};

/// Appends what happens to one particle from its first segment on.
void follow(const Scene& scene, std::uint32_t from, Rgb power, Item item, std::uint64_t random_key,
            std::vector<Arrival>& arrivals)
{
    std::uint64_t counter = 0;
    const auto number = [&] { return bits_to_unit(random_bits(random_key, counter++)); };
    while (true) {
        const Patch patch = scene.patch(from);
        const std::uint32_t where = receiver(scene, patch.surface, local_line(patch, item));
        const Rgb rho = Segment::is_patch(where) ? scene.reflectance(where) : Rgb{};
        const double survival = mean(rho);
        if (!(number() < survival)) {
            arrivals.push_back({where, power, {}});
            return;
        }
        const Rgb reflected = (1.0 / survival) * (rho * power);
        arrivals.push_back({where, power, reflected});
        power = reflected;
        from = where;
        item = {number(), number(), number(), number()};
    }
}

void deposit(const Scene& scene, const Arrival& arrival, Estimator estimator, PowerState& state)
{
    if (!Segment::is_patch(arrival.where)) {
        (arrival.where == Segment::behind ? state.behind : state.escaped) += arrival.power;
        return;
    }
    const Rgb rho = scene.reflectance(arrival.where);
    const double absorption = 1.0 - mean(rho);
    Rgb counted = arrival.power;
    if (estimator == Estimator::absorption &&
        absorption > 0.0) // nothing ever ends on perfect white: it counts collisions
        counted = arrival.goes_on == Rgb{} ? (1.0 / absorption) * arrival.power : Rgb{};
    state.incident[arrival.where] += counted;
    const Rgb absorbed = (Rgb{1.0, 1.0, 1.0} - rho) * counted;
    state.unshot[arrival.where] += arrival.power - absorbed - arrival.goes_on;
}

/// Sums in two levels: adding equal powers to a large sum 10^8 times would drift.
class PartialSums
{
public:
    explicit PartialSums(PowerState empty) : empty_(std::move(empty)), recent_(empty_) {}

    void deposit_all(const Scene& scene, const std::vector<Arrival>& arrivals, Estimator estimator, PowerState& total)
    {
        for (const Arrival& arrival : arrivals)
            deposit(scene, arrival, estimator, recent_);
        count_ += arrivals.size();
        if (count_ > 4 * recent_.incident.size() + 65536) // seldom enough to cost nothing
            flush(total);
    }
    void flush(PowerState& total)
    {
        for (std::size_t i = 0; i < recent_.incident.size(); ++i) {
            total.incident[i] += recent_.incident[i];
            total.unshot[i] += recent_.unshot[i];
        }
        total.escaped += recent_.escaped;
        total.behind += recent_.behind;
        recent_ = empty_;
        count_ = 0;
    }

private:
    PowerState empty_;
    PowerState recent_;
    std::size_t count_ = 0;
};

/// The particles: which source sends which, counted through.
class Particles
{
public:
    Particles(const Scene& scene, std::vector<Shot> shots, std::uint64_t seed)
        : scene_(scene), shots_(std::move(shots)), key_(mix_bits(seed ^ 0x1f83d9abfb41bd6bu))
    {
        for (const Shot& shot : shots_)
            before_.push_back(before_.back() + shot.rays);
    }

    std::uint64_t count() const { return before_.back(); }
    const std::vector<Shot>& shots() const { return shots_; }

    void follow_one(std::uint64_t particle, const Item& item, std::vector<Arrival>& arrivals) const
    {
        const auto above = std::upper_bound(before_.begin(), before_.end(), particle);
        const Shot& shot = shots_[static_cast<std::size_t>(above - before_.begin()) - 1];
        follow(scene_, shot.patch, shot.power_per_ray, item, random_bits(key_, particle), arrivals);
    }

private:
    const Scene& scene_;
    std::vector<Shot> shots_;
    std::vector<std::uint64_t> before_ = {0};
    std::uint64_t key_;
};

/// How many particles make `lines` segments: counted on a few paths.
std::uint64_t particles_for(const Scene& scene, const PowerState& state, const LocalOptions& options)
{
    const std::uint64_t pilot_particles = std::clamp<std::uint64_t>(options.lines / 16, 256, 65536);
    const Particles pilot(scene, plan_first_shot(scene, state, 0.0, pilot_particles), ~options.seed);
    const std::unique_ptr<Sequence> random = make_sequence("random", ~options.seed);
    std::vector<Arrival> arrivals;
    for (std::uint64_t k = 0; k < pilot.count(); ++k)
        pilot.follow_one(k, random->item(k), arrivals);
    const double segments = static_cast<double>(arrivals.size()) / static_cast<double>(pilot.count());
    return std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::llround(static_cast<double>(options.lines) / segments)));
}

} // namespace

std::uint64_t cast_particles(const Scene& scene, const Sequence& sequence, const LocalOptions& options, int threads,
                             PowerState& state, const LineCounter& count_lines)
{
    const std::uint64_t wanted = particles_for(scene, state, options);
    const Particles particles(scene, plan_first_shot(scene, state, 0.0, wanted), options.seed);
    spend(scene, 0.0, particles.shots(), state);

    struct Block
    {
        std::vector<Item> items;
        std::vector<Arrival> arrivals;
    };
    std::vector<Block> blocks(static_cast<std::size_t>(slot_count(threads)));
    PartialSums sums(PowerState::empty(scene));
    std::uint64_t segments = 0;
    const auto trace = [&](std::uint64_t number, int slot) {
        Block& block = blocks[static_cast<std::size_t>(slot)];
        const std::uint64_t first = number * particles_per_block;
        block.items.resize(static_cast<std::size_t>(std::min(particles_per_block, particles.count() - first)));
        block.arrivals.clear();
        sequence.generate(options.first_item + first, block.items);
        for (std::size_t k = 0; k < block.items.size(); ++k)
            particles.follow_one(first + k, block.items[k], block.arrivals);
    };
    const auto deposit_all = [&](std::uint64_t, int slot) {
        const Block& block = blocks[static_cast<std::size_t>(slot)];
        sums.deposit_all(scene, block.arrivals, options.estimator, state);
        segments += block.arrivals.size();
        count_lines(block.arrivals.size());
    };
    ordered_blocks((particles.count() + particles_per_block - 1) / particles_per_block, threads, trace, deposit_all);
    sums.flush(state);
    return segments;
}

} // namespace multipath

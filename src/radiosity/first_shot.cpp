// Shooting takes three steps. plan_shots() divides the excess of the patches into rays of nearly equal power, spend()
// subtracts it from the patches, and shoot() traces the rays and adds their power to the receivers. Threads trace
// blocks of rays; the receivers are counted in the order of the rays, so the result does not depend on the number of
// threads.

#include "radiosity/first_shot.h"

#include "parallel/blocks.h"
#include "parallel/memory.h"
#include "sampling/allotment.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr std::size_t rays_ahead = 24; // as in the global pass

/// Number of rays before each shot, and the total as the last entry.
std::vector<std::uint64_t> rays_before(const std::vector<Shot>& shots)
{
    std::vector<std::uint64_t> before = {0};
    for (const Shot& shot : shots)
        before.push_back(before.back() + shot.rays);
    return before;
}

std::size_t shot_of_ray(const std::vector<std::uint64_t>& before, std::uint64_t ray)
{
    return static_cast<std::size_t>(std::upper_bound(before.begin(), before.end(), ray) - before.begin()) - 1;
}

/// Number of rays of one shot that arrived at each receiver. Counting first and multiplying by the power later avoids
/// the drift of adding the same number 10^8 times.
class ReceivedRays
{
public:
    explicit ReceivedRays(const Scene& scene) : scene_(scene), counts_(scene.patch_count(), 0) {}

    /// Prefetches the data of a later ray's receiver.
    void fetch(std::uint32_t receiver, const PowerState& state) const
    {
        if (!Segment::is_patch(receiver))
            return;
        prefetch(&counts_[receiver]);
        prefetch(&state.incident[receiver]);
        prefetch(&state.unshot[receiver]);
    }

    void add(std::uint32_t receiver)
    {
        if (receiver == Segment::behind)
            ++behind_;
        else if (receiver == Segment::outside)
            ++outside_;
        else if (counts_[receiver]++ == 0)
            touched_.push_back(receiver);
    }

    /// Reads or writes the counts for a checkpoint.
    void visit(Archive& archive)
    {
        archive.list<std::uint64_t>("receivers", counts_);
        archive.value<std::uint64_t>("behind", behind_);
        archive.value<std::uint64_t>("outside", outside_);
        if (archive.reads())
            for (std::uint32_t i = 0; i < counts_.size(); ++i)
                if (counts_[i] > 0)
                    touched_.push_back(i);
    }

    /// Adds the power of the counted rays, all from `shot`, to the state, and resets the counts.
    void deposit(const Shot& shot, PowerState& state)
    {
        for (const std::uint32_t receiver : touched_) {
            const Rgb power = static_cast<double>(counts_[receiver]) * shot.power_per_ray;
            state.incident[receiver] += power;
            state.unshot[receiver] += scene_.reflectance(receiver) * power;
            counts_[receiver] = 0;
        }
        state.behind += static_cast<double>(behind_) * shot.power_per_ray;
        state.escaped += static_cast<double>(outside_) * shot.power_per_ray;
        touched_.clear();
        behind_ = outside_ = 0;
    }

private:
    const Scene& scene_;
    std::vector<std::uint64_t> counts_;  ///< per patch
    std::vector<std::uint32_t> touched_; ///< patches with a count above zero
    std::uint64_t behind_ = 0;
    std::uint64_t outside_ = 0;
};

} // namespace

void keep_unsent(const std::vector<Shot>& shots, std::uint64_t rays_sent, PowerState& state)
{
    std::uint64_t before = 0;
    for (const Shot& shot : shots) {
        const std::uint64_t sent = std::min(shot.rays, rays_sent - std::min(rays_sent, before));
        if (sent < shot.rays)
            state.unshot[shot.patch] += static_cast<double>(shot.rays - sent) * shot.power_per_ray;
        before += shot.rays;
    }
}

void visit(Archive& archive, const Scene& scene, std::vector<Shot>& shots)
{
    archive.records(shots, field<std::uint32_t>("shooters", &Shot::patch), field<std::uint64_t>("rays", &Shot::rays),
                    field<double>("power per ray", &Shot::power_per_ray));
    for (const Shot& shot : shots)
        if (shot.patch >= scene.patch_count())
            throw ArchiveError("the state is damaged: no such patch");
}

void shoot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const std::vector<Shot>& shots,
           const RunControl& run, PowerState& state)
{
    const std::vector<std::uint64_t> before = rays_before(shots);
    const std::uint64_t ray_count = before.back();
    const Blocks rays = {ray_count, rays_per_block};
    BlockBuffers<RayBlock> blocks(run.threads);

    const auto trace = [&](std::uint64_t number, int slot) {
        RayBlock& block = blocks[slot];
        const std::uint64_t first = rays.first(number);
        block.items.resize(rays.length(number));
        sequence.generate(first_item + first, block.items);
        block.patches.clear();
        for (std::size_t shot = shot_of_ray(before, first); block.patches.size() < block.items.size(); ++shot) {
            const std::uint64_t end = std::min(before[shot + 1] - first, std::uint64_t{block.items.size()});
            block.patches.resize(static_cast<std::size_t>(end), shots[shot].patch);
        }
        block.trace(scene);
    };
    ReceivedRays received(scene);
    std::uint64_t current_shot = 0;
    std::uint64_t next_block = 0;
    const Checkpoint::Part part(run.checkpoint, "shots", [&](Archive& archive) {
        archive.value<std::uint64_t>("next block", next_block);
        archive.value<std::uint64_t>("current shot", current_shot);
        received.visit(archive);
        if (next_block > rays.count() || (ray_count > 0 && current_shot >= shots.size()))
            throw ArchiveError("the state is damaged: no such rays");
    });
    const auto count_receivers = [&](std::uint64_t number, int slot) {
        const RayBlock& block = blocks[slot];
        std::uint64_t ray = rays.first(number);
        const std::size_t count = block.receivers.size();
        for (std::size_t k = 0; k < count; ++k) {
            if (ray++ >= before[current_shot + 1]) {
                received.deposit(shots[current_shot], state);
                current_shot = shot_of_ray(before, ray - 1);
            }
            if (k + rays_ahead < count)
                received.fetch(block.receivers[k + rays_ahead], state);
            received.add(block.receivers[k]);
        }
        run.count_lines(block.receivers.size());
    };
    resumable_blocks(next_block, rays.count(), run, trace, count_receivers);
    if (ray_count > 0)
        received.deposit(shots[current_shot], state);
    keep_unsent(shots, rays.first(next_block), state);
}

namespace {

/// [1] Fraction of a patch's unshot power above the threshold, judged by the mean of the channels.
double share_above(const Scene& scene, const PowerState& state, double threshold, std::uint32_t patch)
{
    const double unshot_radiosity = mean(state.unshot[patch]) / scene.area(patch);
    return unshot_radiosity > threshold && unshot_radiosity > 0.0 ? 1.0 - threshold / unshot_radiosity : 0.0;
}

/// [W] Total power of all rays.
Rgb power_of(const std::vector<Shot>& shots)
{
    Rgb power;
    for (const Shot& shot : shots)
        power += static_cast<double>(shot.rays) * shot.power_per_ray;
    return power;
}

/// Factor by which one channel of the shots must be multiplied to carry exactly the excess, as rounding to whole rays
/// changes their power. Limited, so that a few rays from patches of another colour do not have to carry everything.
double correction_of(double excess, double sent)
{
    constexpr double rounding = 1e-12;
    constexpr double most = 2.0;
    if (!(sent > 0.0) || std::abs(excess - sent) <= rounding * excess)
        return 1.0;
    return std::min(most, excess / sent);
}

/// [1] Fraction of the excess that is sent.
double sent_share(double excess, double sent)
{
    return excess > 0.0 && sent < (1.0 - 1e-9) * excess ? sent / excess : 1.0;
}

} // namespace

double power_above(const Scene& scene, const PowerState& state, double threshold)
{
    double excess = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        excess += share_above(scene, state, threshold, i) * mean(state.unshot[i]);
    return excess;
}

std::vector<Shot> plan_shots(const Scene& scene, const PowerState& state, const ShotRule& rule)
{
    std::vector<Shot> shots;
    Rgb excess;                  // [W]
    double wanted = rule.offset; // cumulative number of rays, not rounded
    SystematicRounding rounding(rule.offset);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double share = share_above(scene, state, rule.threshold, i);
        if (share == 0.0)
            continue;
        excess += share * state.unshot[i];
        const double deserved = share * mean(state.unshot[i]) / rule.power_by_line;
        wanted += deserved;
        const std::uint64_t rays = rounding.up_to(wanted);
        if (rays > 0) {
            // A patch that deserves 0.3 rays gets one in three of ten cases, with the power of a whole ray.
            const double sharers = deserved < 1.0 ? deserved : static_cast<double>(rays);
            shots.push_back({i, rays, (share / sharers) * state.unshot[i]});
        }
    }
    const Rgb sent = power_of(shots);
    const Rgb correction = {correction_of(excess.r, sent.r), correction_of(excess.g, sent.g),
                            correction_of(excess.b, sent.b)};
    for (Shot& shot : shots)
        shot.power_per_ray = correction * shot.power_per_ray;
    return shots;
}

std::vector<Shot> plan_first_shot(const Scene& scene, const PowerState& state, double threshold, std::uint64_t rays)
{
    const double excess = power_above(scene, state, threshold);
    if (rays == 0 || !(excess > 0.0))
        return {};
    return plan_shots(scene, state, {threshold, excess / static_cast<double>(rays), 0.5});
}

void spend(const Scene& scene, double threshold, const std::vector<Shot>& shots, PowerState& state)
{
    if (shots.empty())
        return;
    Rgb all; // [W] total excess
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        all += share_above(scene, state, threshold, i) * state.unshot[i];
    const Rgb sent = power_of(shots);
    const Rgb share = {sent_share(all.r, sent.r), sent_share(all.g, sent.g), sent_share(all.b, sent.b)};
    Rgb spent;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Rgb excess = share * (share_above(scene, state, threshold, i) * state.unshot[i]);
        state.unshot[i] = state.unshot[i] - excess;
        spent += excess;
    }
    state.emitted += sent - spent; // rounding errors
}

std::uint64_t ray_count(const std::vector<Shot>& shots)
{
    std::uint64_t rays = 0;
    for (const Shot& shot : shots)
        rays += shot.rays;
    return rays;
}

} // namespace multipath

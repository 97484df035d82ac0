// Shooting takes three steps. plan_shots() divides the excess of the patches into rays of nearly equal power, spend()
// subtracts it from the patches, and the rays carry it to their receivers.

#include "radiosity/first_shot.h"

#include "parallel/memory.h"
#include "parallel/stage.h"
#include "sampling/allotment.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// Number of rays before each shot, and the total as the last entry.
std::vector<std::uint64_t> rays_before(const std::vector<Shot>& shots)
{
    std::vector<std::uint64_t> before = {0};
    for (const Shot& shot : shots)
        before.push_back(before.back() + shot.rays);
    return before;
}

/// Number of rays of one shot that arrived at each receiver. Counting first and multiplying by the power later avoids
/// the drift of adding the same number 10^8 times.
class ReceivedRays
{
public:
    explicit ReceivedRays(const Scene& scene) : scene_(scene), counts_(scene.patch_count(), 0) {}

    /// Counts the rays first ... end - 1. `state`, into which they will be deposited, is prefetched.
    void add(const std::vector<std::uint32_t>& receivers, std::size_t first, std::size_t end, const PowerState& state)
    {
        constexpr std::size_t rays_ahead = 24; // as in the global pass
        for (std::size_t k = first; k < end; ++k) {
            if (k + rays_ahead < receivers.size())
                fetch(receivers[k + rays_ahead], state);
            add(receivers[k]);
        }
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

    void visit(Archive& archive) ///< for a checkpoint
    {
        archive.list<std::uint64_t>("receivers", counts_);
        archive.value<std::uint64_t>("behind", behind_);
        archive.value<std::uint64_t>("outside", outside_);
        if (archive.reads())
            for (std::uint32_t i = 0; i < counts_.size(); ++i)
                if (counts_[i] > 0)
                    touched_.push_back(i);
    }

private:
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

    const Scene& scene_;
    std::vector<std::uint64_t> counts_;  ///< per patch
    std::vector<std::uint32_t> touched_; ///< patches with a count above zero
    std::uint64_t behind_ = 0;
    std::uint64_t outside_ = 0;
};

/// The rays of all shots, in order.
class ShotRays
{
public:
    using Block = RayBlock;

    ShotRays(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const std::vector<Shot>& shots,
             PowerState& state)
        : scene_(scene),
          sequence_(sequence),
          first_item_(first_item),
          shots_(shots),
          before_(rays_before(shots)),
          state_(state),
          received_(scene)
    {
    }

    Blocks lines() const { return {before_.back(), rays_per_block}; }

    void trace(std::uint64_t number, RayBlock& block) const
    {
        const std::uint64_t first = lines().first(number);
        block.items.resize(lines().length(number));
        sequence_.generate(first_item_ + first, block.items);
        block.patches.clear();
        for (std::size_t shot = shot_of_ray(first); block.patches.size() < block.items.size(); ++shot) {
            const std::uint64_t end = std::min(before_[shot + 1] - first, std::uint64_t{block.items.size()});
            block.patches.resize(static_cast<std::size_t>(end), shots_[shot].patch);
        }
        block.trace(scene_);
    }

    std::uint64_t take(std::uint64_t number, const RayBlock& block)
    {
        const std::uint64_t first = lines().first(number);
        const std::uint64_t end = first + block.receivers.size();
        for (std::uint64_t ray = first; ray < end;) {
            if (ray >= before_[shot_ + 1]) {
                received_.deposit(shots_[shot_], state_);
                shot_ = shot_of_ray(ray);
            }
            const std::uint64_t end_of_shot = std::min(end, before_[shot_ + 1]);
            received_.add(block.receivers, static_cast<std::size_t>(ray - first),
                          static_cast<std::size_t>(end_of_shot - first), state_);
            ray = end_of_shot;
        }
        return block.receivers.size();
    }

    /// Deposits the rays of the last shot.
    void finish()
    {
        if (!shots_.empty())
            received_.deposit(shots_[shot_], state_);
    }

    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("current shot", shot_);
        received_.visit(archive);
        if (!shots_.empty() && shot_ >= shots_.size())
            throw ArchiveError("the state is damaged: no such rays");
        const Archive::Inner inner(archive, "state");
        state_.visit(archive);
    }

private:
    std::size_t shot_of_ray(std::uint64_t ray) const
    {
        return static_cast<std::size_t>(std::upper_bound(before_.begin(), before_.end(), ray) - before_.begin()) - 1;
    }

    const Scene& scene_;
    const Sequence& sequence_;
    const std::uint64_t first_item_;
    const std::vector<Shot>& shots_;
    const std::vector<std::uint64_t> before_;
    PowerState& state_;
    ReceivedRays received_;
    std::uint64_t shot_ = 0; ///< the one whose rays are being counted
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

void shoot(const Scene& scene, const Sequence& sequence, std::uint64_t first_item, const std::vector<Shot>& shots,
           const RunControl& run, PowerState& state)
{
    ShotRays rays(scene, sequence, first_item, shots, state);
    const std::uint64_t sent = run_stage("shots", rays, run); // (S1)
    rays.finish();
    keep_unsent(shots, sent, state);
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

#include "radiosity/paper/shots.h"

#include "base/lists.h"
#include "sampling/random.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// [1] Fraction of a patch's unshot power above the threshold, judged by the mean of the channels. A patch that has
/// spent its excess may differ from the threshold by a rounding error, which is not shot.
double share_above(const Scene& scene, const PowerState& state, double threshold, std::uint32_t patch)
{
    constexpr double rounding = 1e-12;
    const double unshot_radiosity = mean(state.unshot[patch]) / scene.area(patch);
    const bool above = unshot_radiosity > (1.0 + rounding) * threshold && unshot_radiosity > 0.0;
    return above ? 1.0 - threshold / unshot_radiosity : 0.0;
}

/// [W] Total power of all rays.
Rgb power_of(const std::vector<Shot>& shots)
{
    return sum_over(shots, [](const Shot& shot) { return static_cast<double>(shot.rays) * shot.power_per_ray; });
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

/// Start of the systematic rounding to whole rays (whole_part), in [0, 1). It is random: with a fixed one, the same
/// sources would never get a ray. Where each is worth a ray it is 0.5 in the first pass, for every seed.
double rounding_offset(const Scene& scene, const PowerState& state, double threshold, double power_by_line,
                       std::uint64_t seed, std::uint64_t pass)
{
    bool any_below_a_ray = false;
    for (std::uint32_t i = 0; i < scene.patch_count() && !any_below_a_ray; ++i) {
        const double excess = share_above(scene, state, threshold, i) * mean(state.unshot[i]);
        any_below_a_ray = excess > 0.0 && excess < power_by_line;
    }
    return pass == 0 && !any_below_a_ray
               ? 0.5
               : bits_to_unit(random_bits(random_key(RandomStream::rounded_shots, seed), pass));
}

} // namespace

double power_above(const Scene& scene, const PowerState& state, double threshold)
{
    double excess = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        excess += share_above(scene, state, threshold, i) * mean(state.unshot[i]);
    return excess;
}

std::vector<Shot> plan_shots(const Scene& scene, const PowerState& state, double threshold, double power_by_line,
                             std::uint64_t seed, std::uint64_t pass)
{
    std::vector<Shot> shots;
    if (!(power_by_line > 0.0))
        return shots;
    Rgb excess;                                                                              // [W]
    double due_so_far = rounding_offset(scene, state, threshold, power_by_line, seed, pass); // rays so far, not rounded
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double share = share_above(scene, state, threshold, i);
        if (share == 0.0)
            continue;
        excess += share * state.unshot[i];
        const double rays_due = share * mean(state.unshot[i]) / power_by_line;
        const std::uint64_t before = whole_part(due_so_far);
        due_so_far += rays_due;
        if (const std::uint64_t rays = whole_part(due_so_far) - before; rays > 0) {
            // A patch that is worth 0.3 rays gets one in three of ten cases, with the power of a whole ray.
            const double rays_expected = rays_due < 1.0 ? rays_due : static_cast<double>(rays);
            shots.push_back({i, rays, (share / rays_expected) * state.unshot[i]});
        }
    }
    const Rgb sent = power_of(shots);
    const Rgb correction = by_channel(correction_of, excess, sent);
    for (Shot& shot : shots)
        shot.power_per_ray = correction * shot.power_per_ray;
    return shots;
}

std::vector<Shot> plan_first_shot(const Scene& scene, const PowerState& state, double threshold, std::uint64_t rays,
                                  std::uint64_t seed)
{
    const double excess = power_above(scene, state, threshold);
    if (rays == 0 || !(excess > 0.0))
        return {};
    return plan_shots(scene, state, threshold, excess / static_cast<double>(rays), seed, 0);
}

void spend(const Scene& scene, double threshold, const std::vector<Shot>& shots, PowerState& state)
{
    if (shots.empty())
        return;
    Rgb all; // [W] total excess
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        all += share_above(scene, state, threshold, i) * state.unshot[i];
    const Rgb sent = power_of(shots);
    const Rgb share = by_channel(sent_share, all, sent);
    Rgb spent;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Rgb excess = share * (share_above(scene, state, threshold, i) * state.unshot[i]);
        state.unshot[i] = state.unshot[i] - excess;
        spent += excess;
    }
    state.emitted += sent - spent; // rounding errors of the sums
}

Allotment rays_of(const std::vector<Shot>& shots)
{
    Allotment rays;
    for (const Shot& shot : shots)
        rays.append(shot.rays);
    return rays;
}

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

} // namespace multipath

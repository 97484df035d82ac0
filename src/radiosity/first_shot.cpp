#include "radiosity/first_shot.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// [1] Share of a patch's unshot power that lies above the threshold; in colour, the mean of the channels decides.
double share_above(const Scene& scene, const PowerState& state, double threshold, std::uint32_t patch)
{
    const double unshot_radiosity = mean(state.unshot[patch]) / scene.area(patch);
    return unshot_radiosity > threshold && unshot_radiosity > 0.0 ? 1.0 - threshold / unshot_radiosity : 0.0;
}

/// [W] Of all rays together.
Rgb power_of(const std::vector<Shot>& shots)
{
    Rgb power;
    for (const Shot& shot : shots)
        power += static_cast<double>(shot.rays) * shot.power_per_ray;
    return power;
}

/// Rounded to whole rays, the shots of a channel carry more or less than the excess: the factor that makes them carry
/// just that. A few rays from patches of another colour are not made to carry everything.
double correction_of(double excess, double sent)
{
    constexpr double rounding = 1e-12;
    constexpr double most = 2.0;
    if (!(sent > 0.0) || std::abs(excess - sent) <= rounding * excess)
        return 1.0;
    return std::min(most, excess / sent);
}

/// Share of the excess that is sent.
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
    double wanted = rule.offset; // rays up to and including this patch, before rounding down
    double given = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double share = share_above(scene, state, rule.threshold, i);
        if (share == 0.0)
            continue;
        excess += share * state.unshot[i];
        const double deserved = share * mean(state.unshot[i]) / rule.power_by_line;
        wanted += deserved;
        const double rays = std::floor(wanted) - given;
        given += rays;
        if (rays > 0.0) {
            // The only ray that a patch worth 0.3 rays gets three times out of ten carries a whole ray's power.
            const double sharers = deserved < 1.0 ? deserved : rays;
            shots.push_back({i, static_cast<std::uint64_t>(rays), (share / sharers) * state.unshot[i]});
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
    Rgb all; // excess [W]
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

// A particle that meets a patch survives with the mean of the channels of rho and is then coloured by rho over that
// mean: the expectation of what goes on is rho times what arrived, channel by channel, and in a grey scene every
// particle keeps its power.

#include "radiosity/particles.h"

#include "sampling/random.h"
#include "transport/intersection_list.h"
#include "transport/local_ray.h"

#include <algorithm>
#include <cmath>

namespace multipath {

Particles::Particles(const Scene& scene, std::vector<Shot> shots, std::uint64_t seed)
    : scene_(scene), shots_(std::move(shots)), key_(mix_bits(seed ^ 0x1f83d9abfb41bd6bu))
{
    for (const Shot& shot : shots_)
        before_.push_back(before_.back() + shot.rays);
}

void Particles::follow(std::uint64_t particle, const Item& first_item, std::vector<ParticleStep>& steps) const
{
    const auto above = std::upper_bound(before_.begin(), before_.end(), particle);
    const Shot& shot = shots_[static_cast<std::size_t>(above - before_.begin()) - 1];
    const std::uint64_t random_key = random_bits(key_, particle);
    std::uint64_t counter = 0;
    const auto number = [&] { return bits_to_unit(random_bits(random_key, counter++)); };

    std::uint32_t from = shot.patch;
    Rgb power = shot.power_per_ray;
    Item item = first_item;
    while (true) {
        const Patch patch = scene_.patch(from);
        const std::uint32_t where = receiver(scene_, patch.surface, local_line(patch, item));
        const Rgb rho = Segment::is_patch(where) ? scene_.reflectance(where) : Rgb{};
        const double survival = mean(rho);
        const double drawn = number();
        if (!(drawn < survival)) {
            steps.push_back({from, item, where, power, drawn, {}});
            return;
        }
        const Rgb reflected = (1.0 / survival) * (rho * power);
        steps.push_back({from, item, where, power, drawn, reflected});
        power = reflected;
        from = where;
        item = {number(), number(), number(), number()};
    }
}

Particles plan_particles(const Scene& scene, const PowerState& state, std::uint64_t lines, std::uint64_t seed)
{
    const std::uint64_t pilot_particles = std::clamp<std::uint64_t>(lines / 16, 256, 65536);
    const Particles pilot(scene, plan_first_shot(scene, state, 0.0, pilot_particles), ~seed);
    const std::unique_ptr<Sequence> random = make_sequence("random", ~seed);
    std::vector<ParticleStep> steps;
    for (std::uint64_t k = 0; k < pilot.count(); ++k)
        pilot.follow(k, random->item(k), steps);
    const double segments = static_cast<double>(steps.size()) / static_cast<double>(pilot.count());
    const auto wanted = static_cast<std::uint64_t>(std::llround(static_cast<double>(lines) / segments));
    return Particles(scene, plan_first_shot(scene, state, 0.0, std::max<std::uint64_t>(1, wanted)), seed);
}

Rgb counted_power(const Scene& scene, const ParticleStep& step, Estimator estimator)
{
    const double absorption = 1.0 - mean(scene.reflectance(step.where));
    if (estimator == Estimator::collision || !(absorption > 0.0)) // nothing ever ends on perfect white
        return step.power;
    return step.goes_on == Rgb{} ? (1.0 / absorption) * step.power : Rgb{};
}

} // namespace multipath

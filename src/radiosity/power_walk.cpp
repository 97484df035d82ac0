#include "radiosity/power_walk.h"

namespace multipath {

PowerWalk::PowerWalk(const Scene& scene, double crossings_per_area, bool bidirectional, const PowerState& state)
    : bidirectional_(bidirectional)
{
    patches_.reserve(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double crossings = crossings_per_area * scene.area(i);
        const double departures = bidirectional_ ? crossings : 0.5 * crossings; // half of them leave the front
        patches_.push_back({scene.reflectance(i), (1.0 / departures) * state.unshot[i], {}, {}}); // (G3)
    }
}

void PowerWalk::visit(Archive& archive)
{
    archive.list<double>("patches", patches_);
}

void PowerWalk::finish(const WalkTally& total, double scale, PowerState& state) const
{
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        state.emitted = state.emitted - state.unshot[i];
        state.incident[i] += scale * patches_[i].incident;
        state.unshot[i] = scale * patches_[i].held;
    }
    state.emitted += scale * total.forecast_sent;
    state.escaped += scale * total.escaped;
    state.behind += scale * total.behind;
}

} // namespace multipath

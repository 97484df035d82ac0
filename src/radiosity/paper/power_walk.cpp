#include "radiosity/paper/power_walk.h"

#include <algorithm>

namespace multipath {

PowerWalk::PowerWalk(const Scene& scene, double crossings_per_area, bool bidirectional, const PowerState& state)
    : bidirectional_(bidirectional)
{
    patches_.reserve(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double crossings = crossings_per_area * scene.area(i);
        // Both ways, every crossing sends; one way, only the half that leaves through the front.
        const double departures = bidirectional_ ? crossings : 0.5 * crossings;
        patches_.push_back({scene.reflectance(i), (1.0 / departures) * state.unshot[i], {}, {}}); // (G3)
    }
}

void PowerWalk::visit(Archive& archive)
{
    archive.value<double>("tally", total_);
    archive.list<double>("patches", patches_);
}

void PowerWalk::follow(const std::vector<Segment>& segments)
{
    WalkTally tally; // sums of one block stay small, and so do the rounding errors of the balance
    const std::size_t count = segments.size();
    for (std::size_t k = 0; k < count; ++k) {
        fetch(segments[std::min(k + prefetch_distance, count - 1)]);
        follow(segments[k], tally);
    }
    total_ += tally;
}

void PowerWalk::finish(double scale, PowerState& state) const
{
    for (std::size_t i = 0; i < patches_.size(); ++i) {
        state.emitted = state.emitted - state.unshot[i]; // what was sent of it counts instead
        state.incident[i] += scale * patches_[i].incident;
        state.unshot[i] = scale * patches_[i].held;
    }
    state.emitted += scale * total_.forecast_sent;
    state.escaped += scale * total_.escaped;
    state.behind += scale * total_.behind;
}

} // namespace multipath

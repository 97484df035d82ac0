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

// The following functions are the innermost loop of the program.

namespace {

/// Patch i sends to j (M1), and j to i what j had before the exchange (M2).
void exchange(WalkingPower& i, WalkingPower& j, WalkTally& tally)
{
    const Rgb sent_by_i = i.to_send(); // (M1)
    const Rgb sent_by_j = j.to_send(); // (M2): both from before the exchange
    tally.forecast_sent += i.forecast;
    tally.forecast_sent += j.forecast;
    i.receive(sent_by_j);
    j.receive(sent_by_i);
}

/// Patch i sends to j, in the direction of the line only.
void send(WalkingPower& i, WalkingPower& j, WalkTally& tally)
{
    const Rgb sent = i.to_send(); // (M1)
    tally.forecast_sent += i.forecast;
    i.held = {};
    j.incident += sent;
    j.held += j.reflectance * sent;
}

/// Patch i sends along a segment whose other end is no patch. `where`: Segment::behind or Segment::outside.
void lose(WalkingPower& i, std::uint32_t where, WalkTally& tally)
{
    (where == Segment::behind ? tally.behind : tally.escaped) += i.to_send();
    tally.forecast_sent += i.forecast;
    i.held = {};
}

} // namespace

void PowerWalk::follow(const Segment& segment, WalkTally& tally)
{
    if (segment.joins_patches() && bidirectional_)
        exchange(patches_[segment.from], patches_[segment.to], tally);
    else if (segment.joins_patches())
        send(patches_[segment.from], patches_[segment.to], tally);
    else if (Segment::is_patch(segment.from))
        lose(patches_[segment.from], segment.to, tally);
    else if (bidirectional_)
        lose(patches_[segment.to], segment.from, tally);
}

void PowerWalk::follow(const std::vector<Segment>& segments)
{
    WalkTally tally; // sums of one block stay small, and so do the rounding errors of the balance
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const Segment later = segments[std::min(k + prefetch_distance, segments.size() - 1)];
        for (const std::uint32_t end : {later.from, later.to})
            if (Segment::is_patch(end))
                prefetch_all(patches_[end]);
        follow(segments[k], tally);
    }
    total_.forecast_sent += tally.forecast_sent;
    total_.escaped += tally.escaped;
    total_.behind += tally.behind;
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

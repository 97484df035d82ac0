#pragma once

#include "base/memory.h"
#include "radiosity/paper/power_state.h"
#include "transport/lines/line_segments.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// The data of a patch that an exchange reads and writes, together in memory.
struct WalkingPower
{
    Rgb reflectance; ///< [1]
    Rgb forecast;    ///< [W] power sent along every line that leaves the patch (G3)
    Rgb held;        ///< [W] reflected power, to be sent along the next line that leaves the patch
    Rgb incident;    ///< [W] power that arrived in this pass

    Rgb to_send() const { return forecast + held; }
    void receive(Rgb power)
    {
        incident += power;
        held = reflectance * power; // it has just sent all that it held
    }
};

/// [W] Sums over some lines.
struct WalkTally
{
    Rgb forecast_sent; ///< forecasts that patches sent
    Rgb escaped;       ///< power that left the scene
    Rgb behind;        ///< power that met a side without a patch

    WalkTally& operator+=(const WalkTally& other)
    {
        forecast_sent += other.forecast_sent;
        escaped += other.escaped;
        behind += other.behind;
        return *this;
    }
};

/// The walk of power from patch to patch along global lines. The result depends on the order of the segments.
class PowerWalk
{
public:
    /// Starts a pass that distributes the unshot power of `state`. `crossings_per_area` [1/m^2] is the expected number
    /// of lines that cross each square metre of a patch, from either side, in the whole pass (G1). `bidirectional`:
    /// power flows both ways along each line (M2), otherwise only in the direction of the line.
    PowerWalk(const Scene& scene, double crossings_per_area, bool bidirectional, const PowerState& state);

    /// Lets power flow along the segments, one after the other.
    void follow(const std::vector<Segment>& segments);
    void follow(const Segment& segment) { follow(segment, total_); }

    const WalkingPower& at(std::uint32_t patch) const { return patches_[patch]; }

    void visit(Archive& archive); ///< for a checkpoint

    /// Ends the pass: adds its result to the state, and replaces the unshot power by what the patches still hold. All
    /// powers are multiplied by `scale` [1], the number of planned lines over the number of lines that were followed.
    void finish(double scale, PowerState& state) const;

private:
    void follow(const Segment& segment, WalkTally& tally);
    /// Prefetches the patches of a later segment.
    void fetch(const Segment& segment) const
    {
        fetch(segment.from);
        fetch(segment.to);
    }
    void fetch(std::uint32_t end) const
    {
        if (!Segment::is_patch(end))
            return;
        const char* first = reinterpret_cast<const char*>(&patches_[end]);
        prefetch(first);
        prefetch(first + sizeof(WalkingPower) - 1); // an entry spans two cache lines, or three small ones
    }
    /// Patch i sends to j (M1). If power flows both ways, j sends to i what j had before the exchange (M2).
    void exchange(WalkingPower& i, WalkingPower& j, WalkTally& tally) const;
    /// Patch i sends along a segment whose other end is no patch. `where`: Segment::behind or Segment::outside.
    void lose(WalkingPower& i, std::uint32_t where, WalkTally& tally) const;

    bool bidirectional_;
    LargeVector<WalkingPower> patches_;
    WalkTally total_;
};

// Inline: this is the innermost loop of the program.

inline void PowerWalk::follow(const Segment& segment, WalkTally& tally)
{
    if (segment.joins_patches())
        exchange(patches_[segment.from], patches_[segment.to], tally);
    else if (Segment::is_patch(segment.from))
        lose(patches_[segment.from], segment.to, tally);
    else if (bidirectional_)
        lose(patches_[segment.to], segment.from, tally);
}

inline void PowerWalk::exchange(WalkingPower& i, WalkingPower& j, WalkTally& tally) const
{
    const Rgb sent_by_i = i.to_send(); // (M1)
    tally.forecast_sent += i.forecast;
    if (!bidirectional_) {
        i.held = {};
        j.incident += sent_by_i;
        j.held += j.reflectance * sent_by_i;
        return;
    }
    const Rgb sent_by_j = j.to_send(); // (M2): both from before the exchange
    tally.forecast_sent += j.forecast;
    i.receive(sent_by_j);
    j.receive(sent_by_i);
}

inline void PowerWalk::lose(WalkingPower& i, std::uint32_t where, WalkTally& tally) const
{
    (where == Segment::behind ? tally.behind : tally.escaped) += i.to_send();
    tally.forecast_sent += i.forecast;
    i.held = {};
}

} // namespace multipath

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

    const WalkingPower& at(std::uint32_t patch) const { return patches_[patch]; }

    void visit(Archive& archive); ///< for a checkpoint

    /// Ends the pass: adds its result to the state, and replaces the unshot power by what the patches still hold. All
    /// powers are multiplied by `scale` [1], the number of planned lines over the number of lines that were followed.
    void finish(double scale, PowerState& state) const;

private:
    void follow(const Segment& segment, WalkTally& tally);

    bool bidirectional_;
    LargeVector<WalkingPower> patches_;
    WalkTally total_;
};

} // namespace multipath

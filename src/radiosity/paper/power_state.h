#pragma once

#include "base/archive.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Balance of the power of the sources [W]: emitted = absorbed + unshot + escaped + behind, in each channel.
struct PowerBalance
{
    /// Power that the sources sent or still hold, or that arrived from the sun. It differs from `source` by a random
    /// error, the noise of the forecast (multipath.h).
    Rgb emitted;
    Rgb absorbed; ///< power that patches absorbed
    /// Power that patches emitted or reflected, but had not sent on when the work ended. Where a linear system was
    /// solved, this is its residual, and a negative one is noise of `absorbed`.
    Rgb unshot;
    Rgb escaped; ///< power that left the scene through an opening, or reached the sky
    Rgb behind;  ///< power that met a surface on a side that has no patch

    Rgb source; ///< Phi_T, the power of the sources
    /// [W] Upper estimate of the standard error of the mean of `emitted` over the channels, for independent global
    /// lines. 0 if no line carries a forecast.
    double emitted_error = 0.0;

    /// [1] Largest difference between the two sides of the balance in any channel, relative to `emitted` or `source`,
    /// whichever is larger.
    double relative_error() const;
};

/// Power received and held by the patches: the state that all stages of the solver advance.
struct PowerState
{
    /// The initial state: the patches of sources hold the power that they emit. Sunlit patches have received the
    /// sunlight, and hold the reflected part of it.
    explicit PowerState(const Scene& scene);
    /// A state of zeros, for sums.
    static PowerState empty(const Scene& scene);

    void visit(Archive& archive); ///< saves the state to a checkpoint or restores it

    std::vector<Rgb> incident; ///< [W] per patch: power received so far
    std::vector<Rgb> unshot;   ///< [W] per patch: power emitted or reflected, but not yet sent on
    Rgb emitted;               ///< [W] see PowerBalance::emitted
    Rgb escaped;               ///< [W] see PowerBalance::escaped
    Rgb behind;                ///< [W] see PowerBalance::behind
    /// [W] Sum of (1 - rho) * incident over the patches, minus the absorbed power with which the balance closes. This
    /// difference is noise of the estimator, of either sign.
    Rgb surplus;
    double emitted_variance = 0.0; ///< [W^2] square of PowerBalance::emitted_error
};

/// Closes the balance after a stage that distributed all light from `sources` [W]. `absorbed`, `escaped` and `behind`
/// [W] are the estimated losses of this light; the caller must have added its incident power to PowerState::incident.
/// The three losses come from different lines and do not add up to `sources`, so one factor per channel scales them.
/// The scaled `escaped` and `behind` are added to the state, and PowerState::surplus grows by as much as `absorbed`
/// shrinks. If all three losses are 0 in a channel, the power of the sources is added to the unshot power of the first
/// patch.
void settle_losses(Rgb sources, Rgb absorbed, Rgb escaped, Rgb behind, PowerState& state);

/// Adds `share` [1] times one balance to another. Standard errors add up as those of independent estimates.
void add(const PowerBalance& part, double share, PowerBalance& sum);

/// The balance of a state. Light on the patches of the sky counts as escaped, not as absorbed.
PowerBalance power_balance(const Scene& scene, const PowerState& state);

/// [W/m^2] Radiosity B = E + rho H of every patch: its emittance plus the reflected part of its irradiance.
std::vector<Rgb> radiosity(const Scene& scene, const PowerState& state);

} // namespace multipath

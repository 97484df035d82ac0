#pragma once

#include "parallel/archive.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Balance of the power of the sources [W]: emitted = absorbed + unshot + escaped + behind, in each channel.
struct PowerBalance
{
    /// Power that the sources sent or still hold, or that arrived from the sun. It differs from `source` by the noise
    /// of the forecast (multipath.h), at random.
    Rgb emitted;
    Rgb absorbed; ///< power that patches absorbed
    Rgb unshot;   ///< power that patches emitted or reflected, but had not sent on when the work ended
    Rgb escaped;  ///< power that left the scene through an opening, or reached the sky
    Rgb behind;   ///< power that met a surface on a side that has no patch

    Rgb source; ///< Phi_T, the power of the sources
    /// [W] Upper estimate of the standard error of `emitted` for independent global lines, mean of the channels. 0 if
    /// no line needs a forecast.
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
    /// [W] Sum of (1 - rho) * incident over the patches, minus the power that the lines really left there. It is the
    /// noise of the estimator, of either sign.
    Rgb surplus;
    double emitted_variance = 0.0; ///< [W^2] square of PowerBalance::emitted_error
};

/// Closes the balance for an estimate of all light from `sources` [W]. `absorbed`, `escaped` and `behind` [W] are the
/// estimated losses; PowerState::incident already contains the light of which `absorbed` is the absorbed part. The
/// three losses come from different lines and do not add up to `sources`, so one factor per channel scales them: the
/// state gets the scaled `escaped` and `behind`, and the change of `absorbed` goes into PowerState::surplus. In a
/// channel without losses, the power of the sources is added to the unshot power of the first patch.
void settle_losses(Rgb sources, Rgb absorbed, Rgb escaped, Rgb behind, PowerState& state);

/// Adds `share` [1] times one balance to another. Standard errors add up as those of independent estimates.
void add(const PowerBalance& part, double share, PowerBalance& sum);

/// The balance of a state. Light on the patches of the sky counts as escaped, not as absorbed.
PowerBalance power_balance(const Scene& scene, const PowerState& state);

/// [W/m^2] Radiosity B = E + rho H of every patch: its emittance plus the reflected part of its irradiance.
std::vector<Rgb> radiosity(const Scene& scene, const PowerState& state);

} // namespace multipath

#pragma once

#include "parallel/archive.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Balance of the power of the sources, per channel [W]. emitted = absorbed + unshot + escaped + behind.
struct PowerBalance
{
    Rgb emitted;  ///< sent or held by the sources, or received from the sun; differs from Phi_T by the forecast's noise
    Rgb absorbed; ///< by the patches
    Rgb unshot;   ///< received or emitted, not yet sent on when the work ended
    Rgb escaped;  ///< left the scene through an opening, or reached the sky
    Rgb behind;   ///< met a surface on a side that has no patch

    Rgb source; ///< Phi_T; `emitted` without the noise of the forecast
    /// [W] Upper estimate of the standard error of `emitted` for independent global lines, mean of the channels. 0 if
    /// no line needs a forecast.
    double emitted_error = 0.0;

    /// Largest error of the balance over the channels, relative to `emitted` or `source`, whichever is larger.
    double relative_error() const;
};

/// Power received and held by the patches: the state that all stages of the solver advance.
struct PowerState
{
    /// The initial state: sources hold the power that they emit, and sunlit patches what they reflect of the sunlight.
    explicit PowerState(const Scene& scene);
    /// All zero, for sums.
    static PowerState empty(const Scene& scene);

    void visit(Archive& archive); ///< for a checkpoint

    std::vector<Rgb> incident; ///< [W] per patch, received so far
    std::vector<Rgb> unshot;   ///< [W] per patch, emitted or reflected, not yet sent on
    Rgb emitted;               ///< [W] see PowerBalance
    Rgb escaped;               ///< [W]
    Rgb behind;                ///< [W]
    /// [W] Sum of (1 - rho) * incident over the patches, minus the power that was really absorbed there: the noise of
    /// the estimator, of either sign.
    Rgb surplus;
    double emitted_variance = 0.0; ///< [W^2] see PowerBalance::emitted_error
};

/// Closes the balance for an estimate of all light from `sources` [W]. The arguments state the estimated losses;
/// incident power of the state contains `absorbed` already. They come from different lines and do not add up to
/// `sources`, so one factor per channel scales all of them, the absorbed part by PowerState::surplus. In a channel in
/// which nothing was found, the power stays unshot at the first patch.
void settle_losses(Rgb sources, Rgb absorbed, Rgb escaped, Rgb behind, PowerState& state);

/// Adds `share` times one balance to another. Standard errors add up as those of independent estimates.
void add(const PowerBalance& part, double share, PowerBalance& sum);

PowerBalance power_balance(const Scene& scene, const PowerState& state);

/// B = E + rho H per patch [W/m^2].
std::vector<Rgb> radiosity(const Scene& scene, const PowerState& state);

} // namespace multipath

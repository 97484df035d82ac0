#pragma once

#include "parallel/archive.h"
#include "scene/scene.h"

#include <vector>

namespace multipath {

/// Where the power of the sources went, per channel [W]. emitted = absorbed + unshot + escaped + behind.
struct PowerBalance
{
    Rgb emitted;  ///< really sent or held by the sources, or brought by the sun; the forecast of the global pass makes
                  ///< it differ from Phi_T
    Rgb absorbed; ///< by the patches that it reached
    Rgb unshot;   ///< received or emitted, not yet sent on when the work ended
    Rgb escaped;  ///< left the scene through an opening, or arrived in the sky
    Rgb behind;   ///< met a surface on a side that has no patch

    Rgb source; ///< Phi_T, what an exact forecast would emit
    /// [W] Standard error of `emitted`, mean of the channels: at most about as much is to be expected of independent
    /// global lines. 0 where nothing is forecast.
    double emitted_error = 0.0;

    /// Largest |emitted - the rest| of the channels, relative to the emitted power or Phi_T, whichever is larger.
    double relative_error() const;
};

/// What the patches have received and still hold: the state that every stage of the solver moves forward.
struct PowerState
{
    /// Before anything was sent: the sources hold what they emit, and patches in the sun what they reflect of it.
    explicit PowerState(const Scene& scene);
    /// All zero, to be added to another.
    static PowerState empty(const Scene& scene);

    void visit(Archive& archive); ///< for a checkpoint

    std::vector<Rgb> incident; ///< [W] per patch, arrived so far
    std::vector<Rgb> unshot;   ///< [W] per patch, emitted or reflected, not yet sent on
    Rgb emitted;               ///< [W] see PowerBalance
    Rgb escaped;               ///< [W]
    Rgb behind;                ///< [W]
    /// [W] By how much (1 - rho) incident, summed over the patches, exceeds the power that particles left there: noise
    /// of their estimator, of either sign.
    Rgb surplus;
    double emitted_variance = 0.0; ///< [W^2] see PowerBalance::emitted_error
};

/// Adds what became of the power of sources, as an estimate has found it [W]: absorbed, which the incident power of the
/// state holds already, and lost. The three parts come from different lines, and do not add up: all are taken in
/// proportion, the absorbed one by PowerState::surplus.
void settle_losses(Rgb sources, Rgb absorbed, Rgb escaped, Rgb behind, PowerState& state);

/// Adds a share of one balance to another.
void add(const PowerBalance& part, double share, PowerBalance& sum);

PowerBalance power_balance(const Scene& scene, const PowerState& state);

/// B = E + rho H per patch [W/m^2].
std::vector<Rgb> radiosity(const Scene& scene, const PowerState& state);

} // namespace multipath

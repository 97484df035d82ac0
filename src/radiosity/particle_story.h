#pragma once

#include "radiosity/line_story.h"
#include "radiosity/particles.h"
#include "radiosity/solve_options.h"

#include <optional>
#include <vector>

namespace multipath {

/// One segment of a told particle's path.
struct ToldStep
{
    ParticleStep step;
    Line ray;
    std::optional<Meeting> meeting;
    Rgb counted; ///< [W] what the estimator adds to the incident power of the patch
};

/// A particle of local Monte Carlo from its source to its end (L1).
struct ToldParticle
{
    LineOrigin origin;
    std::vector<ToldStep> steps;
};

/// Some particles of a run.
struct ParticleStory
{
    std::uint64_t particles_in_all = 0;
    std::size_t sources = 0; ///< patches that emit
    std::vector<ToldParticle> particles;
};

/// Follows the particles of the range, each from its source to its end. Throws SettingsError for particles that
/// the run does not have, and what solve throws.
ParticleStory tell_particles(const Scene& scene, const SolveOptions& options, const ToldRange& range);

} // namespace multipath

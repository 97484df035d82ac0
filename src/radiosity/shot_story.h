#pragma once

#include "radiosity/extended_first_shot.h"
#include "radiosity/line_story.h"
#include "radiosity/solve_options.h"

#include <optional>
#include <vector>

namespace multipath {

/// A ray of the (extended) first shot (S1).
struct ShotRay
{
    LineOrigin origin;
    std::uint32_t shooter; ///< patch
    Line ray;
    std::optional<Meeting> meeting;
    std::uint32_t where; ///< patch, Segment::behind or Segment::outside
    Rgb power;           ///< [W]
    Rgb unshot;          ///< [W] of the patch where it arrives, afterwards
};

/// Some rays of one pass.
struct ShotStory
{
    std::vector<ShotPass> shot_passes; ///< all of the run
    std::size_t pass = 0;              ///< the one told, from 0
    double threshold = 0.0;            ///< [W/m^2] (4)
    std::size_t shooters = 0;          ///< patches that send rays in the pass
    std::vector<ShotRay> rays;
};

/// Follows the rays of a pass (from 0) up to the last one of the range and tells those in it. Throws SettingsError for
/// a pass or rays that the run does not have, and what solve throws.
ShotStory tell_shot_pass(const Scene& scene, const SolveOptions& options, std::size_t pass, const ToldRange& range);

} // namespace multipath

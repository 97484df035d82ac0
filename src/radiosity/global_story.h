#pragma once

#include "radiosity/extended_first_shot.h"
#include "radiosity/line_story.h"
#include "radiosity/solve_options.h"

#include <cstddef>
#include <vector>

namespace multipath {

/// What a patch sends along a stretch of a line (M1).
struct Transfer
{
    std::uint32_t from; ///< patch
    std::uint32_t to;   ///< patch, Segment::behind or Segment::outside
    Rgb forecast;       ///< [W] (G3)
    Rgb held;           ///< [W] before

    Rgb sent() const { return forecast + held; }
};

/// A stretch between two meetings that follow each other, or before the first or after the last one.
struct Stretch
{
    std::size_t after; ///< number of meetings before it
    Segment segment;
    std::vector<Transfer> transfers; ///< two when power flows both ways (M2); all with what was held before either
    Rgb from_holds;                  ///< [W] afterwards; black without a patch
    Rgb to_holds;                    ///< [W] afterwards; black without a patch
};

/// A chord of the sphere or of the box and everything that happens along it.
struct GlobalLine
{
    LineOrigin origin;
    Vec3 from;
    Vec3 to;
    std::vector<Meeting> meetings;  ///< in order
    std::vector<Stretch> stretches; ///< those that touch a patch, in order
};

/// Some lines of the global pass of a run, with what the run does before.
struct GlobalStory
{
    std::vector<ShotPass> shot_passes;
    std::uint64_t local_lines = 0;    ///< N_l
    std::uint64_t lines_charged = 0;  ///< N_g (N1)
    std::uint64_t lines_cast = 0;     ///< N_cast
    double crossings_per_area = 0.0;  ///< [1/m^2] (G1), both directions
    std::uint64_t unshot_patches = 0; ///< patches with a forecast
    Rgb unshot;                       ///< [W] what the pass distributes
    std::vector<GlobalLine> lines;
};

/// Walks the lines of the global pass up to the last one of the range and tells those in it. Throws SettingsError
/// for lines that the pass does not have, and what solve throws.
GlobalStory tell_global_pass(const Scene& scene, const SolveOptions& options, const ToldRange& range);

} // namespace multipath

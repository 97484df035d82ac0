#pragma once

#include "radiosity/extended_first_shot.h"
#include "radiosity/local_monte_carlo.h"
#include "radiosity/solve_options.h"
#include "sampling/sequence.h"
#include "transport/lines/line_segments.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// The traces: what single lines of a run do, for readers who want to follow the method step by step. They are made by
// the functions that the solver itself calls, in its order and with its items, so that what is told is what happens.

namespace multipath {

/// Which lines of a stage are told, counted from 0.
struct TracedRange
{
    std::uint64_t first = 0;
    std::uint64_t count = 3;

    bool includes(std::uint64_t number) const { return number >= first && number - first < count; }
};

/// What a line's numbers are: where it stands in its stage and in the sequence.
struct LineOrigin
{
    std::uint64_t number; ///< in its stage, from 0
    std::uint64_t item;   ///< of the sequence
    Item numbers;
};

/// A line and a surface, with the patches on its two sides.
struct Meeting
{
    Hit hit;
    Vec3 point;
    Passage patches;
};

Meeting meeting_at(const Scene& scene, const Line& line, const Hit& hit);

/// Throws SettingsError unless the stage has all these lines; `what` names them: "global lines".
void require_in_stage(const TracedRange& range, std::uint64_t lines, const char* what);

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
struct GlobalTrace
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
GlobalTrace trace_global_pass(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// Some lines of the first direction of transillumination, with what the run does before.
struct BundleTrace
{
    std::uint64_t shot_lines = 0;    ///< rays of the first shot
    std::uint64_t rays = 0;          ///< of the first estimate
    std::uint64_t directions = 0;    ///< of the first iteration
    std::uint64_t lines_to_meet = 0; ///< per direction, that meet the scene's box (N1)
    std::uint64_t lines_cast = 0;    ///< along this direction
    Vec3 direction;                  ///< unit vector
    double section = 0.0;            ///< [m^2] for which each line stands
    std::vector<GlobalLine> lines;   ///< whose transfers are forecasts: nothing is held
};

/// Tells lines of the first direction of the first iteration (P1). Throws SettingsError for lines that it does not
/// have, and what solve throws.
BundleTrace trace_bundle(const Scene& scene, const SolveOptions& options, const TracedRange& range);

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
struct ShotTrace
{
    std::vector<ShotPass> shot_passes; ///< all of the run
    std::size_t pass = 0;              ///< the one told, from 0
    double threshold = 0.0;            ///< [W/m^2] (4)
    std::size_t shooters = 0;          ///< patches that send rays in the pass
    std::vector<ShotRay> rays;
};

/// Follows the rays of a pass (from 0) up to the last one of the range and tells those in it. Throws SettingsError for
/// a pass or rays that the run does not have, and what solve throws.
ShotTrace trace_shot_pass(const Scene& scene, const SolveOptions& options, std::size_t pass, const TracedRange& range);

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
struct ParticleTrace
{
    std::uint64_t particles_in_all = 0;
    std::size_t sources = 0; ///< patches that emit
    std::vector<ToldParticle> particles;
};

/// Follows the particles of the range, each from its source to its end. Throws SettingsError for particles that
/// the run does not have, and what solve throws.
ParticleTrace trace_particles(const Scene& scene, const SolveOptions& options, const TracedRange& range);

} // namespace multipath

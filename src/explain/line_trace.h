#pragma once

#include "radiosity/extended_first_shot.h"
#include "radiosity/family/stochastic_jacobi.h"
#include "radiosity/local_monte_carlo.h"
#include "radiosity/solve_options.h"
#include "sampling/sequence.h"
#include "transport/lines/line_segments.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// Traces: step-by-step records of what single lines of a run do, for readers who want to follow the method. They are
// made with the functions that the solver itself calls, in its order and with its items, so they show what really
// happens.

namespace multipath {

/// The lines of a stage to be traced, numbered from 0: first ... first + count - 1.
struct TracedRange
{
    std::uint64_t first = 0;
    std::uint64_t count = 3;

    bool includes(std::uint64_t number) const { return number >= first && number - first < count; }
};

/// The number of a line in its stage, and the item of the sequence that makes it.
struct LineOrigin
{
    std::uint64_t number; ///< in its stage, from 0
    std::uint64_t item;   ///< index in the sequence
    Item numbers;         ///< the item itself
};

/// An intersection of a line with a surface.
struct Crossing
{
    Hit hit;
    Vec3 point;
    Passage patches; ///< on the two sides of the surface
};

/// The intersection at a hit of the line.
Crossing crossing_at(const Scene& scene, const Line& line, const Hit& hit);

/// Throws SettingsError unless all lines of the range are among the `lines` of the stage. `what` names them in the
/// message, as in "global lines".
void require_in_stage(const TracedRange& range, std::uint64_t lines, const char* what);

/// Power that a patch sends along a segment of a line (M1).
struct Transfer
{
    std::uint32_t from; ///< patch
    std::uint32_t to;   ///< patch, Segment::behind or Segment::outside
    Rgb forecast;       ///< [W] (G3)
    Rgb held;           ///< [W] by the sender before the transfer

    Rgb sent() const { return forecast + held; }
};

/// A segment of a line, between two successive intersections or before the first or after the last one, with the power
/// that is sent along it.
struct TracedSegment
{
    std::size_t after; ///< number of intersections of the line before the segment
    Segment segment;
    std::vector<Transfer> transfers; ///< two if power flows both ways (M2), both of what was held before either
    Rgb from_holds;                  ///< [W] held by segment.from afterwards; black if it is no patch
    Rgb to_holds;                    ///< [W] held by segment.to afterwards; black if it is no patch
};

/// The trace of a global line: its intersections, and what is sent along its segments.
struct GlobalLine
{
    LineOrigin origin;
    Vec3 from;
    Vec3 to;
    std::vector<Crossing> crossings;     ///< all intersections, in order
    std::vector<TracedSegment> segments; ///< the segments that touch a patch, in order
};

/// The traces of some lines of the global pass, with figures of the run up to that pass.
struct GlobalTrace
{
    std::vector<ShotPass> shot_passes;
    std::uint64_t local_lines = 0;    ///< N_l
    std::uint64_t lines_charged = 0;  ///< N_g (N1)
    std::uint64_t lines_cast = 0;     ///< N_cast (N1)
    double crossings_per_area = 0.0;  ///< [1/m^2] expected crossings by the lines cast, from either side (G1)
    std::uint64_t unshot_patches = 0; ///< number of patches with unshot power, which have a forecast (G3)
    Rgb unshot;                       ///< [W] power that the pass distributes
    std::vector<GlobalLine> lines;
};

/// Runs the global pass up to the last line of the range and traces the lines of the range. Throws SettingsError for
/// lines that the pass does not have, and what solve throws.
GlobalTrace trace_global_pass(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// The traces of some lines along the first direction of transillumination, with figures of the run up to there.
struct BundleTrace
{
    std::uint64_t shot_lines = 0;    ///< rays of the first shot
    std::uint64_t rays = 0;          ///< rays of the first estimate
    std::uint64_t directions = 0;    ///< directions of the first iteration
    std::uint64_t lines_to_meet = 0; ///< lines per direction that meet the scene's box, in expectation (N1)
    std::uint64_t lines_cast = 0;    ///< lines along this direction
    Vec3 direction;                  ///< unit vector
    double section = 0.0;            ///< [m^2] cross-section that each line represents
    std::vector<GlobalLine> lines;   ///< their transfers consist of a forecast only; no power is held
};

/// Traces lines along the first direction of the first iteration (P1). Throws SettingsError for lines that the
/// direction does not have, and what solve throws.
BundleTrace trace_bundle(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// The trace of a ray of the (extended) first shot (S1).
struct ShotRay
{
    LineOrigin origin;
    std::uint32_t shooter; ///< patch that the ray leaves
    Line ray;
    std::optional<Crossing> crossing; ///< its first intersection; empty if it leaves the scene
    std::uint32_t where;              ///< where it arrives: a patch, Segment::behind or Segment::outside
    Rgb power;                        ///< [W] that the ray carries
    Rgb unshot;                       ///< [W] of the receiving patch afterwards; black if there is none
};

/// The traces of some rays of one pass of the first shot.
struct ShotTrace
{
    std::vector<ShotPass> shot_passes; ///< all passes of the run
    std::size_t pass = 0;              ///< the pass of the rays, from 0
    double threshold = 0.0;            ///< [W/m^2] the user's, or (4)
    std::size_t shooters = 0;          ///< number of patches that send rays in the pass
    std::vector<ShotRay> rays;
};

/// Runs pass number `pass` (from 0) of the first shot up to the last ray of the range and traces the rays of the range.
/// Throws SettingsError for a pass or rays that the run does not have, and what solve throws.
ShotTrace trace_shot_pass(const Scene& scene, const SolveOptions& options, std::size_t pass, const TracedRange& range);

/// The trace of one segment of a particle's path.
struct TracedStep
{
    ParticleStep step;
    Line ray;
    std::optional<Crossing> crossing; ///< where the ray arrives; empty if it leaves the scene
    Rgb counted;                      ///< [W] that the estimator adds to the incident power of the receiving patch
};

/// The trace of a particle of local Monte Carlo from its source to its end (L1).
struct TracedParticle
{
    LineOrigin origin; ///< of its first segment
    std::vector<TracedStep> steps;
};

/// The traces of some particles of a run.
struct ParticleTrace
{
    std::uint64_t particle_count = 0; ///< total number of particles of the run
    std::size_t sources = 0;          ///< number of patches that emit
    std::vector<TracedParticle> particles;
};

/// Traces the particles of the range, each from its source to its end. Throws SettingsError for particles that the run
/// does not have, and what solve throws.
ParticleTrace trace_particles(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// The traces of some gathering random walks of the first round.
struct WalkTrace
{
    std::uint64_t walk_count = 0;      ///< total number of walks of the round
    std::vector<TracedParticle> walks; ///< from the receivers; TracedStep::counted is the irradiance [W/m^2] that the
                                       ///< step adds there, and ParticleStep::power is the weight of the walk [1]
};

/// Traces the walks of the range (W1). Throws SettingsError for walks that the round does not have, and what solve
/// throws.
WalkTrace trace_walks(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// The trace of a ray of a Jacobi iteration (J1) (J2).
struct JacobiRay
{
    LineOrigin origin;
    IterationRay carried;
    Line ray;
    std::optional<Crossing> crossing; ///< where the ray arrives; empty if it leaves the scene
};

/// The traces of some rays of the first Jacobi iteration, in the order of the patches that they leave.
struct JacobiTrace
{
    std::uint64_t series_rays = 0; ///< rays of the Neumann series before it
    std::uint64_t ray_count = 0;   ///< rays of the iteration
    std::vector<JacobiRay> rays;
};

/// Traces the rays of the range. Throws SettingsError for rays that the first iteration does not have, and what solve
/// throws.
JacobiTrace trace_iteration(const Scene& scene, const SolveOptions& options, const TracedRange& range);

} // namespace multipath

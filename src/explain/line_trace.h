#pragma once

#include "radiosity/family/stochastic_jacobi.h"
#include "radiosity/paper/extended_first_shot.h"
#include "radiosity/paper/local_monte_carlo.h"
#include "radiosity/run/solve_options.h"
#include "sampling/sequence.h"
#include "transport/lines/line_segments.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

// Traces: step-by-step records of what single lines of a run do, for readers who want to follow the method. Traces are
// made with the functions that the solver itself calls, in the same order and with the same items (points of the
// sequence, see sampling/sequence.h), so they show what really happens. Labels such as (M1) are those of
// docs/equations.md. Unshot power is power that a patch has not yet sent on. The forecast (G3) is the part of the
// unshot power that each global line leaving the patch carries.
//
// Besides the errors named below, all functions that trace throw std::invalid_argument for an unknown sequence, and
// SettingsError for a sequence with too few items. Those that run the first shot also throw SettingsError if the user
// sets the power of one ray (power_by_line) so low that the first pass alone needs more rays than the run has lines.

namespace multipath {

/// The lines (or rays, particles, walks) to trace in a stage: first ... first + count - 1, numbered from 0.
struct TracedRange
{
    std::uint64_t first = 0;
    std::uint64_t count = 3;

    bool includes(std::uint64_t number) const { return number >= first && number - first < count; }
};

/// The number of a line in its stage, and the item of the sequence from which the line is made.
struct LineOrigin
{
    std::uint64_t number; ///< index of the line in the stage, from 0
    std::uint64_t item;   ///< index of the item in the sequence
    Item numbers;         ///< the four coordinates of the item
};

/// An intersection of a line with a surface.
struct Crossing
{
    Hit hit;
    Vec3 point;      ///< position of the hit [scene units]
    Passage patches; ///< the patches on the two sides of the surface
};

/// The Crossing at a hit of the line.
Crossing crossing_at(const Scene& scene, const Line& line, const Hit& hit);

/// Throws SettingsError unless all lines of the range exist in a stage of `lines` lines. `what` is the word for the
/// lines in the message, such as "global lines".
void require_in_stage(const TracedRange& range, std::uint64_t lines, const char* what);

/// Power that a patch sends along a segment of a line: (M1) for the global pass, (P1) for transillumination.
struct Transfer
{
    std::uint32_t from; ///< index of the patch that sends
    std::uint32_t to;   ///< index of the patch that receives, or Segment::behind or Segment::outside
    Rgb forecast;       ///< [W] (G3); in transillumination all the power sent
    Rgb held;           ///< [W] held by the sender before the transfer; black in transillumination

    Rgb sent() const { return forecast + held; }
};

/// A segment of a line (between two successive intersections, before the first one or after the last one) with the
/// power that is sent along the segment.
struct TracedSegment
{
    std::size_t after; ///< number of intersections of the line before the segment
    Segment segment;
    std::vector<Transfer> transfers; ///< two if power flows both ways (M2): both senders send what they held before
    Rgb from_holds;                  ///< [W] held by segment.from afterwards; black if no patch or in transillumination
    Rgb to_holds;                    ///< [W] held by segment.to afterwards; black if no patch or in transillumination
};

/// The trace of a global line, or of a line of transillumination: the intersections, and the power sent along the
/// segments.
struct GlobalLine
{
    LineOrigin origin;
    Vec3 from;                           ///< start of the line, before the scene [scene units]
    Vec3 to;                             ///< end of the line, after the scene
    std::vector<Crossing> crossings;     ///< all intersections, in order along the line
    std::vector<TracedSegment> segments; ///< the segments with a patch at one end or both, in order along the line
};

/// The traces of some lines of the global pass, with figures of the run up to that pass.
struct GlobalTrace
{
    std::vector<ShotPass> shot_passes; ///< the passes of the first shot; none for methods without one
    std::uint64_t local_lines = 0;     ///< N_l, number of rays of the first shot
    std::uint64_t lines_charged = 0;   ///< N_g (N1), number of lines that meet the scene's box, in expectation
    std::uint64_t lines_cast = 0;      ///< N_cast (N1), number of lines cast
    double crossings_per_area = 0.0;   ///< [1/m^2] expected crossings per area of a patch, from either side (G1)
    std::uint64_t unshot_patches = 0;  ///< number of patches with unshot power before the pass, which have a forecast
    Rgb unshot;                        ///< [W] unshot power of all patches before the pass, which the pass distributes
    std::vector<GlobalLine> lines;
};

/// Runs the first shot, and the global pass up to the last line of the range, and traces the lines of the range. Throws
/// SettingsError for lines that the pass does not have.
GlobalTrace trace_global_pass(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// The traces of some lines along the first direction of transillumination (a method that casts bundles of parallel
/// lines), with figures of the run up to that direction.
struct BundleTrace
{
    std::uint64_t shot_lines = 0;    ///< number of rays of the first shot
    std::uint64_t rays = 0;          ///< number of rays of the estimate before the first iteration
    std::uint64_t directions = 0;    ///< number of directions of the first iteration
    std::uint64_t lines_to_meet = 0; ///< number of lines per direction that meet the scene's box, in expectation (N1)
    std::uint64_t lines_cast = 0;    ///< number of lines cast along the first direction
    Vec3 direction;                  ///< the first direction, a unit vector
    double section = 0.0;            ///< [m^2] cross-section that each line represents
    std::vector<GlobalLine> lines;   ///< the lines of the range, all made from the same item
};

/// Traces lines along the first direction of the first iteration (P1). Throws SettingsError for lines that the
/// direction does not have, or if the run has too few lines for a direction.
BundleTrace trace_bundle(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// The trace of a ray of the (extended) first shot (S1).
struct ShotRay
{
    LineOrigin origin;
    std::uint32_t shooter; ///< index of the patch that the ray leaves
    Line ray;
    std::optional<Crossing> crossing; ///< first intersection of the ray; empty if the ray leaves the scene
    std::uint32_t where;              ///< index of the patch where the ray arrives, Segment::behind or Segment::outside
    Rgb power;                        ///< [W] power that the ray carries
    Rgb unshot;                       ///< [W] unshot power of the receiving patch afterwards; black if there is none
};

/// The traces of some rays of one pass of the first shot.
struct ShotTrace
{
    std::vector<ShotPass> shot_passes; ///< all passes of the run
    std::size_t pass = 0;              ///< index of the pass to which the rays belong, from 0
    /// [W/m^2] Unshot radiosity above which patches shoot: set by the user, otherwise (4) in docs/equations.md.
    double threshold = 0.0;
    std::size_t shooters = 0; ///< number of patches that send rays in the pass
    std::vector<ShotRay> rays;
};

/// Runs the whole first shot. Then repeats the pass with index `pass` (the first pass is 0), as far as the last ray of
/// the range, and traces the rays of the range. Throws SettingsError for a pass or rays that the run does not have.
ShotTrace trace_shot_pass(const Scene& scene, const SolveOptions& options, std::size_t pass, const TracedRange& range);

/// The trace of one segment of a particle's path.
struct TracedStep
{
    ParticleStep step;
    Line ray;
    std::optional<Crossing> crossing; ///< where the ray arrives; empty if the ray leaves the scene
    Rgb counted; ///< [W] added by the estimator to the incident power of the receiving patch; black
                 ///< if there is none. For walks see WalkTrace
};

/// The trace of a particle of local Monte Carlo (L1) from its source to its end, or of a gathering random walk (W1).
struct TracedParticle
{
    LineOrigin origin; ///< number of the particle; item of its first segment
    std::vector<TracedStep> steps;
};

/// The traces of some particles of a run.
struct ParticleTrace
{
    std::uint64_t particle_count = 0; ///< total number of particles of the run
    std::size_t sources = 0;          ///< number of emitting patches that particles start from
    std::vector<TracedParticle> particles;
};

/// Traces the particles of the range, each from its source to its end. Throws SettingsError for particles that the run
/// does not have.
ParticleTrace trace_particles(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// The traces of some gathering random walks of the first round. A walk starts at a patch, the receiver, and gathers
/// the light for this patch.
struct WalkTrace
{
    std::uint64_t walk_count = 0;      ///< total number of walks of the round
    std::vector<TracedParticle> walks; ///< the walks of the range. Here TracedStep::counted is the irradiance [W/m^2]
                                       ///< that the step adds at the receiver, and ParticleStep::power the weight [1]
                                       ///< of the walk
};

/// Traces the walks of the range (W1). Throws SettingsError for walks that the round does not have.
WalkTrace trace_walks(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// The trace of a ray of a stochastic Jacobi iteration (J1) (J2).
struct JacobiRay
{
    LineOrigin origin;
    IterationRay carried; ///< the patches at the ends of the ray and the power that it carries
    Line ray;
    std::optional<Crossing> crossing; ///< where the ray arrives; empty if the ray leaves the scene
};

/// The traces of some rays of the first Jacobi iteration, in the order of the patches that they leave.
struct JacobiTrace
{
    std::uint64_t series_rays = 0; ///< number of rays of the Neumann series (see send_series) before the iteration
    std::uint64_t ray_count = 0;   ///< total number of rays of the iteration
    std::vector<JacobiRay> rays;
};

/// Traces the rays of the range. Throws SettingsError for rays that the first iteration does not have, or if the run
/// has too few lines for an iteration.
JacobiTrace trace_iteration(const Scene& scene, const SolveOptions& options, const TracedRange& range);

} // namespace multipath

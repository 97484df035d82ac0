#pragma once

#include "parallel/run_control.h"
#include "radiosity/family/importance.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"

#include <cstdint>
#include <vector>

// Stochastic Jacobi iterations (Neumann: Monte Carlo radiosity, Computing 55, 1995). For the powers P that the patches
// send, the radiosity system is P = U + rho T P, where U is the power of the sources and T P the power that each patch
// receives. It is solved by iterating P <- U + rho T P, with a new estimate of T P in every iteration. The result is
// the mean of the iterations.

namespace multipath {

/// T P, the power [W] that the patches receive when each sends a given power once, or an estimate of it.
struct TransportEstimate
{
    std::vector<Rgb> incident; ///< per patch
    Rgb escaped;
    Rgb behind; ///< arrived at a surface on a side that has no patch

    static TransportEstimate none(const Scene& scene) { return {std::vector<Rgb>(scene.patch_count()), {}, {}}; }

    /// Adds power that arrives at `where`: a patch, Segment::behind or Segment::outside.
    void deposit(std::uint32_t where, Rgb power);

    void visit(Archive& archive); ///< for a checkpoint
};

/// Running mean of the iterations.
class JacobiIterations
{
public:
    /// The sources U are the unshot power of `start`. `first`: the state after an estimate of all light that they
    /// bring; it counts as much as an iteration with `lines` lines. Both `scene` and `start` must outlive this object.
    JacobiIterations(const Scene& scene, const PowerState& start, const PowerState& first, double lines);

    /// [W] Power that each patch sends, by the mean so far.
    std::vector<Rgb> power() const;

    /// Number of lines for the next iteration, if `left` remain: as many as all before it together, so that neither the
    /// first iterations, which are inaccurate, nor the last one dominate. The last iteration takes all lines that are
    /// left.
    std::uint64_t next_lines(std::uint64_t left) const;

    /// Adds an iteration: `transfer` is the power that the patches receive when they send power().
    void add(const TransportEstimate& transfer, double lines);

    /// The start state plus the mean of all light from its unshot power, with a closed balance (settle_losses).
    PowerState finish() const;

    void visit(Archive& archive); ///< for a checkpoint

private:
    const Scene& scene_;
    const PowerState& start_;
    TransportEstimate mean_;
    double lines_;
};

struct SeriesOptions
{
    std::uint64_t first_item = 0; ///< of the sequence; one item per ray
    std::uint64_t lines = 0;      ///< approximate number to use
    std::uint64_t most_lines = 0; ///< upper limit, at which the remaining light stays unshot
    bool bidirectional = true;    ///< a ray also carries the power of the patch at its other end
    std::uint64_t seed = 0;       ///< of the rounding to whole rays
};

struct JacobiOptions
{
    std::uint64_t first_item = 0;   ///< of the sequence; one item per ray
    std::uint64_t lines_before = 0; ///< number used for the initial state
    std::uint64_t lines = 0;        ///< number to use
    bool bidirectional = true;
    std::uint64_t seed = 0;
    /// If set, up to a 32nd of the lines, at most 16 rays per patch, estimate the noise factors first; null: all
    /// patches are equally important.
    const Importance* importance = nullptr;
};

/// The Neumann series: an estimate of all light. In each pass, every patch sends its unshot power by rays in proportion
/// to it (J1) (J2), and what it reflects of the received power becomes its unshot power, until none is left. Returns
/// the number of rays cast. If the run is stopped, the unfinished pass has no effect. The caller must save `state` in
/// the checkpoint; this function saves the rest.
std::uint64_t send_series(const Scene& scene, const Sequence& sequence, const SeriesOptions& options,
                          const RunControl& run, PowerState& state);

/// The series before the iterations of a run with so many lines, for which it uses about a sixteenth of them.
SeriesOptions series_before_iterations(std::uint64_t first_item, std::uint64_t lines, bool bidirectional,
                                       std::uint64_t seed);

/// Iterations in which every patch sends all its power, by rays in proportion to it (J1) (J2). `state` holds an
/// estimate of all light, which must not be too poor: an error that all patches share decreases only by the factor rho
/// per iteration. Returns the number of rays cast, fewer if the run is stopped: an unfinished iteration has no effect.
/// The caller must save `state` in the checkpoint; this function saves the rest.
std::uint64_t iterate_by_rays(const Scene& scene, const Sequence& sequence, const JacobiOptions& options,
                              const RunControl& run, PowerState& state);

/// A ray of an iteration, and the power that it carries (J1) (J2).
struct IterationRay
{
    std::uint64_t item;  ///< of the sequence
    std::uint32_t from;  ///< patch that it leaves
    std::uint32_t to;    ///< patch, Segment::behind or Segment::outside
    double from_density; ///< [1/m^2] n_i / A_i of the patch that it leaves
    double to_density;   ///< [1/m^2] the same of the patch at its other end; 0 if the ray carries power one way only
    Rgb sent;            ///< [W]
    Rgb returned;        ///< [W] sent by the patch at the other end; black if the ray carries power one way only
};

struct IterationTrace
{
    std::uint64_t ray_count = 0; ///< of the iteration
    std::vector<IterationRay> rays;
};

/// The rays first ... first + count - 1 of the first iteration, as far as there are so many. Options and `state` as in
/// iterate_by_rays.
IterationTrace trace_first_iteration(const Scene& scene, const Sequence& sequence, const JacobiOptions& options,
                                     const PowerState& state, std::uint64_t first, std::uint64_t count, int threads);

} // namespace multipath

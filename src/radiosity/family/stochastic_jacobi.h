#pragma once

#include "parallel/run_control.h"
#include "radiosity/family/importance.h"
#include "radiosity/paper/power_state.h"
#include "sampling/sequence.h"

#include <cstdint>
#include <vector>

// Stochastic Jacobi iterations (Neumann: Monte Carlo radiosity, Computing 55, 1995). For the powers P that the patches
// send, the radiosity system is P = U + rho T P, where U is the unshot power of the sources and T P the power that each
// patch receives. The system is solved by iterating P <- U + rho T P, with a new estimate of T P in every iteration.
// The result is the mean of the iterations. Labels such as (J1) are explained in docs/equations.md.

namespace multipath {

/// An estimate of T P: what becomes of the power if each patch sends a given power once. All powers are in [W].
struct TransportEstimate
{
    std::vector<Rgb> incident; ///< per patch: power that it receives
    Rgb escaped;               ///< power that leaves the scene
    Rgb behind;                ///< power that meets a surface on a side that has no patch

    /// All zero.
    static TransportEstimate none(const Scene& scene) { return {std::vector<Rgb>(scene.patch_count()), {}, {}}; }

    /// Adds power that arrives at `where`: a patch, Segment::behind or Segment::outside.
    void deposit(std::uint32_t where, Rgb power);

    void visit(Archive& archive); ///< saves the estimate to a checkpoint or restores it
};

/// Running mean of the iterations, weighted by their lines.
class JacobiIterations
{
public:
    /// The power U of the sources is the unshot power of `start`. `first` is the state after a first estimate of all
    /// light from this power. In the mean this estimate counts as an iteration with `lines` lines. Both `scene` and
    /// `start` must outlive this object.
    JacobiIterations(const Scene& scene, const PowerState& start, const PowerState& first, double lines);

    /// [W] Power that each patch sends according to the mean so far.
    std::vector<Rgb> power() const;

    /// Number of lines for the next iteration, if `left` lines remain: as many as all iterations before it together, so
    /// that neither the inaccurate first iterations nor the last one dominate. If fewer than twice as many remain, the
    /// next iteration is the last one and takes all `left` lines.
    std::uint64_t next_lines(std::uint64_t left) const;

    /// Adds an iteration: `transfer` is the power that the patches receive when they send power().
    void add(const TransportEstimate& transfer, double lines);

    /// The final state: `start` plus the mean of the received power, and no unshot power. settle_losses() closes its
    /// balance.
    PowerState finish() const;

    void visit(Archive& archive); ///< saves the mean to a checkpoint or restores it

private:
    const Scene& scene_;
    const PowerState& start_;
    TransportEstimate mean_;
    double lines_; ///< number of lines of all iterations so far
};

/// Parameters of send_series().
struct SeriesOptions
{
    std::uint64_t first_item = 0; ///< ray k takes item (point) first_item + k of the sequence
    std::uint64_t lines = 0;      ///< approximate number of rays to use
    std::uint64_t most_lines = 0; ///< maximum number of rays; light that they do not distribute stays unshot
    bool bidirectional = true;    ///< a ray also carries the power of the patch at its other end (J2)
    std::uint64_t seed = 0;       ///< seed of the random rounding to whole rays
};

/// Parameters of iterate_by_rays().
struct JacobiOptions
{
    std::uint64_t first_item = 0;   ///< ray k takes item (point) first_item + k of the sequence
    std::uint64_t lines_before = 0; ///< number of rays used for the initial state
    std::uint64_t lines = 0;        ///< number of rays to use
    bool bidirectional = true;      ///< a ray also carries the power of the patch at its other end (J2)
    std::uint64_t seed = 0;         ///< seed of the random rounding to whole rays
    /// If set, up to a 32nd of the rays, at most 16 per patch, first estimate the noise factors
    /// (Importance::noise_factors). Null: all patches are equally important.
    const Importance* importance = nullptr;
};

/// The Neumann series: an estimate of all light. In each pass, every patch sends its unshot power by rays, whose number
/// is in proportion to this power (J1) (J2). What the patch reflects of the received power is its unshot power in the
/// next pass. Ends when no power is left, or after options.most_lines rays. If the run is stopped, the unfinished pass
/// has no effect. Returns the number of rays of the finished passes. The caller must save `state` in the checkpoint;
/// this function saves the rest.
std::uint64_t send_series(const Scene& scene, const Sequence& sequence, const SeriesOptions& options,
                          const RunControl& run, PowerState& state);

/// Parameters of the series that precedes the iterations of a run with `lines` rays in total: the series uses about a
/// sixteenth of them, and at most half.
SeriesOptions series_before_iterations(std::uint64_t first_item, std::uint64_t lines, bool bidirectional,
                                       std::uint64_t seed);

/// Iterations in which every patch sends all its power, by rays in proportion to it (J1) (J2). `state` holds an
/// estimate of all light, which must not be too poor: an error that all patches share decreases only by the factor rho
/// per iteration. Replaces `state` by the mean of this estimate and the iterations (JacobiIterations). If the run is
/// stopped, an unfinished iteration has no effect. Returns the number of rays of the finished iterations and of the
/// noise factors. The caller must save `state` in the checkpoint; this function saves the rest. Throws ArchiveError if
/// the checkpoint has other important patches.
std::uint64_t iterate_by_rays(const Scene& scene, const Sequence& sequence, const JacobiOptions& options,
                              const RunControl& run, PowerState& state);

/// A ray of an iteration, and the power that it carries (J1) (J2).
struct IterationRay
{
    std::uint64_t item; ///< index of its item in the sequence
    std::uint32_t from; ///< patch that the ray leaves
    std::uint32_t to;   ///< patch that the ray meets, Segment::behind or Segment::outside
    /// [1/m^2] n_i / A_i: number of rays that leave patch `from`, or the expected number if that is below 1, over the
    /// area of the patch.
    double from_density;
    double to_density; ///< [1/m^2] the same for patch `to`; 0 if the ray carries power one way only
    Rgb sent;          ///< [W] power that `from` sends
    Rgb returned;      ///< [W] power that `to` sends; black if the ray carries power one way only
};

/// Some rays of an iteration.
struct IterationTrace
{
    std::uint64_t ray_count = 0;    ///< number of all rays of the iteration
    std::vector<IterationRay> rays; ///< the traced ones
};

/// Traces the rays first ... first + count - 1 of the first iteration of iterate_by_rays() with these options and this
/// `state`; fewer if the iteration has fewer.
IterationTrace trace_first_iteration(const Scene& scene, const Sequence& sequence, const JacobiOptions& options,
                                     const PowerState& state, std::uint64_t first, std::uint64_t count, int threads);

} // namespace multipath

#pragma once

#include "radiosity/paper/power_state.h"
#include "radiosity/run/run.h"

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

/// The Neumann series: an estimate of all light. In each pass, every patch sends its unshot power by rays, whose number
/// is in proportion to this power (J1) (J2). What the patch reflects of the received power is its unshot power in the
/// next pass. Uses about `lines` rays. Ends when no power is left, or after `most_lines` rays; light that they do not
/// distribute stays unshot. `bidirectional`: a ray also carries the power of the patch at its other end (J2). If the
/// run is stopped, the unfinished pass has no effect. Returns the number of rays of the finished passes, which the
/// caller must record.
std::uint64_t send_series(Run& run, std::uint64_t lines, std::uint64_t most_lines, bool bidirectional);

/// The series before the iterations, with about a sixteenth of the lines of the run, at most half. A Stage.
void ray_series(Run& run);

/// Iterations in which every patch sends all its power, by rays in proportion to it (J1) (J2). The state of the run is
/// an estimate of all light, which must not be too poor: an error that all patches share decreases only by the factor
/// rho per iteration. Replaces the state by the mean of this estimate and the iterations (JacobiIterations). If the run
/// is stopped, an unfinished iteration has no effect. A Stage.
void ray_iterations(Run& run);

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

/// Traces the rays first ... first + count - 1 of the first of the ray_iterations() of this run; fewer if the iteration
/// has fewer.
IterationTrace trace_first_iteration(const Run& run, std::uint64_t first, std::uint64_t count);

} // namespace multipath

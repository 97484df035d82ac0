#pragma once

#include "parallel/run_control.h"
#include "radiosity/family/importance.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"

#include <cstdint>
#include <vector>

// Stochastic Jacobi iterations (Neumann: Monte Carlo radiosity, Computing 55, 1995). The radiosity system in terms of
// the power that patches send, P = S + rho T P with the power S of the sources, is solved by P <- S + rho T P, where
// T P, what each patch receives, is estimated anew in every iteration. The mean of the iterations is the result.

namespace multipath {

/// What the patches receive when each sends a given power once: T P, or an estimate of it. All in W.
struct TransportEstimate
{
    std::vector<Rgb> incident; ///< per patch
    Rgb escaped;
    Rgb behind; ///< met a surface on a side that has no patch

    static TransportEstimate none(const Scene& scene) { return {std::vector<Rgb>(scene.patch_count()), {}, {}}; }

    /// Adds power that arrives at a patch, Segment::behind or Segment::outside.
    void deposit(std::uint32_t where, Rgb power);

    void visit(Archive& archive); ///< for a checkpoint
};

/// The mean of several iterations.
class JacobiIterations
{
public:
    /// The sources S are what `start` holds unshot. `first`: how it became after an estimate of all that they bring,
    /// which tells as much as an iteration with so many lines.
    JacobiIterations(const Scene& scene, const PowerState& start, const PowerState& first, double lines);

    /// [W] What each patch sends, by the mean so far.
    std::vector<Rgb> power() const;

    /// How many lines the next iteration should have, of those that are left: as many as all before it together, so
    /// that neither the first ones, which know little, nor the last one decide alone.
    std::uint64_t next_lines(std::uint64_t left) const;

    /// Adds an iteration: what the patches receive of power().
    void add(const TransportEstimate& transfer, double lines);

    /// The start with all that its unshot power brings, by the mean (settle_losses).
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
    std::uint64_t lines = 0;      ///< to be used, about
    std::uint64_t most_lines = 0; ///< and at most: then light stays unshot
    bool bidirectional = true;    ///< a ray also carries what the patch at its other end sends
    std::uint64_t seed = 0;       ///< of the rounding to whole rays
};

struct JacobiOptions
{
    std::uint64_t first_item = 0;   ///< of the sequence; one item per ray
    std::uint64_t lines_before = 0; ///< with which the state was made
    std::uint64_t lines = 0;        ///< to be used
    bool bidirectional = true;
    std::uint64_t seed = 0;
    /// For which up to 16 rays from each patch are cast first, a 32nd of the lines; null: all patches are equal.
    const Importance* importance = nullptr;
};

/// The Neumann series: pass after pass the patches send what they hold unshot, and hold what they reflect of what they
/// receive, by rays in proportion to it (J1) (J2), until nothing is left: an estimate of all light. Returns how many
/// rays were cast. If the run is stopped, a pass that was not finished tells nothing. A checkpoint must hold the state
/// besides what this function makes it hold.
std::uint64_t send_series(const Scene& scene, const Sequence& sequence, const SeriesOptions& options,
                          const RunControl& run, PowerState& state);

/// Iterations in which all patches send all of their power, by rays in proportion to it (J1) (J2). `state`: after an
/// estimate of all light, which must not be too poor: errors that all patches share fade by the factor rho only.
/// Returns how many rays were cast; fewer if the run is stopped: an iteration that was not finished tells nothing. A
/// checkpoint must hold the state besides what this function makes it hold.
std::uint64_t iterate_by_rays(const Scene& scene, const Sequence& sequence, const JacobiOptions& options,
                              const RunControl& run, PowerState& state);

} // namespace multipath

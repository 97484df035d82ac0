#pragma once

#include "geometry/bounds.h"
#include "geometry/line.h"
#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"

#include <cstdint>
#include <optional>

namespace multipath {

/// Parallel lines through the smallest rectangle that is perpendicular to their direction and covers the projection of
/// the scene's box.
class Bundle
{
public:
    /// item[0], item[1]: direction, uniform on the sphere; item[2], item[3]: random shift of the lattice. The number of
    /// lines is chosen so that `lines` of them meet the box in expectation over the shift; at most 8 times `lines`.
    Bundle(const Bounds& box, const Item& item, std::uint64_t lines);

    Vec3 direction() const { return direction_; }
    std::uint64_t count() const { return count_; }
    double section() const { return section_; } ///< [m^2] cross-section that each line represents

    /// Line k = 0 ... count() - 1 of a shifted rank-1 lattice: (k / n, k times the golden section).
    Line line(std::uint64_t k) const;

private:
    Vec3 direction_;
    Vec3 along_u_;
    Vec3 along_v_;
    Vec3 centre_; ///< of the rectangle, before the box along the direction
    double half_u_ = 0.0;
    double half_v_ = 0.0;
    double shift_u_;
    double shift_v_;
    std::uint64_t count_ = 0;
    double section_ = 0.0;
};

struct TransilluminationOptions
{
    std::uint64_t first_item = 0; ///< of the sequence; one item per ray, then one per direction
    std::uint64_t lines = 0;      ///< number to use; lines that miss the scene's box are not charged (N1)
    /// Parallel lines per direction, at most 1/16 of all lines. Empty: the square root of the number of lines, so that
    /// there are as many directions as lines per direction.
    std::optional<std::uint64_t> bundle;
    std::uint64_t seed = 0; ///< of the rounding to whole rays
};

/// The estimate of all light before the first iteration, by rays from the patches. Uses about an eighth of the lines,
/// at most half of them. Returns the number of rays cast.
std::uint64_t estimate_by_rays(const Scene& scene, const Sequence& sequence, const TransilluminationOptions& options,
                               const RunControl& run, PowerState& state);

/// How the lines that remain after the rays are used.
struct BundlePlan
{
    std::uint64_t bundle;     ///< lines per direction that meet the scene's box
    std::uint64_t directions; ///< number of directions in all iterations
};

BundlePlan plan_bundles(const TransilluminationOptions& options, std::uint64_t rays);

/// [W] Power that a patch of this radiosity sends along a line that represents `section` [m^2] of one of `directions`
/// directions. A direction together with its opposite stands for the solid angle 2 pi / D, and per projected area a
/// patch sends B / pi: 2 section B / D (P1).
Rgb power_along_line(Rgb radiosity, double section, std::uint64_t directions);

/// Transillumination (Szirmay-Kalos, Foris, Neumann, Csebfalvi 1997; with many lines, ray bundles, Szirmay-Kalos and
/// Purgathofer 1998) of the unshot power of `state`. In the iterations of stochastic_jacobi.h, T P is estimated by
/// parallel lines through the whole scene, in directions of the sequence. Along each direction all patches exchange
/// power, both ways (P1). Begins with estimate_by_rays(). Returns the number of lines used, fewer if the run is
/// stopped: an unfinished iteration has no effect. The caller must save `state` in the checkpoint; this function saves
/// the rest.
std::uint64_t iterate_by_bundles(const Scene& scene, const Sequence& sequence, const TransilluminationOptions& options,
                                 const RunControl& run, PowerState& state);

} // namespace multipath

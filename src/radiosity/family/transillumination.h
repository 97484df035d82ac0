#pragma once

#include "geometry/bounds.h"
#include "geometry/line.h"
#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"

#include <cstdint>

namespace multipath {

/// Parallel lines through the smallest rectangle across their direction that hides the scene's box.
class Bundle
{
public:
    /// item[0], item[1]: direction, uniform on the sphere; item[2], item[3]: shift of the lattice. So many lines that
    /// `lines` of them meet the box in expectation over the shift.
    Bundle(const Bounds& box, const Item& item, std::uint64_t lines);

    Vec3 direction() const { return direction_; }
    std::uint64_t count() const { return count_; }
    double section() const { return section_; } ///< [m^2] for which a line stands

    Line line(std::uint64_t k) const; ///< of a lattice: (k / n, k times the golden section), shifted

private:
    Vec3 direction_;
    Vec3 along_u_;
    Vec3 along_v_;
    Vec3 centre_; ///< of the rectangle, before the scene
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
    std::uint64_t lines = 0;      ///< to be used; those that miss the scene's box are free (N1)
    std::uint64_t bundle = 256;   ///< parallel lines of each direction; fewer if there would be less than 16 directions
    std::uint64_t seed = 0;       ///< of the rounding of rays
};

/// The estimate of all light that the unshot power brings, before the first iteration: by rays from the patches, for
/// which an eighth of the lines is used. Returns how many were cast.
std::uint64_t estimate_by_rays(const Scene& scene, const Sequence& sequence, const TransilluminationOptions& options,
                               const RunControl& run, PowerState& state);

/// The lines that are left after so many rays.
struct BundlePlan
{
    std::uint64_t bundle;     ///< lines of each direction that meet the scene's box
    std::uint64_t directions; ///< of all iterations
};

BundlePlan plan_bundles(const TransilluminationOptions& options, std::uint64_t rays);

/// [W] What a patch of this radiosity sends along a line that stands for the section [m^2] of one of so many
/// directions. A direction and its opposite are one of D in 2 pi, and per area across it a patch sends B / pi: 2
/// section B / D (P1).
Rgb power_along_line(Rgb radiosity, double section, std::uint64_t directions);

/// Transillumination (Szirmay-Kalos, Foris, Neumann, Csebfalvi 1997; with many lines, ray bundles, Szirmay-Kalos and
/// Purgathofer 1998) of what `state` holds unshot: the iterations of stochastic_jacobi.h, in which T P comes from
/// parallel lines through the whole scene, in directions of the sequence. Along each direction all patches exchange
/// what they send, both ways (P1). Begins with an estimate of all light by rays from the patches, for which an eighth
/// of the lines is used. Returns how many lines were used; fewer if the run is stopped: an iteration that was not
/// finished tells nothing. A checkpoint must hold the state besides what this function makes it hold.
std::uint64_t iterate_by_bundles(const Scene& scene, const Sequence& sequence, const TransilluminationOptions& options,
                                 const RunControl& run, PowerState& state);

} // namespace multipath

#pragma once

#include "geometry/bounds.h"
#include "geometry/line.h"
#include "radiosity/run/run.h"
#include "sampling/sequence.h"

#include <cstdint>

namespace multipath {

/// Parallel lines through a rectangle that is perpendicular to their direction and covers the projection of a box, such
/// as the bounding box of the scene. The rectangle is nearly the smallest possible one.
class Bundle
{
public:
    /// item[0] and item[1] choose the direction, uniform on the sphere, item[2] and item[3] a shift of the lattice of
    /// lines. The number of lines is chosen so that `lines` of them meet the box in expectation over the shift; but it
    /// is at least 1 and at most 8 times `lines`.
    Bundle(const Bounds& box, const Item& item, std::uint64_t lines);

    Vec3 direction() const { return direction_; }
    std::uint64_t count() const { return count_; }
    double section() const { return section_; } ///< [m^2] cross-section that each line represents

    /// Line k = 0 ... count() - 1. Its position on the rectangle is point k of a shifted Fibonacci lattice, in the form
    /// for any number n = count() of points: (k + 1/2) / n along one side, k times the golden section along the other,
    /// both plus the shift, modulo 1. The line begins before the box.
    Line line(std::uint64_t k) const;

private:
    Vec3 direction_;
    Vec3 along_u_;
    Vec3 along_v_;
    Vec3 centre_;         ///< centre of the rectangle, which lies before the box
    double half_u_ = 0.0; ///< [scene units] half of the sides of the rectangle
    double half_v_ = 0.0;
    double shift_u_; ///< [1] shift as a fraction of a side
    double shift_v_;
    std::uint64_t count_ = 0;
    double section_ = 0.0; ///< [m^2]
};

/// The estimate of all light before the first iteration, by rays from the patches (send_series). Uses about an eighth
/// of the planned global lines, at most half of them. Returns the number of rays cast, and adds the light to the state
/// of the run.
std::uint64_t estimate_by_rays(Run& run);

/// How the planned global lines that remain after estimate_by_rays() are used. Lines that miss the bounding box are not
/// charged (N1).
struct BundlePlan
{
    std::uint64_t bundle;     ///< lines per direction that meet the bounding box
    std::uint64_t directions; ///< number of directions of all iterations together
};

/// Divides the lines that remain into directions. `rays`: number of rays that estimate_by_rays() cast. At least 16
/// directions are planned, if there are as many lines. Lines per direction: SolveOptions::bundle, else the square root
/// of the remaining lines, so that there are about as many directions as lines per direction.
BundlePlan plan_bundles(const Run& run, std::uint64_t rays);

/// [W] Power that a patch of this radiosity B [W/m^2] sends along a line that represents `section` [m^2] of one of
/// D = `directions` directions: 2 section B / D ((P1) in docs/equations.md). Each line leaves the front of the patch in
/// one of its two senses, so D directions share the hemisphere above the patch, 2 pi / D each. Per projected area and
/// solid angle the patch sends B / pi.
Rgb power_along_line(Rgb radiosity, double section, std::uint64_t directions);

/// Transillumination (Szirmay-Kalos, Foris, Neumann, Csebfalvi 1997; with many lines per direction, ray bundles,
/// Szirmay-Kalos and Purgathofer 1998): distributes the unshot power by all remaining lines. It begins with
/// estimate_by_rays(). Iterations as in stochastic_jacobi.h follow, in which parallel lines through the whole scene
/// estimate the power T P that the patches receive. Each direction comes from an item of the sequence, after those of
/// the rays. Every two patches that are joined by a line exchange power, both ways (P1). If the run is stopped, an
/// unfinished iteration has no effect. A Stage.
void bundle_iterations(Run& run);

} // namespace multipath

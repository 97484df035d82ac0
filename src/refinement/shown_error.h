#pragma once

#include "geometry/hit.h"
#include "radiosity/run/solve.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// Error of a displayed solution against the true radiosity: a mean over the area of all sides with patches, except the
/// sky and covered parts, see is_covered(). Radiosities and squared deviations are means over the colour channels.
struct ShownError
{
    std::uint64_t points = 0;          ///< number of sample points used: neither on the sky nor covered
    double area = 0.0;                 ///< [m^2] area that these points represent
    double mean_shown = 0.0;           ///< [W/m^2] mean of the displayed radiosity
    double mean_true = 0.0;            ///< [W/m^2] mean of the true radiosity
    double relative_mean_square = 0.0; ///< [1] mean of (shown - true)^2, divided by mean_true^2
    double standard_error = 0.0;       ///< [1] standard error of relative_mean_square

    /// [1] Square root of the relative mean square; 0 if noise makes the estimated mean square negative.
    double root() const { return std::sqrt(std::max(0.0, relative_mean_square)); }

    /// [1] Upper bound of the root with (one-sided) confidence 90 %, if the mean over the points is normally
    /// distributed.
    double root_upper_bound() const
    {
        constexpr double nine_of_ten = 1.2816;
        return std::sqrt(std::max(0.0, relative_mean_square + nine_of_ten * standard_error));
    }
};

/// Two independent, unbiased estimates of the true radiosity [W/m^2] at a point, on a side that has patches.
struct TruthAtPoint
{
    Rgb one;
    Rgb other;
};

/// Estimates the true radiosity at the point `hit`, which is sample point `number` = 0, 1, ... Called from several
/// threads at once.
using Truth = std::function<TruthAtPoint(const Hit& hit, std::uint64_t number)>;

/// Compares the smooth shading of `radiosity` [W/m^2 per patch] with the truth at `points` points, except those on the
/// sky and those on which something stands or which lie inside a solid, see is_covered(). The points come from a fixed
/// Sobol' sequence: equal parts of them are distributed by area, evenly over the patches, and in proportion to the
/// power that the patches reflect according to `guide`, an approximate radiosity [W/m^2 per patch]. The product of the
/// deviations from two independent estimates has the square of the true deviation as its mean, however noisy the
/// estimates are.
ShownError shown_error(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& guide,
                       const Truth& truth, std::uint64_t points, int threads);

/// The truth from `radiosity` [W/m^2 per patch], a solution of the scene with much finer patches (`finer`), by final
/// gathering: the last reflection is computed at each point, with `rays` shadow rays and `rays` rays over the
/// hemisphere for each of the two estimates, and anew where a ray is shorter than a patch is wide (IndirectLight). The
/// scene `finer` must outlive the result.
Truth gathered_truth(const Scene& finer, const std::vector<Rgb>& radiosity, int rays, int threads);

/// Discretisation error, the part of the error that more lines do not reduce. Two independent solutions by line reuse
/// give two deviations at each point: smooth shading minus final gathering from the same solution. The noise of the
/// lines adds nothing to the mean of their product. Not included are the errors of the light that is looked up; their
/// effect is small, as a point receives light from many patches and near ones are not looked up. Uses 4096 points, then
/// 16,384, then 65,536; goes on only while `enough` [1] lies between root() and root_upper_bound(). `memory` [bytes] is
/// for solving. `progress` reports the fractions 0 ... 0.8, those of the two solutions. The result is the same for any
/// number of threads. Throws InputError if the scene has no solution.
ShownError patch_error(const Scene& scene, double enough, double memory, int threads, const ProgressCallback& progress);

} // namespace multipath

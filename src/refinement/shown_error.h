#pragma once

#include "geometry/hit.h"
#include "radiosity/solve.h"
#include "scene/rgb.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace multipath {

/// How far what a result shows is from the continuous solution, at points of all sides that can be seen.
struct ShownError
{
    std::uint64_t points = 0;          ///< that are not covered by anything
    double area = 0.0;                 ///< [m^2] that they stand for
    double mean_shown = 0.0;           ///< [W/m^2]
    double mean_true = 0.0;            ///< [W/m^2]
    double relative_mean_square = 0.0; ///< [1] mean of (shown - true)^2 over the square of the true mean
    double standard_error = 0.0;       ///< [1] of the relative mean square

    /// [1] 0 where chance makes the mean square negative.
    double root() const { return std::sqrt(std::max(0.0, relative_mean_square)); }

    /// [1] What the root stays below in nine of ten cases, as far as the mean of the points is normally distributed.
    double root_at_most() const
    {
        constexpr double nine_of_ten = 1.2816;
        return std::sqrt(std::max(0.0, relative_mean_square + nine_of_ten * standard_error));
    }
};

/// A point of a side that exists, with two independent, unbiased estimates of the true radiosity there [W/m^2].
struct TruthAtPoint
{
    Rgb one;
    Rgb other;
};

/// Radiosity [W/m^2] at a place of a scene; the `number` of the place is less than that of points.
using Truth = std::function<TruthAtPoint(const Hit& hit, std::uint64_t number)>;

/// Compares what smooth shading shows of `radiosity` [W/m^2 per patch] with the truth at about `points` points of a
/// randomised Sobol' sequence: by area, by patches, and where `guide`, about the radiosity of the patches, is bright.
/// The product of the deviations from two independent estimates has the square of the true deviation as its mean,
/// whatever their noise.
ShownError shown_error(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& guide,
                       const Truth& truth, std::uint64_t points, int threads);

/// The truth as far as a much finer solution of the same scene tells it: the last reflection is computed for each point
/// (final gathering), with `rays` to the sources and `rays` over the hemisphere for each of the two estimates. The
/// scene must outlive the result.
Truth gathered_truth(const Scene& finer, const std::vector<Rgb>& radiosity, int rays, int threads);

/// The same at the points of shown_error() for this scene and guide, computed beforehand: for many results of one
/// scene.
Truth remembered(const Scene& scene, const std::vector<Rgb>& guide, const Truth& truth, std::uint64_t points,
                 int threads);

/// The part of the error that no lines make smaller: that of the patches. Two independent solutions by line reuse are
/// each compared with light gathered from themselves; of the product of the deviations the noise of the lines has the
/// mean 0. It does not see the errors of the patches' averages, which all that a point sees makes small. So many points
/// that it is clear whether the root is below `enough` [1], as far as 65,536 tell. `memory`: [bytes] that solving may
/// take. The same for any number of threads. Throws InputError where the scene has no solution.
ShownError patch_error(const Scene& scene, double enough, double memory, int threads, const ProgressCallback& progress);

} // namespace multipath

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

/// Error of a displayed solution against the continuous one, over the points of all sides that can be seen.
struct ShownError
{
    std::uint64_t points = 0;          ///< sample points that no other surface covers
    double area = 0.0;                 ///< [m^2] represented by these points
    double mean_shown = 0.0;           ///< [W/m^2]
    double mean_true = 0.0;            ///< [W/m^2]
    double relative_mean_square = 0.0; ///< [1] mean of (shown - true)^2 over the square of the true mean
    double standard_error = 0.0;       ///< [1] of the relative mean square

    /// [1] 0 if noise makes the estimated mean square negative.
    double root() const { return std::sqrt(std::max(0.0, relative_mean_square)); }

    /// [1] Upper 90 % confidence bound of the root, if the mean over the points is normally distributed.
    double root_upper_bound() const
    {
        constexpr double nine_of_ten = 1.2816;
        return std::sqrt(std::max(0.0, relative_mean_square + nine_of_ten * standard_error));
    }
};

/// Two independent, unbiased estimates of the true radiosity [W/m^2] at a point of an existing side.
struct TruthAtPoint
{
    Rgb one;
    Rgb other;
};

/// Estimates the true radiosity at sample point `number`, which is less than the number of points.
using Truth = std::function<TruthAtPoint(const Hit& hit, std::uint64_t number)>;

/// Compares the smooth shading of `radiosity` [W/m^2 per patch] with the truth at about `points` points of a randomised
/// Sobol' sequence, which are distributed by area, by patches, and by the brightness of `guide`, an approximate
/// radiosity. The product of the deviations from two independent estimates has the square of the true deviation as its
/// mean, however noisy they are.
ShownError shown_error(const Scene& scene, const std::vector<Rgb>& radiosity, const std::vector<Rgb>& guide,
                       const Truth& truth, std::uint64_t points, int threads);

/// The truth from a much finer solution of the same scene, by final gathering: the last reflection is computed at each
/// point, with `rays` shadow rays and `rays` rays over the hemisphere for each of the two estimates. The scene must
/// outlive the result.
Truth gathered_truth(const Scene& finer, const std::vector<Rgb>& radiosity, int rays, int threads);

/// A table of the truth at the sample points of shown_error() for this scene, guide and number of points, to compare
/// many results of one scene.
Truth precomputed_truth(const Scene& scene, const std::vector<Rgb>& guide, const Truth& truth, std::uint64_t points,
                        int threads);

/// Discretisation error, the part of the error that more lines do not reduce. Two independent solutions by line reuse
/// are each compared with light gathered from themselves; in the product of the deviations the noise of the lines has
/// mean 0. Errors of the patch averages are not included; they are small, as a point gathers light from many patches.
/// Uses 4096 points or more, up to about 65,536, until it is clear whether the root is below `enough` [1]. `memory`:
/// [bytes] for solving. The result is the same for any number of threads. Throws InputError if the scene has no
/// solution.
ShownError patch_error(const Scene& scene, double enough, double memory, int threads, const ProgressCallback& progress);

} // namespace multipath

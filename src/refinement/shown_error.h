#pragma once

#include "geometry/hit.h"
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
};

/// A point of a side that exists, with two independent, unbiased estimates of the true radiosity there [W/m^2].
struct TruthAtPoint
{
    Rgb one;
    Rgb other;
};

/// Radiosity [W/m^2] at a place of a scene; `number` tells the places apart.
using Truth = std::function<TruthAtPoint(const Hit& hit, std::uint64_t number)>;

/// Compares what smooth shading shows of `radiosity` [W/m^2 per patch] with the truth at about `points` points, spread
/// evenly over the area by a randomised Sobol' sequence. The product of the deviations from two independent estimates
/// has the square of the true deviation as its mean, whatever their noise.
ShownError shown_error(const Scene& scene, const std::vector<Rgb>& radiosity, const Truth& truth, std::uint64_t points,
                       int threads);

/// The truth as far as a much finer solution of the same scene tells it: the last reflection is computed for each point
/// (final gathering), with `rays` to the sources and `rays` over the hemisphere for each of the two estimates. The
/// scene must outlive the result.
Truth gathered_truth(const Scene& finer, const std::vector<Rgb>& radiosity, int rays, int threads);

} // namespace multipath

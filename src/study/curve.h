#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// y = factor * x^exponent, the line of a log-log plot (2).
struct PowerLaw
{
    double factor = 0.0;
    double exponent = 0.0;       ///< the slope
    double exponent_error = 0.0; ///< its standard error
    int points = 0;

    double at(double x) const;
};

/// Least squares in the logarithms, all points with equal weight: a mean of squares over a scene has nearly the same
/// relative error at any number of lines. The standard error comes from the scatter about the line, so it also tells
/// when a straight line does not describe the points. Empty for less than three different x; all values must be above
/// 0.
std::optional<PowerLaw> fit_power_law(const std::vector<double>& xs, const std::vector<double>& ys);

/// Half the width of the interval that holds the true exponent with 95 %: Student's t for points - 2 degrees of freedom
/// times the standard error.
double exponent_interval(const PowerLaw& law);

/// A way to solve, at any number of lines.
struct CurveKind
{
    std::string method;     ///< as --method names it
    std::string sequence;   ///< as --sequence names it
    std::string pairing;    ///< as --pairing names it
    std::string chords;     ///< as --chords names it; empty for a method without global lines
    std::string line_order; ///< as --line-order names it; empty for a method that does not walk along them
};

bool operator==(const CurveKind& a, const CurveKind& b);

/// The mean of some executions with the same number of lines.
struct CurvePoint
{
    std::uint64_t lines = 0;     ///< asked for, N_l + N_g
    double local_lines = 0.0;    ///< N_l, mean
    double global_lines = 0.0;   ///< N_g, mean
    double mean_square = 0.0;    ///< MSE (1) [W^2/m^4], mean
    double relative = 0.0;       ///< the same over the square of the reference's mean radiosity [1]
    double relative_error = 0.0; ///< standard error of `relative` [1]; 0 with one execution
    double seconds = 0.0;        ///< [s] processor time of one execution on one thread, preparation included, mean
    bool above_reference = true; ///< is the reference's own error small beside it? Otherwise it is left out of the fit
};

/// (2): `relative` against lines, through the points above the reference.
std::optional<PowerLaw> fit(const std::vector<CurvePoint>& points);

struct Curve
{
    CurveKind kind;
    std::vector<CurvePoint> points; ///< by increasing number of lines
    std::optional<PowerLaw> law;
};

/// The result of a study.
struct Study
{
    std::vector<Curve> curves;
    int executions = 1;                              ///< of which every point is the mean
    std::optional<double> reference_relative_square; ///< [1] relative MSE of the reference, estimated by itself
};

} // namespace multipath

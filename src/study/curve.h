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

/// Least-squares fit to the logarithms. All points have equal weight, since a mean of squares over a scene has nearly
/// the same relative error at any number of lines. The standard error of the exponent is estimated from the scatter of
/// the points about the line, so it is also large if a straight line does not describe them. Nothing for fewer than
/// three different x. All values must be above 0.
std::optional<PowerLaw> fit_power_law(const std::vector<double>& xs, const std::vector<double>& ys);

/// Half the width of the 95 % confidence interval of the exponent: Student's t for points - 2 degrees of freedom times
/// the standard error.
double exponent_interval(const PowerLaw& law);

/// What the runs of a curve have in common: the method and the choice of its lines.
struct CurveKind
{
    std::string method;     ///< as --method names it
    std::string sequence;   ///< as --sequence names it
    std::string pairing;    ///< as --pairing names it
    std::string chords;     ///< as --chords names it; empty for a method without global lines
    std::string line_order; ///< as --line-order names it; empty for a method whose result does not depend on the order
};

bool operator==(const CurveKind& a, const CurveKind& b);

/// The mean of the executions with the same number of lines.
struct CurvePoint
{
    std::uint64_t lines = 0;     ///< N_l + N_g as asked for
    double local_lines = 0.0;    ///< N_l, mean
    double global_lines = 0.0;   ///< N_g, mean
    double mean_square = 0.0;    ///< MSE (1) [W^2/m^4], mean
    double relative = 0.0;       ///< the same over the square of the reference's mean radiosity [1]
    double relative_error = 0.0; ///< standard error of `relative` [1]; 0 with one execution
    double seconds = 0.0;        ///< [s] processor time of one execution on one thread, preparation included, mean
    bool above_reference = true; ///< false: the reference's own error is not small beside it; it is left out of the fit
};

/// Fits (2) to `relative` against lines, for the points above the reference.
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
    int executions = 1;                              ///< for each point
    std::optional<double> reference_relative_square; ///< [1] estimated relative MSE of the reference
};

} // namespace multipath

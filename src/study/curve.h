#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// The power law y = factor * x^exponent, a straight line in a plot with two logarithmic axes ((2) in
/// docs/equations.md).
struct PowerLaw
{
    double factor = 0.0;
    double exponent = 0.0;       ///< the slope of the line
    double exponent_error = 0.0; ///< standard error of the exponent
    int points = 0;              ///< number of points that the law was fitted to

    /// The y of the law at x > 0.
    double at(double x) const;
};

/// Fits a power law to the points (xs[k], ys[k]), by least squares of the logarithms. All points have equal weight,
/// since a mean of squares over a scene has nearly the same relative error at any number of lines. The standard error
/// of the exponent is estimated from the scatter of the points about the line, so it is also large if a straight line
/// does not describe the points. Returns nothing for fewer than three different x. All values must be above 0.
std::optional<PowerLaw> fit_power_law(const std::vector<double>& xs, const std::vector<double>& ys);

/// Half the width of the 95 % confidence interval of the exponent: the standard error times the quantile of Student's t
/// distribution for points - 2 degrees of freedom.
double exponent_interval(const PowerLaw& law);

/// How the error of N lines depends on their division (docs/method.md, section 6): a relative MSE of local / N_l +
/// global / N_g with N_l + N_g = N.
struct RatioLaw
{
    double local = 0.0;  ///< [1] relative MSE of N local lines for which the global lines are exact
    double global = 0.0; ///< [1] the same of N global lines

    /// The relative MSE at this ratio N_l / N_g > 0.
    double at(double ratio) const { return local * (1.0 + 1.0 / ratio) + global * (1.0 + ratio); }
    /// The ratio with the least error. Both parts must be above 0.
    double best() const;
};

/// What all runs of a curve have in common: the method and the choice of its lines.
struct CurveKind
{
    std::string method;     ///< as --method names it
    std::string sequence;   ///< as --sequence names it
    std::string pairing;    ///< as --pairing names it
    std::string chords;     ///< as --chords names it; empty for a method without global lines
    std::string line_order; ///< as --line-order names it; empty for a method whose result does not depend on the order
};

bool operator==(const CurveKind& a, const CurveKind& b);

/// The mean of the executions with the same number of lines. An execution is one run of the method.
struct CurvePoint
{
    std::uint64_t lines = 0;     ///< N_l + N_g that each execution was asked for
    double local_lines = 0.0;    ///< N_l, lines cast locally: mean
    double global_lines = 0.0;   ///< N_g, lines cast globally: mean
    double mean_square = 0.0;    ///< [W^2/m^4] MSE, (1) in docs/equations.md: mean
    double relative = 0.0;       ///< [1] relative MSE: MSE over the square of the reference's mean radiosity; mean
    double relative_error = 0.0; ///< [1] standard error of `relative`; 0 with one execution
    double seconds = 0.0;        ///< [s] processor time of one execution on one thread, with preparation: mean
    double setting = 0.0;  ///< [1] what the study varies beside the lines: N_l / N_g, infinite without global lines,
                           ///< or the threshold over (4)
    std::string rule = {}; ///< what chose the ratio, as --ratio names it; empty: the study
    /// The numbers of each execution; without the parts that are only for means. Empty for a curve that was read.
    std::vector<CurvePoint> executions = {};
    /// True if the fit uses this point: the error of the reference is small beside the error of the point, or unknown.
    bool above_reference = true;
};

/// Quantity on the horizontal axis of a convergence plot.
enum class Abscissa {
    lines,    ///< number of lines of an execution, local and global
    seconds,  ///< [s] processor time of an execution on one thread
    ratio,    ///< [1] N_l / N_g
    threshold ///< [1] threshold of the extended first shot over that of (4)
};

double abscissa(const CurvePoint& point, Abscissa against);

/// Fits the power law (2) to `relative` against the abscissa, for the points with above_reference at which both are
/// above 0.
std::optional<PowerLaw> fit(const std::vector<CurvePoint>& points, Abscissa against = Abscissa::lines);

/// A number with its 95 % confidence interval, which is infinite if the uncertainty is unknown.
struct Estimate
{
    double value;
    double low;
    double high;
};

/// What the executions of a study of the ratio say. They are independent of each other, but all points of one execution
/// have the same lines, divided differently. So intervals and the test come from the scatter among the executions.
struct RatioFindings
{
    /// [1] Probability, if the law holds, that a constant beside its two terms is as far from 0 as in these executions
    /// (Student's t); nothing with one execution.
    std::optional<double> probability;
    /// The law of the mean error; nothing if the probability is below 5 %, or the least error of an execution at none
    /// of the ratios. `least` and what follows from it then are those of the least measured point.
    std::optional<RatioLaw> law;
    double least = 0.0;                         ///< [1] the least relative MSE
    Estimate best = {};                         ///< its ratio; without a law, no interval
    std::map<std::string, Estimate> loss;       ///< [1] by CurvePoint::rule: its relative MSE over the least
    std::optional<Estimate> formula_over_pilot; ///< [1] relative MSE of (3) over that of the pilot, of both rules
};

/// Fits the law to each execution, with equal weight of deviations relative to the means, for the points with
/// above_reference and global lines. Estimates and intervals are means over the jackknife's pseudo-values of the
/// executions, in logarithms (Tukey 1958; Efron, The Jackknife, 1982, chapter 3), with Student's t. Nothing for fewer
/// than four points with three different ratios.
std::optional<RatioFindings> ratio_findings(const std::vector<CurvePoint>& points);

struct Curve
{
    CurveKind kind;
    std::vector<CurvePoint> points;           ///< in order of increasing numbers of lines, or of what the study varies
    std::optional<PowerLaw> law;              ///< fit(points)
    std::optional<RatioFindings> ratios = {}; ///< ratio_findings(points), if the study varies the ratio
};

/// The result of a convergence study: how the error of several methods falls with the number of lines.
struct Study
{
    std::vector<Curve> curves;
    int executions = 1;                ///< number of executions that each point is the mean of
    Abscissa varied = Abscissa::lines; ///< what differs between the points of a curve: lines, ratio or threshold
    /// [1] Estimated relative MSE of the reference; nothing if unknown.
    std::optional<double> reference_relative_square;
};

} // namespace multipath

#include "study/plotted_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath {

namespace {

double abscissa(const CurvePoint& point, Abscissa against)
{
    return against == Abscissa::lines ? static_cast<double>(point.lines) : point.seconds;
}

/// Where what a run does before its first line takes most of the time, all points have nearly the same abscissa, and a
/// slope means nothing.
constexpr double least_span_of_seconds = 4.0;

std::optional<PowerLaw> law_of(const Curve& curve, Abscissa against)
{
    if (against == Abscissa::lines)
        return curve.law;
    std::vector<double> xs;
    std::vector<double> ys;
    for (const CurvePoint& point : curve.points)
        if (point.above_reference && point.seconds > 0.0 && point.relative > 0.0) {
            xs.push_back(point.seconds);
            ys.push_back(point.relative);
        }
    const auto [shortest, longest] = std::minmax_element(xs.begin(), xs.end());
    if (xs.empty() || *longest < least_span_of_seconds * *shortest)
        return {};
    return fit_power_law(xs, ys);
}

ErrorBar error_bar(PlotPoint middle, const CurvePoint& point)
{
    const double low = point.relative - point.relative_error;
    return {middle, low > 0.0 ? std::log10(low) : -std::numeric_limits<double>::infinity(),
            std::log10(point.relative + point.relative_error)};
}

std::vector<PlotPoint> law_line(const PowerLaw& law, const std::vector<PlotPoint>& fitted)
{
    const auto [first, last] =
        std::minmax_element(fitted.begin(), fitted.end(), [](PlotPoint a, PlotPoint b) { return a.x < b.x; });
    const auto at = [&](double x) { return PlotPoint{x, std::log10(law.factor) + law.exponent * x}; };
    return {at(first->x), at(last->x)};
}

} // namespace

PlottedCurve plotted_curve(const Curve& curve, Abscissa against, std::size_t series)
{
    PlottedCurve result{svg_series_mark(series), {}, {}, {}, law_of(curve, against), {}};
    for (const CurvePoint& point : curve.points) {
        const double x = abscissa(point, against);
        if (!(x > 0.0 && point.relative > 0.0))
            continue;
        const PlotPoint place = {std::log10(x), std::log10(point.relative)};
        (point.above_reference ? result.fitted : result.others).push_back(place);
        result.bars.push_back(error_bar(place, point));
    }
    if (result.law && !result.fitted.empty())
        result.line = law_line(*result.law, result.fitted);
    return result;
}

} // namespace multipath

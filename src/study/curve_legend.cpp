#include "study/curve_legend.h"

#include "scene/utf8.h"
#include "study/number_words.h"

#include <algorithm>

namespace multipath {

namespace {

// [px]
constexpr double row_height = 19.0;
constexpr double mark_width = 26.0;
constexpr double gap = 14.0;
constexpr double character = 0.55; // width of one over the font's size, at most, on average
constexpr std::size_t most_in_one_column = 4;

/// [characters] of the longest.
double longest(const std::vector<std::string>& texts)
{
    std::size_t most = 0;
    for (const std::string& text : texts)
        most = std::max(most, column_count(text));
    return static_cast<double>(most);
}

/// [px] of a column.
struct Column
{
    double size;  ///< of the font
    double slope; ///< where the slopes begin
    double width;
};

Column column_of(const std::vector<std::string>& labels, const std::vector<std::string>& slopes, double size)
{
    const double slope = mark_width + longest(labels) * character * size + gap;
    return {size, slope, slope + longest(slopes) * character * size};
}

std::string row(const PlottedCurve& curve, SvgPoint at)
{
    const SvgPoint middle = {at.x + 0.5 * (mark_width - 6.0), at.y - 4.0};
    return (curve.law ? svg_polyline({{at.x, middle.y}, {at.x + mark_width - 6.0, middle.y}}, {curve.style.colour, 1.2})
                      : "") +
           svg_marks({middle}, curve.style, curve.fitted.empty() && !curve.others.empty());
}

} // namespace

std::string slope_text(const std::optional<PowerLaw>& law)
{
    if (!law)
        return "no slope: points too few or too close";
    const double interval = exponent_interval(*law);
    const int decimals = interval < 0.01 ? 3 : 2;
    return "slope " + fixed(law->exponent, decimals) + " ± " + fixed(interval, decimals);
}

CurveLegend curve_legend(const std::vector<PlottedCurve>& curves, const std::vector<std::string>& labels, double left,
                         double top, double width)
{
    std::vector<std::string> slopes;
    for (const PlottedCurve& curve : curves)
        slopes.push_back(slope_text(curve.law));
    const Column narrow = column_of(labels, slopes, 11.0);
    const bool two_columns = curves.size() > most_in_one_column && 2.0 * narrow.width + gap <= width;
    const Column column = two_columns ? narrow : column_of(labels, slopes, 12.0);
    const std::size_t rows = two_columns ? (curves.size() + 1) / 2 : curves.size();
    CurveLegend legend;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const SvgPoint at = {left + (k < rows ? 0.0 : 0.5 * (width + gap)),
                             top + row_height * (static_cast<double>(k % rows) + 0.7)};
        legend.text += row(curves[k], at) +
                       svg_text(at.x + mark_width, at.y, labels[k], SvgAnchor::start, column.size) +
                       svg_text(at.x + column.slope, at.y, slopes[k], SvgAnchor::start, column.size);
    }
    legend.height = row_height * static_cast<double>(rows);
    return legend;
}

} // namespace multipath

// The plot is drawn in decimal logarithms: plotted_curve() converts the points, error bars and power law of each curve,
// plot_of() chooses the ranges of the axes, and the rest writes SVG: grid, guides, curves, axes, legend and
// notes, from back to front.

#include "study/convergence_plot.h"

#include "base/elementary.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "export/svg/svg_plot.h"
#include "study/study_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace multipath {

namespace {

// [px]
constexpr double plot_drawing_width = 640.0;
constexpr double plot_left = 70.0;
constexpr double plot_top = 42.0;
constexpr double plot_width = 552.0;
constexpr double plot_height = 400.0;
constexpr double legend_left = 44.0;
constexpr double legend_top = plot_top + plot_height + 46.0;
constexpr double row_height = 19.0; ///< of the legend
constexpr double sample_width = 20.0;
constexpr double note_height = 16.0;
constexpr double character_width = 6.6; ///< upper bound of the mean in a font of 12 px

constexpr const char* line_grey = "#808080";
constexpr const char* label_grey = "#555555";

struct Extent
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    bool empty() const { return !(low <= high); }
};

/// A point with one standard error to either side; coordinates are decimal logarithms.
struct PlottedPoint
{
    PlotPoint middle;
    double low; ///< minus infinity if the error reaches down to 0
    double high;
    bool filled; ///< the mark is; otherwise it is hollow
};

/// The drawn parts of a curve; coordinates are decimal logarithms.
struct PlottedCurve
{
    MarkStyle style;
    std::vector<PlottedPoint> points;
    std::vector<PlotPoint> line; ///< the law over the range of the fitted points; empty without a law
    std::string words;           ///< on the law, in the legend
};

/// True of a plot against what makes the error fall.
bool shows_power_laws(Abscissa against)
{
    return against == Abscissa::lines || against == Abscissa::seconds;
}

/// Points of the line of a law, as decimal logarithms.
template <class Law>
std::vector<PlotPoint> line_of(const Law& law, Extent across, int pieces)
{
    return serial_list(pieces + 1, [&](int k) -> PlotPoint {
        const double x = across.low + (across.high - across.low) * k / pieces;
        return {x, elementary::log10(law.at(elementary::pow(10.0, x)))};
    });
}

/// A curve in logarithmic coordinates. Points whose error or abscissa is not above 0 are left out.
PlottedCurve plotted_curve(const Curve& curve, Abscissa against, std::size_t series)
{
    PlottedCurve result{svg_series_mark(series), {}, {}, ""};
    Extent fitted; // across
    for (const CurvePoint& point : curve.points) {
        const double x = abscissa(point, against);
        if (!(x > 0.0 && point.relative > 0.0) || !std::isfinite(x))
            continue;
        const double low = point.relative - point.relative_error;
        result.points.push_back({{elementary::log10(x), elementary::log10(point.relative)},
                                 low > 0.0 ? elementary::log10(low) : -std::numeric_limits<double>::infinity(),
                                 elementary::log10(point.relative + point.relative_error),
                                 point.above_reference && point.rule.empty()});
        if (point.above_reference)
            fitted.include(elementary::log10(x));
    }
    if (shows_power_laws(against)) {
        const std::optional<PowerLaw> law = against == Abscissa::lines ? curve.law : fit(curve.points, against);
        result.words = law ? "slope " + slope_words(law) : "no slope";
        if (law && !fitted.empty())
            result.line = line_of(*law, fitted, 1);
    } else if (curve.ratios) {
        result.words = "least at " + interval_words(curve.ratios->best);
        if (curve.ratios->law)
            result.line = line_of(*curve.ratios->law, fitted, 64);
    }
    return result;
}

/// The ranges of the points with their error bars.
struct Ranges
{
    Extent across;
    Extent up;
};

Ranges ranges_of(const std::vector<PlottedCurve>& curves)
{
    Ranges ranges;
    for (const PlottedCurve& curve : curves)
        for (const PlottedPoint& point : curve.points) {
            ranges.across.include(point.middle.x);
            ranges.up.include(point.middle.y);
            ranges.up.include(point.high);
        }
    return ranges;
}

/// The guides, two thin lines: down to the right with the slope -1 (random lines), back to their common left end, and
/// down with the slope -1.25 (the best of stratified sampling in four dimensions). The left end is so high that the
/// steeper one passes above all points of a curve of slope -1.
std::vector<PlotPoint> guides_of(const Ranges& ranges)
{
    if (ranges.up.empty())
        return {};
    constexpr double room = 0.2; // [decades] above the points
    const double width = ranges.across.high - ranges.across.low;
    const double top = ranges.up.high + 0.25 * width + room;
    return {{ranges.across.high, top - width}, {ranges.across.low, top}, {ranges.across.high, top - 1.25 * width}};
}

Plot plot_of(const std::vector<PlottedCurve>& curves, const std::vector<PlotPoint>& guides, Ranges ranges,
             Abscissa against)
{
    Extent& up = ranges.up;
    for (const PlotPoint end : guides)
        up.include(end.y);
    for (const PlottedCurve& curve : curves)
        for (const PlotPoint end : curve.line)
            up.include(end.y);
    constexpr std::array<const char*, 4> names = {"lines", "processor time on one thread [s]",
                                                  "local lines per global line",
                                                  "threshold over that of the paper (4)"};
    const char* name = names[static_cast<std::size_t>(against)];
    return {plot_left,
            plot_top,
            plot_width,
            plot_height,
            "",
            log_axis(name, ranges.across.low, ranges.across.high),
            log_axis("relative mean square error", up.low, up.high),
            51.0};
}

std::vector<SvgPoint> at(const Plot& plot, const std::vector<PlotPoint>& points)
{
    return mapped(points, [&](PlotPoint point) { return plot.at(point); });
}

/// Positions of the filled marks, or of the hollow ones.
std::vector<SvgPoint> positions(const Plot& plot, const PlottedCurve& curve, bool filled)
{
    std::vector<SvgPoint> result;
    for (const PlottedPoint& point : curve.points)
        if (point.filled == filled)
            result.push_back(plot.at(point.middle));
    return result;
}

/// The error bars, cut off at the frame.
std::vector<VerticalBar> error_bars(const Plot& plot, const PlottedCurve& curve)
{
    return mapped(curve.points, [&](const PlottedPoint& bar) -> VerticalBar {
        const double top = plot.at({bar.middle.x, bar.high}).y;
        const double bottom = std::min(plot.at({bar.middle.x, bar.low}).y, plot.top + plot.height);
        return {plot.at(bar.middle).x, top, bottom};
    });
}

/// Draws the curves, all marks on top of all lines. A dotted line joins the points of a curve without a law.
std::string curves_text(const Plot& plot, const std::vector<PlottedCurve>& curves)
{
    std::string lines;
    std::string marks;
    for (const PlottedCurve& curve : curves) {
        const std::string& colour = curve.style.colour;
        const std::vector<SvgPoint> line = at(plot, curve.line);
        lines += line.empty() ? svg_polyline(positions(plot, curve, true), {colour, 1.2, "1 3"})
                              : svg_polyline(line, {colour, 1.2});
        lines += svg_bars(error_bars(plot, curve), {colour, 1.2});
        marks += svg_marks(positions(plot, curve, false), curve.style, true) +
                 svg_marks(positions(plot, curve, true), curve.style, false);
    }
    return lines + marks;
}

/// Notes that explain the symbols of the plot.
std::vector<std::string> notes_of(const Study& study)
{
    const std::string points =
        "Points: means of executions (" + std::to_string(study.executions) + "); bars: their standard errors.";
    if (study.varied == Abscissa::ratio)
        return {points, "Curves: a / N_l + b / N_g by least squares; least: at their lowest point (95 % interval).",
                "Hollow: at the ratio of formula (3), or of a pilot, or too near the reference's own error."};
    if (study.varied == Abscissa::threshold)
        return {points, "Hollow: too near the reference's own error."};
    return {points + " \u00b1 after a slope: 95 % interval.",
            "Hollow: the reference's own error is not small beside it; left out of the fit.",
            "No slope: the points are too few or too close. Grey: slopes \u22121 and \u22121.25."};
}

/// The legend: a row with mark, label and slope for each curve.
std::string legend_text(const std::vector<PlottedCurve>& curves, const std::vector<std::string>& labels)
{
    std::size_t longest = 0;
    for (const std::string& label : labels)
        longest = std::max(longest, column_count(label));
    const double label_x = legend_left + sample_width + 6.0;
    const double slope_x = label_x + character_width * static_cast<double>(longest) + 14.0;
    double y = legend_top + 0.7 * row_height;
    std::string text;
    for (std::size_t k = 0; k < curves.size(); ++k, y += row_height) {
        const PlottedCurve& curve = curves[k];
        const std::vector<SvgPoint> sample = {{legend_left, y - 4.0}, {legend_left + sample_width, y - 4.0}};
        text += (!curve.line.empty() ? svg_polyline(sample, {curve.style.colour, 1.2}) : "") +
                svg_marks({{legend_left + 0.5 * sample_width, y - 4.0}}, curve.style, false) +
                svg_text(label_x, y, labels[k], SvgAnchor::start) + svg_text(slope_x, y, curve.words, SvgAnchor::start);
    }
    return text;
}

} // namespace

std::string convergence_plot(const Study& study, Abscissa against, const std::string& title,
                             const std::vector<std::string>& comments)
{
    std::vector<PlottedCurve> curves;
    std::vector<std::string> labels;
    for (const Curve& curve : study.curves) {
        curves.push_back(plotted_curve(curve, against, curves.size()));
        labels.push_back(curve_label(study, curve));
    }
    const Ranges ranges = ranges_of(curves);
    const std::vector<PlotPoint> guides = shows_power_laws(against) ? guides_of(ranges) : std::vector<PlotPoint>();
    const Plot plot = plot_of(curves, guides, ranges, against);
    const std::vector<std::string> notes = notes_of(study);
    double note_y = legend_top + row_height * static_cast<double>(curves.size()) + 6.0;
    const double height = note_y + note_height * static_cast<double>(notes.size()) + 8.0;
    const double title_size = std::clamp(1.6 * plot_drawing_width / static_cast<double>(title.size() + 1), 8.0, 15.0);
    std::string text = svg_head(plot_drawing_width, height, title, comments) +
                       svg_text(0.5 * plot_drawing_width, 25.0, title, SvgAnchor::middle, title_size) + svg_grid(plot);
    text += svg_polyline(at(plot, guides), {line_grey, 1.0}) + curves_text(plot, curves) + svg_axes(plot) +
            legend_text(curves, labels);
    for (const std::string& note : notes) {
        text += svg_text(legend_left, note_y + 0.8 * note_height, note, SvgAnchor::start, 11.0, label_grey);
        note_y += note_height;
    }
    return text + svg_end();
}

} // namespace multipath

#include "study/convergence_plot.h"

#include "export/clear_place.h"
#include "export/log_axis.h"
#include "study/curve_legend.h"
#include "study/guide_lines.h"
#include "study/plotted_curve.h"
#include "study/study_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multipath {

namespace {

// [px]
constexpr double width = 640.0;
constexpr double plot_left = 70.0;
constexpr double plot_top = 42.0;
constexpr double plot_width = 552.0;
constexpr double plot_height = 400.0;
constexpr double legend_left = 44.0;
constexpr double legend_width = 578.0;
constexpr double legend_top = plot_top + plot_height + 46.0;
constexpr double note_height = 16.0;

struct Extent
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// The decimal logarithm of the reference's own error.
std::optional<double> reference_level(const Study& study)
{
    const double square = study.reference_relative_square.value_or(0.0);
    return square > 0.0 ? std::optional<double>(std::log10(square)) : std::nullopt;
}

Plot plot_of(const std::vector<PlottedCurve>& curves, std::optional<double> reference, Abscissa against)
{
    Extent across;
    Extent up;
    for (const PlottedCurve& curve : curves) {
        for (const ErrorBar& bar : curve.bars) {
            across.include(bar.middle.x);
            up.include(bar.middle.y);
            up.include(bar.high);
        }
        for (const PlotPoint end : curve.line)
            up.include(end.y);
    }
    if (reference && *reference > up.low - 1.0 && *reference < up.high + 1.0)
        up.include(*reference);
    const char* name = against == Abscissa::lines ? "lines" : "processor time on one thread [s]";
    return {plot_left,
            plot_top,
            plot_width,
            plot_height,
            "",
            log_axis(name, across.low, across.high),
            log_axis("relative mean square error", up.low, up.high),
            51.0};
}

std::vector<SvgPoint> places(const Plot& plot, const std::vector<PlotPoint>& points)
{
    std::vector<SvgPoint> result;
    for (const PlotPoint point : points)
        result.push_back(plot.at(point));
    return result;
}

/// The error bars that the marks do not hide, cut off at the frame.
std::vector<VerticalBar> visible_bars(const Plot& plot, const PlottedCurve& curve)
{
    std::vector<VerticalBar> bars;
    for (const ErrorBar& bar : curve.bars) {
        const auto [x, y] = plot.at(bar.middle);
        const double top = plot.at({bar.middle.x, bar.high}).y;
        const double bottom = std::min(plot.at({bar.middle.x, bar.low}).y, plot.top + plot.height);
        if (std::max(y - top, bottom - y) > 1.5 * mark_radius)
            bars.push_back({x, top, bottom});
    }
    return bars;
}

/// Points of all that guides and labels should keep away from.
std::vector<SvgPoint> obstacles_of(const Plot& plot, const std::vector<PlottedCurve>& curves)
{
    std::vector<SvgPoint> result;
    const auto add_line = [&](SvgPoint from, SvgPoint to) {
        const std::vector<SvgPoint> points = points_of_line(from, to, 8.0);
        result.insert(result.end(), points.begin(), points.end());
    };
    for (const PlottedCurve& curve : curves) {
        for (const ErrorBar& bar : curve.bars)
            result.push_back(plot.at(bar.middle));
        for (const VerticalBar& bar : visible_bars(plot, curve))
            add_line({bar.x, bar.top}, {bar.x, bar.bottom});
        if (!curve.line.empty())
            add_line(plot.at(curve.line.front()), plot.at(curve.line.back()));
    }
    return result;
}

/// All marks above all lines. Points without a law are joined by dots.
std::string curves_text(const Plot& plot, const std::vector<PlottedCurve>& curves)
{
    std::string lines;
    std::string marks;
    for (const PlottedCurve& curve : curves) {
        const std::string& colour = curve.style.colour;
        lines += curve.law ? svg_polyline(places(plot, curve.line), {colour, 1.2})
                           : svg_polyline(places(plot, curve.fitted), {colour, 1.2, "1 3"});
        lines += svg_bars(visible_bars(plot, curve), {colour, 1.2});
        marks += svg_marks(places(plot, curve.others), curve.style, true) +
                 svg_marks(places(plot, curve.fitted), curve.style, false);
    }
    return lines + marks;
}

/// What the signs mean that the plot holds.
std::vector<std::string> notes_of(const Study& study, const std::vector<PlottedCurve>& curves)
{
    const auto any = [&](auto holds) { return std::any_of(curves.begin(), curves.end(), holds); };
    std::string note = study.executions == 1 ? "Each point: one execution."
                                             : "Each point: mean of " + std::to_string(study.executions) +
                                                   " executions; bars: its standard error.";
    if (any([](const PlottedCurve& curve) { return curve.law.has_value(); }))
        note += " \u00b1 after a slope: 95 % interval.";
    std::vector<std::string> notes = {note};
    if (any([](const PlottedCurve& curve) { return !curve.others.empty(); }))
        notes.push_back("Hollow: the reference's own error is not small beside it; left out of the fit.");
    return notes;
}

std::string notes_text(const std::vector<std::string>& notes, double top)
{
    std::string text;
    for (std::size_t k = 0; k < notes.size(); ++k)
        text += svg_text(legend_left, top + note_height * (static_cast<double>(k) + 0.8), notes[k], SvgAnchor::start,
                         11.0, "#555555");
    return text;
}

/// Everything inside the frame.
std::string plot_text(const Plot& plot, const std::vector<PlottedCurve>& curves, std::optional<double> reference)
{
    std::vector<SvgPoint> obstacles = obstacles_of(plot, curves);
    std::string text = svg_grid(plot);
    if (reference && *reference > plot.up.low && *reference < plot.up.high) {
        const LabelledLevel level = labelled_level(plot, *reference, "error of the reference", obstacles);
        obstacles.insert(obstacles.end(), level.points.begin(), level.points.end());
        text += level.text;
    }
    return text + guide_lines(plot, obstacles) + curves_text(plot, curves);
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
    const std::optional<double> reference = reference_level(study);
    const Plot plot = plot_of(curves, reference, against);
    const CurveLegend legend = curve_legend(curves, labels, legend_left, legend_top, legend_width);
    const std::vector<std::string> notes = notes_of(study, curves);
    const double notes_top = legend_top + legend.height + 6.0;
    const double height = notes_top + note_height * static_cast<double>(notes.size()) + 8.0;
    const double title_size = std::clamp(1.6 * width / static_cast<double>(title.size() + 1), 8.0, 15.0);
    return svg_head(width, height, title, comments) +
           svg_text(0.5 * width, 25.0, title, SvgAnchor::middle, title_size) + plot_text(plot, curves, reference) +
           svg_axes(plot) + legend.text + notes_text(notes, notes_top) + svg_end();
}

} // namespace multipath

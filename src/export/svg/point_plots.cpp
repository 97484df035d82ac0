#include "export/svg/point_plots.h"

#include "base/lists.h"
#include "export/svg/svg_plot.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr std::size_t arrow_limit = 100;

// [px] around every plot, for its title, labels and axis titles.
constexpr double space_above = 34.0;
constexpr double space_below = 42.0;
constexpr double to_the_left = 54.0;
constexpr double to_the_right = 16.0;

/// Square plots in rows and columns below the drawing's title.
struct PlotGrid
{
    double side; ///< [px] of one plot
    std::size_t columns;
    std::size_t rows;

    static constexpr double heading = 30.0;

    double width() const { return static_cast<double>(columns) * (to_the_left + side + to_the_right); }
    double height() const { return heading + static_cast<double>(rows) * (space_above + side + space_below); }

    Plot cell(std::size_t column, std::size_t row, const std::string& title, const std::string& across,
              const std::string& up) const
    {
        const std::vector<PlotTick> ticks = {{0.0, "0"}, {0.5, "0.5"}, {1.0, "1"}};
        return {static_cast<double>(column) * (to_the_left + side + to_the_right) + to_the_left,
                heading + static_cast<double>(row) * (space_above + side + space_below) + space_above,
                side,
                side,
                title,
                {across, 0.0, 1.0, ticks},
                {up, 0.0, 1.0, ticks}};
    }

    /// The whole SVG document around the elements of the plots.
    std::string drawing(const std::string& title, const std::vector<std::string>& comments,
                        const std::string& elements) const
    {
        return svg_head(width(), height(), title, comments) +
               svg_text(0.5 * width(), 22.0, title, SvgAnchor::middle, 15.0) + elements + svg_end();
    }
};

std::string axis_name(int dimension)
{
    return "x" + std::to_string(dimension);
}

/// [px] A third of the mean distance of evenly distributed points, limited to sizes that are visible and not too large.
double dot_diameter(double side, std::size_t count)
{
    return std::clamp(0.33 * side / std::sqrt(static_cast<double>(count)), 0.6, 5.0);
}

/// Two dimensions of a sequence, numbered from 0: one for the horizontal axis, one for the vertical axis.
struct DimensionPair
{
    int across;
    int up;
};

/// All pairs with across < up, ordered by `up`, then by `across`: 0,1; 0,2; 1,2; ...
std::vector<DimensionPair> all_pairs(int dimensions)
{
    std::vector<DimensionPair> pairs;
    for (int up = 1; up < dimensions; ++up)
        for (int across = 0; across < up; ++across)
            pairs.push_back({across, up});
    return pairs;
}

std::vector<PlotPoint> projection(const PointSet& points, DimensionPair pair)
{
    return serial_list(points.size(), [&](std::size_t n) {
        return PlotPoint{points.at(n, pair.across), points.at(n, pair.up)};
    });
}

std::string dots_with_axes(const Plot& plot, const std::vector<PlotPoint>& points)
{
    return svg_axes(plot) + svg_dots(plot, points, svg_series_colour(0), dot_diameter(plot.width, points.size()));
}

/// Two points whose correlation is plotted.
struct Link
{
    PlotPoint from;
    PlotPoint to;
};

/// The links of one column of plots, and their labels.
struct LinkSeries
{
    std::string title;
    std::vector<Link> links;
    std::string from_name; ///< "x(n)"
    std::string to_name;   ///< "x(n + 1)"
    std::string across;    ///< name of the first coordinate
    std::string up;        ///< name of the second coordinate
};

/// The number of arrows in words: "the first 100".
std::string arrows_words(std::size_t count)
{
    return "the first " + std::to_string(std::min(count, arrow_limit));
}

std::string arrow_plot(const Plot& plot, const std::vector<Link>& links)
{
    std::string elements = svg_axes(plot);
    const std::size_t count = std::min(links.size(), arrow_limit);
    for (std::size_t n = 0; n < count; ++n) {
        const double share = static_cast<double>(n) / static_cast<double>(std::max<std::size_t>(count - 1, 1));
        elements += svg_arrow(plot, links[n].from, links[n].to, svg_ramp_colour(share));
    }
    return elements;
}

std::string lag_plot(const Plot& plot, const LinkSeries& series)
{
    const auto first = mapped(series.links, [](const Link& link) { return PlotPoint{link.from.x, link.to.x}; });
    const auto second = mapped(series.links, [](const Link& link) { return PlotPoint{link.from.y, link.to.y}; });
    const double diameter = dot_diameter(plot.width, 2 * series.links.size());
    return svg_axes(plot) + svg_dots(plot, first, svg_series_colour(0), diameter) +
           svg_dots(plot, second, svg_series_colour(1), diameter) +
           svg_legend(plot.left + 6.0, plot.top - 8.0, {series.across, series.up});
}

/// Columns of an arrow plot above a lag plot, at most four side by side. For a single series the two are side by side.
std::string link_plots(const std::vector<LinkSeries>& all, const std::string& title,
                       const std::vector<std::string>& comments)
{
    const std::size_t columns = std::min<std::size_t>(all.size(), 4);
    const PlotGrid grid =
        all.size() == 1 ? PlotGrid{380.0, 2, 1} : PlotGrid{250.0, columns, 2 * ((all.size() + columns - 1) / columns)};
    std::string elements;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const LinkSeries& series = all[i];
        const std::size_t column = i % columns;
        const std::size_t row = 2 * (i / columns);
        const Plot arrows = grid.cell(column, row, series.title, series.across, series.up);
        const Plot lags = all.size() == 1 ? grid.cell(1, 0, "", series.from_name, series.to_name)
                                          : grid.cell(column, row + 1, "", series.from_name, series.to_name);
        elements += arrow_plot(arrows, series.links) + lag_plot(lags, series);
    }
    return grid.drawing(title, comments, elements);
}

/// The two points of each of the first `count` lines.
std::vector<Link> line_ends(const std::string& sequence, std::uint64_t seed, Pairing pairing, std::uint64_t count)
{
    const std::unique_ptr<Sequence> lines = make_line_sequence(sequence, seed, pairing);
    return serial_list(count, [&](std::uint64_t n) -> Link {
        const Item item = lines->item(n);
        return {{item[0], item[1]}, {item[2], item[3]}};
    });
}

} // namespace

std::string scatter_plots(const PointSet& points, const std::string& title, const std::vector<std::string>& comments)
{
    const auto columns = static_cast<std::size_t>(points.dimensions - 1);
    const PlotGrid grid{columns == 1 ? 420.0 : columns <= 3 ? 260.0 : 190.0, columns, columns};
    std::string elements;
    for (const auto& [across, up] : all_pairs(points.dimensions))
        elements += dots_with_axes(grid.cell(static_cast<std::size_t>(across), static_cast<std::size_t>(up - 1), "",
                                             axis_name(across), axis_name(up)),
                                   projection(points, {across, up}));
    return grid.drawing(title, comments, elements);
}

std::string order_plots(const PointSet& points, const std::string& title, const std::vector<std::string>& comments)
{
    std::vector<LinkSeries> all;
    for (const DimensionPair& pair : all_pairs(points.dimensions)) {
        const std::vector<PlotPoint> projected = projection(points, pair);
        std::vector<Link> links;
        for (std::size_t n = 0; n + 1 < projected.size(); ++n)
            links.push_back({projected[n], projected[n + 1]});
        all.push_back({arrows_words(links.size()) + " steps, dark to bright", links, "point n", "point n + 1",
                       axis_name(pair.across), axis_name(pair.up)});
    }
    return link_plots(all, title, comments);
}

std::string paper_figure_1(std::uint64_t count, std::uint64_t seed, const std::vector<std::string>& comments)
{
    const PlotGrid grid{400.0, 2, 1};
    const auto panel = [&](std::size_t column, const char* title, const char* sequence) {
        return dots_with_axes(grid.cell(column, 0, title, axis_name(0), axis_name(1)),
                              projection(points_of(*make_sequence(sequence, seed, 2), 0, count), {0, 1}));
    };
    return grid.drawing("Figure 1: " + std::to_string(count) + " points of the square", comments,
                        panel(0, "(a) random", "random") +
                            panel(1, "(b) quasi-random: Halton, bases 2 and 3", "halton:2,3"));
}

std::string paper_figure_2(std::uint64_t count, std::uint64_t seed, const std::vector<std::string>& comments)
{
    const auto series = [&](const char* title, const char* sequence, Pairing pairing) {
        return LinkSeries{title, line_ends(sequence, seed, pairing, count), "first point", "second point", "x", "y"};
    };
    return link_plots({series("(a) Halton, two 2-D items a line", "halton:2,3", Pairing::two_dimensional),
                       series("(b) random", "random", Pairing::four_dimensional),
                       series("(c) Halton, one 4-D item a line", "halton:2,7,3,5", Pairing::four_dimensional),
                       series("(d) Sobol, one 4-D item a line", "sobol", Pairing::four_dimensional)},
                      "Figure 2: the two points of " + arrows_words(count) +
                          " lines (arrows, dark to bright) and of all " + std::to_string(count) + " (dots)",
                      comments);
}

} // namespace multipath

#include "study/convergence_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <doctest/doctest.h>

namespace convergence_plot_test {

using namespace multipath;

namespace {

struct Place
{
    double x;
    double y;
};

const std::string blue = "#0072b2"; // of the first curve
const std::string guide = "#808080";

/// `count` points of factor N^exponent at N = 1000, 10000, ..., with a law through them.
Curve power_curve(double factor, double exponent, int count)
{
    Curve curve;
    curve.kind.method = "first-shot";
    curve.kind.sequence = "sobol";
    curve.kind.pairing = "4d";
    std::vector<double> xs;
    std::vector<double> ys;
    for (int k = 0; k < count; ++k) {
        CurvePoint point;
        point.lines = static_cast<std::uint64_t>(std::lround(std::pow(10.0, 3 + k)));
        point.relative = factor * std::pow(static_cast<double>(point.lines), exponent);
        point.seconds = 1e-6 * static_cast<double>(point.lines);
        curve.points.push_back(point);
        xs.push_back(static_cast<double>(point.lines));
        ys.push_back(point.relative);
    }
    curve.law = fit_power_law(xs, ys);
    return curve;
}

Study study_of(const std::vector<Curve>& curves)
{
    Study study;
    study.curves = curves;
    study.executions = 4;
    return study;
}

std::string plotted(const Study& study, Abscissa against = Abscissa::lines)
{
    return convergence_plot(study, against, "title", {});
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// The shapes of all paths with these attributes right after the shape, in their order.
std::vector<std::string> paths(const std::string& svg, const std::string& attributes)
{
    std::vector<std::string> found;
    for (std::size_t at = svg.find("d=\""); at != std::string::npos; at = svg.find("d=\"", at + 1)) {
        const std::size_t end = svg.find('"', at + 3);
        if (svg.compare(end + 1, attributes.size(), attributes) == 0)
            found.push_back(svg.substr(at + 3, end - at - 3));
    }
    return found;
}

/// Where the shape's absolute moves and lines lead.
std::vector<Place> places(const std::string& shape)
{
    std::vector<Place> result;
    for (std::size_t at = 0; at < shape.size(); ++at) {
        Place place{};
        if ((shape[at] == 'M' || shape[at] == 'L') &&
            std::sscanf(shape.c_str() + at + 1, "%lf %lf", &place.x, &place.y) == 2)
            result.push_back(place);
    }
    return result;
}

std::vector<Place> filled_marks(const std::string& svg)
{
    return places(paths(svg, " fill=\"" + blue + "\"").at(0)); // the legend's mark comes later
}

std::vector<std::string> lines(const std::string& svg, const std::string& colour)
{
    return paths(svg, " fill=\"none\" stroke=\"" + colour + "\"");
}

double slope(Place from, Place to)
{
    return (to.y - from.y) / (to.x - from.x);
}

} // namespace

// Places are rounded to 0.1 px: over the 200 px and more between the ends of a guide its slope is right to 0.1 %, and
// the marks' to less.
TEST_CASE("a curve of N^-1.25 goes along the steeper guide, whose slope is 1.25 times that of the other")
{
    const std::string svg = plotted(study_of({power_curve(3.0, -1.25, 4)}));
    const std::vector<Place> marks = filled_marks(svg);
    REQUIRE(marks.size() == 4);
    const std::vector<Place> guides = places(lines(svg, guide).at(0)); // along the flatter one, back along the steeper
    REQUIRE(guides.size() == 3);
    CHECK(guides[2].x - guides[1].x > 200.0);
    CHECK(slope(marks.front(), marks.back()) == doctest::Approx(slope(guides[1], guides[2])).epsilon(2e-3));
    CHECK(slope(guides[1], guides[0]) == doctest::Approx(slope(guides[1], guides[2]) / 1.25).epsilon(2e-3));
    for (std::size_t k = 1; k < marks.size(); ++k)
        CHECK(slope(marks[k - 1], marks[k]) == doctest::Approx(slope(marks.front(), marks.back())).epsilon(2e-3));
}

TEST_CASE("the fitted line goes from the first to the last point that it describes")
{
    const std::string svg = plotted(study_of({power_curve(3.0, -1.0, 4)}));
    const std::vector<Place> line = places(lines(svg, blue).at(0));
    const std::vector<Place> marks = filled_marks(svg);
    REQUIRE(line.size() == 2);
    CHECK(line[0].x == marks.front().x);
    CHECK(line[0].y == doctest::Approx(marks.front().y).epsilon(1e-3)); // 0.1 px, from different roundings
    CHECK(line[1].x == marks.back().x);
}

TEST_CASE("points not above the reference are hollow, and the fitted line ends before them")
{
    Study study = study_of({power_curve(3.0, -1.0, 5)});
    study.curves[0].points.back().above_reference = false;
    const std::string svg = plotted(study);
    const std::vector<Place> hollow =
        places(paths(svg, " fill=\"#ffffff\" stroke=\"" + blue + "\" stroke-width=\"1.3\"").at(0));
    const std::vector<Place> filled = filled_marks(svg);
    REQUIRE(hollow.size() == 1);
    REQUIRE(filled.size() == 4);
    CHECK(hollow[0].x > filled.back().x);
    CHECK(places(lines(svg, blue).at(0)).back().x == filled.back().x);
    CHECK(contains(svg, ">Hollow: "));
}

// The scale is that of the marks: 3 decades of error between the first and the last. Rounding: 0.1 px.
TEST_CASE("an error bar ends one standard error above and below its point")
{
    Study study = study_of({power_curve(1.0, -1.0, 4)});
    study.curves[0].points[1].relative_error = 0.4 * study.curves[0].points[1].relative;
    const std::string svg = plotted(study);
    const std::vector<Place> marks = filled_marks(svg);
    const double decade = (marks.back().y - marks.front().y) / 3.0;
    double x = 0.0;
    double top = 0.0;
    double bottom = 0.0;
    const std::string bars = lines(svg, blue).at(1);
    REQUIRE(std::count(bars.begin(), bars.end(), 'V') == 4);
    REQUIRE(std::sscanf(bars.c_str() + bars.find('M', 1), "M%lf %lfV%lf", &x, &top, &bottom) == 3);
    CHECK(x == marks[1].x);
    CHECK(std::abs(top - (marks[1].y - std::log10(1.4) * decade)) < 0.15);
    CHECK(std::abs(bottom - (marks[1].y - std::log10(0.6) * decade)) < 0.15);
}

TEST_CASE("a bar that reaches down to 0 ends at the frame, and one that reaches up is inside it")
{
    Study study = study_of({power_curve(1.0, -1.0, 4)});
    study.curves[0].points[0].relative_error = 3.0 * study.curves[0].points[0].relative;
    const std::string svg = plotted(study);
    double left = 0.0;
    double frame_top = 0.0;
    double right = 0.0;
    double frame_bottom = 0.0;
    const std::string frame = paths(svg, " fill=\"none\" stroke=\"#555555\"").at(0);
    REQUIRE(std::sscanf(frame.c_str(), "M%lf %lfH%lfV%lf", &left, &frame_top, &right, &frame_bottom) == 4);
    double x = 0.0;
    double top = 0.0;
    double bottom = 0.0;
    REQUIRE(std::sscanf(lines(svg, blue).at(1).c_str(), "M%lf %lfV%lf", &x, &top, &bottom) == 3);
    CHECK(bottom == frame_bottom);
    CHECK(top > frame_top);
}

TEST_CASE("every curve has a row of the legend, with the label that tells it from the others")
{
    Study study = study_of({power_curve(3.0, -1.0, 4), power_curve(1.0, -1.2, 4)});
    study.curves[1].kind.pairing = "2d";
    const std::string svg = plotted(study);
    CHECK(contains(svg, ">first-shot, sobol, 4d<"));
    CHECK(contains(svg, ">first-shot, sobol, 2d<"));
    const std::size_t first = svg.find(">slope \u22121.000 \u00b1 0.000<");
    const std::size_t second = svg.find(">slope \u22121.200 \u00b1 0.000<");
    CHECK(first < second);
    CHECK(second != std::string::npos);
    CHECK(contains(plotted(study_of({power_curve(3.0, -1.25, 2)})), ">no slope<"));
}

TEST_CASE("a slope has the half width of its interval")
{
    Study study = study_of({power_curve(1.0, -1.0, 3)});
    const auto slope_with = [&](double exponent, double error) {
        study.curves[0].law = PowerLaw{1.0, exponent, error, 12}; // Student's t for 10 degrees of freedom is 2.228
        const std::string svg = plotted(study);
        const std::size_t begin = svg.find(">slope", svg.find(">first-shot, sobol<"));
        return svg.substr(begin + 1, svg.find('<', begin) - begin - 1);
    };
    CHECK(slope_with(-1.104, 0.01) == "slope \u22121.104 \u00b1 0.022");
    CHECK(slope_with(-1.104, 0.001) == "slope \u22121.104 \u00b1 0.002");
    CHECK(slope_with(0.25, 0.001) == "slope 0.250 \u00b1 0.002");
}

TEST_CASE("the guides lie above all points of curves of slope -1 or less")
{
    for (const double exponent : {-0.8, -1.0, -1.25, -2.0})
        for (const int count : {3, 4, 5}) {
            CAPTURE(exponent);
            CAPTURE(count);
            const std::string svg =
                plotted(study_of({power_curve(1.0, exponent, count), power_curve(0.1, exponent, count)}));
            const std::vector<Place> guides = places(lines(svg, guide).at(0));
            REQUIRE(guides.size() == 3);
            for (const Place mark : filled_marks(svg)) { // the steeper one is the lower one
                const double above = guides[1].y + slope(guides[1], guides[2]) * (mark.x - guides[1].x);
                CHECK((exponent > -1.0 || above < mark.y - 5.0));
            }
        }
}

// Seconds ~ sqrt(N), so that N^-1 is seconds^-2; the last point, far off that, is not above the reference.
TEST_CASE("against seconds the law is fitted to seconds, through the points above the reference")
{
    Study study = study_of({power_curve(1.0, -1.0, 5)});
    for (CurvePoint& point : study.curves[0].points)
        point.seconds = std::sqrt(static_cast<double>(point.lines)) / 1000.0;
    study.curves[0].points.back().relative = 1.0;
    study.curves[0].points.back().above_reference = false;
    const std::string against_seconds = plotted(study, Abscissa::seconds);
    CHECK(contains(against_seconds, ">slope \u22122.000 \u00b1 0.000<"));
    CHECK(contains(against_seconds, "[s]<"));
    CHECK(contains(plotted(study), ">slope \u22121.000 \u00b1 0.000<"));
    CHECK(contains(plotted(study), ">lines<"));
}

TEST_CASE("everything stays inside the drawing")
{
    for (const int count : {1, 2, 6, 12}) {
        Study study;
        for (int k = 0; k < count; ++k)
            study.curves.push_back(power_curve(100.0 * std::pow(0.4, k), -1.0 - 0.02 * k, 5));
        const std::string svg = plotted(study);
        double width = 0.0;
        double height = 0.0;
        REQUIRE(std::sscanf(svg.c_str() + svg.find("viewBox"), "viewBox=\"0 0 %lf %lf\"", &width, &height) == 2);
        CHECK(width == 640.0);
        std::vector<Place> all = places(svg);
        for (std::size_t at = svg.find(" x=\""); at != std::string::npos; at = svg.find(" x=\"", at + 1)) {
            Place place{};
            REQUIRE(std::sscanf(svg.c_str() + at, " x=\"%lf\" y=\"%lf\"", &place.x, &place.y) == 2);
            all.push_back(place);
        }
        CHECK(all.size() > static_cast<std::size_t>(6 * count));
        for (const Place& place : all)
            CHECK((place.x > 0.0 && place.x < width && place.y > 0.0 && place.y < height));
    }
}

TEST_CASE("titles, comments and names are escaped")
{
    Study study = study_of({power_curve(1.0, -1.0, 3)});
    study.curves[0].kind.sequence = "a<b&c";
    const std::string svg = convergence_plot(study, Abscissa::lines, "1 < 2", {"this & that"});
    CHECK(contains(svg, "<title>1 &lt; 2</title>"));
    CHECK(contains(svg, ">1 &lt; 2</text>"));
    CHECK(contains(svg, "<desc>this &amp; that\n</desc>"));
    CHECK(contains(svg, ">first-shot, a&lt;b&amp;c</text>"));
    CHECK_FALSE(contains(svg, "a<b"));
}

TEST_CASE("points without a place on logarithmic axes are left out, also if none is left")
{
    Study study = study_of({power_curve(1.0, -1.0, 4)});
    study.curves[0].points[1].relative = 0.0;
    study.curves[0].points[2].seconds = 0.0;
    CHECK(filled_marks(plotted(study)).size() == 3);
    CHECK(filled_marks(plotted(study, Abscissa::seconds)).size() == 2);
    for (CurvePoint& point : study.curves[0].points)
        point.relative = 0.0;
    for (const std::string& svg : {plotted(study), plotted(study, Abscissa::seconds), plotted({})}) {
        CHECK_FALSE(contains(svg, "nan"));
        CHECK_FALSE(contains(svg, "inf"));
        CHECK(contains(svg, "</svg>"));
    }
}

} // namespace convergence_plot_test

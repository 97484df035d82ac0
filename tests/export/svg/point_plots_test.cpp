#include "export/svg/point_plots.h"

#include <doctest/doctest.h>
#include <sstream>

namespace point_plots_test {

using namespace multipath;

namespace {

std::size_t occurrences(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
        ++count;
    return count;
}

/// Is every element closed in the order of nesting, is there one root, and is no `<`, quote or `&` left open?
bool is_well_formed(const std::string& xml)
{
    std::vector<std::string> open;
    std::size_t roots = 0;
    for (std::size_t at = 0; at < xml.size();) {
        if (xml[at] != '<') {
            if (xml[at] == '>' || (open.empty() && xml[at] != '\n'))
                return false;
            if (xml[at] == '&' && xml.find(';', at) > at + 5)
                return false;
            ++at;
            continue;
        }
        const std::size_t end = xml.find('>', at);
        if (end == std::string::npos)
            return false;
        const std::string tag = xml.substr(at + 1, end - at - 1);
        const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
        if (tag.find('<') != std::string::npos || occurrences(tag, "\"") % 2 != 0)
            return false;
        if (tag[0] == '/') {
            if (open.empty() || "/" + open.back() != tag)
                return false;
            open.pop_back();
        } else if (tag.back() != '/') {
            roots += open.empty() ? 1 : 0;
            open.push_back(name);
        }
        at = end + 1;
    }
    return open.empty() && roots == 1;
}

PointSet sample(const char* name, int dimensions, std::uint64_t count)
{
    return points_of(*make_sequence(name, 1, dimensions), 0, count);
}

// Every dot is a piece of path of length 0; nothing else is.
constexpr const char* dot = "h0";
constexpr const char* arrow = "stroke-width=\"0.9\"";

} // namespace

TEST_CASE("the checker itself refuses what is not well formed")
{
    CHECK(is_well_formed("<a b=\"1\"><c/>x &lt; y</a>\n"));
    for (const char* text :
         {"<a>", "</a>", "<a><b></a></b>", "<a/>x", "<a></a><a></a>", "<a b=\"1></a>", "<a>1 > 0</a>"})
        CHECK_MESSAGE(!is_well_formed(text), text);
}

TEST_CASE("a scatter plot has one dot per point and pair of dimensions")
{
    const std::string one = scatter_plots(sample("sobol", 2, 1000), "one", {});
    CHECK(occurrences(one, dot) == 1000);
    const std::string matrix = scatter_plots(sample("sobol", 4, 1000), "matrix", {"command: a --b <c> & \"d\""});
    CHECK(occurrences(matrix, dot) == 6000);
    for (const char* title : {">x0</text>", ">x3</text>"}) // a column of three plots, a row of three
        CHECK(occurrences(matrix, title) == 3);
    CHECK(is_well_formed(one));
    CHECK(is_well_formed(matrix));
}

TEST_CASE("a thousand points in every pair of six dimensions stay below 300 kB")
{
    CHECK(scatter_plots(sample("random", 6, 1000), "six", {}).size() < 300000);
}

// n points have n - 1 steps; each step is one dot per coordinate below, and an arrow if it is among the first hundred.
TEST_CASE("the order of points has an arrow for each of the first hundred steps and two dots for every step")
{
    const std::string many = order_plots(sample("halton", 2, 500), "many", {});
    CHECK(occurrences(many, arrow) == 100);
    CHECK(occurrences(many, dot) == 2 * 499);
    const std::string few = order_plots(sample("halton", 3, 5), "few", {});
    CHECK(occurrences(few, arrow) == 3 * 4);
    CHECK(occurrences(few, dot) == 3 * 2 * 4);
    CHECK(is_well_formed(many));
    CHECK(is_well_formed(few));
}

TEST_CASE("the paper's figures hold the points they promise")
{
    const std::string first = paper_figure_1(1000, 1, {});
    const std::string second = paper_figure_2(1000, 1, {});
    CHECK(occurrences(first, dot) == 2 * 1000);
    CHECK(occurrences(second, dot) == 4 * 2 * 1000);
    CHECK(occurrences(second, arrow) == 4 * 100);
    for (const char* title : {">(a)", ">(b)", ">(c)", ">(d)"})
        CHECK_MESSAGE(occurrences(second, title + std::string(" ")) == 1, title);
    for (const std::string& figure : {first, second}) {
        CHECK(is_well_formed(figure));
        CHECK(figure.size() < 300000);
    }
}

// The radical inverse in base 2 of an odd number is that of the even number before it plus 1/2. Points 2n and 2n + 1
// make line n, so that in the first panel all dots of the first colour lie half the plot's height above its diagonal.
// The plot is 250 px wide and high; lengths are rounded to 0.1, each by 0.05 at most, as are the plot's corners.
TEST_CASE("in the paper's failing arrangement the dots of the first coordinate fall on one line")
{
    const std::string figure = paper_figure_2(1000, 1, {});
    std::istringstream path(figure.substr(figure.rfind('M', figure.find(dot)), 16 * 1000));
    char move = 0;
    char h = 0;
    double x = 0.0;
    double y = 0.0;
    path >> move >> x >> y >> h >> move; // "h0"
    const double line = x + y;           // y is down
    std::size_t dots = 1;
    for (; path >> move && move == 'M'; ++dots) {
        path >> x >> y >> h >> move;
        REQUIRE(x + y == doctest::Approx(line).epsilon(0.2 / line));
    }
    CHECK(dots == 1000);
}

} // namespace point_plots_test

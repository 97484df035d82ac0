#include "explain/line_drawing.h"

#include "base/text_format.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

namespace line_drawing_test {

using namespace multipath;

namespace {

/// A cube of edge 2 around the origin with a small lamp in it.
Scene cube()
{
    SceneBuilder builder;
    builder.room({-1, -1, -1}, {1, 1, 1}, builder.grey(0.5, 0.0));
    return builder.rectangle({0, 0.5, 0}, {0.1, 0, 0}, {0, 0, 0.1}, builder.grey(0.5, 1.0)).scene(1.0);
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

TracedLine line_to(Vec3 end, bool joins)
{
    TracedLine line;
    line.points = {{0, 0, 0}, end};
    line.joins = {joins};
    return line;
}

std::string drawing_of(const StageTrace& trace, Chords chords = Chords::sphere, Vec3 up = {0, 1, 0})
{
    const Scene scene = cube();
    SolveOptions options;
    options.method = Method::global;
    options.chords = chords;
    return draw_lines({scene, options, "--method global, sequence sobol"}, trace, up, {"made & kept"});
}

/// A line from (0, 0, 0) to `end` and no crossings, beside one to a distance of 2, to which the drawing reaches.
std::string drawn(Vec3 end, Vec3 up = {0, 1, 0}, Chords chords = Chords::sphere)
{
    StageTrace trace;
    trace.title = "a < b";
    trace.kind = "line";
    trace.from_outside = true;
    trace.lines = {line_to(end, true), line_to({-2, 0, 0}, false)};
    return drawing_of(trace, chords, up);
}

} // namespace

// The two views are squares of 440 px with their middles at (250, 304) and (720, 304); a distance of 2 takes 49 % of a
// square to either side: 107.8 px per unit.
TEST_CASE("a line is drawn to the right, down and up in both views as seen from above and from the side")
{
    const std::string right = drawn({1, 0, 0});
    CHECK(count(right, "M250.0 304.0L357.8 304.0") == 1);
    CHECK(count(right, "M720.0 304.0L827.8 304.0") == 1);
    const std::string up = drawn({0, 1, 0});
    CHECK(count(up, "M250.0 304.0L250.0 304.0") == 1);
    CHECK(count(up, "M720.0 304.0L720.0 196.2") == 1);
    const std::string nearer = drawn({0, 0, 1}); // to the viewer of the side view, so down in the view from above
    CHECK(count(nearer, "M250.0 304.0L250.0 411.8") == 1);
    CHECK(count(nearer, "M720.0 304.0L720.0 304.0") == 1);
}

TEST_CASE("with z up a line along z rises in the view from the side")
{
    const std::string up = drawn({0, 0, 1}, {0, 0, 3});
    CHECK(count(up, "M250.0 304.0L250.0 304.0") == 1);
    CHECK(count(up, "M720.0 304.0L720.0 196.2") == 1);
    CHECK(count(drawn({0, 1, 0}, {0, 0, 3}), "M250.0 304.0L250.0 196.2") == 1); // away from the viewer of the side view
}

TEST_CASE("the surfaces are outlined: a cube is a square in both views")
{
    for (const double middle : {250.0, 720.0})
        for (const double x : {middle - 107.8, middle + 107.8})
            for (const char* y : {" 196.2", " 411.8"})
                CHECK(count(drawn({1, 0, 0}), format("%.1f", x) + y) >= 3); // of three sides or more
}

TEST_CASE("the sphere of which the lines are chords is drawn in both views")
{
    const std::string sphere = drawn({1, 0, 0});
    CHECK(count(sphere, "r=\"186.7\"") == 2); // the square root of 3
    CHECK(count(sphere, "disc: the sphere") == 1);
    const std::string box = drawn({1, 0, 0}, {0, 1, 0}, Chords::box);
    CHECK(count(box, "the sphere") == 0);
}

TEST_CASE("the crossings of few lines are numbered in both views, those of many are dots")
{
    TracedLine line = line_to({1, 0, 0}, false);
    line.crossings = {{{}, {0.5, 0, 0}, {}}, {{}, {1, 0, 0}, {}}};
    StageTrace trace;
    trace.lines = {line, line};
    const std::string few = drawing_of(trace);
    CHECK(count(few, ">1</text>") == 4);
    CHECK(count(few, ">2</text>") == 4);
    trace.lines.resize(20, line);
    const std::string many = drawing_of(trace);
    CHECK(count(many, ">1</text>") == 0);
    CHECK(count(many, "and 13 more") == 1); // seven are named
}

TEST_CASE("a line of no length has no head, and nothing in the drawing is undefined")
{
    const std::string still = drawn({0, 0, 0});
    CHECK(count(still, "nan") == 0);
    CHECK(count(still, "inf") == 0);
    CHECK(count(still, "Z\" fill=\"#0072b2\"") == 0);
    CHECK(count(drawn({1, 0, 0}), "Z\" fill=\"#0072b2\"") == 2);
}

TEST_CASE("the title and the comments are in the file, escaped")
{
    const std::string text = drawn({1, 0, 0});
    CHECK(count(text, "a &lt; b") == 2);
    CHECK(count(text, "made &amp; kept") == 1);
    CHECK(count(text, "</svg>") == 1);
}

} // namespace line_drawing_test

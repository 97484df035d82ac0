#include "scene/obj/polygon.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

namespace polygon_test {

using namespace multipath;

namespace {

struct Frame
{
    Vec3 origin, u, v;
    Vec3 at(double x, double y) const { return origin + x * u + y * v; }
};

const std::vector<Frame> frames = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
    {{5, 6, 7}, {0, 1, 0}, {1, 0, 0}},                 // seen from the other side
    {{1000, 2000, -500}, {0.6, 0, 0.8}, {0, 1, 0}},    // far away and oblique
    {{0, 0, 0}, {0, 0, 1}, normalized({1, 0.001, 0})}, // nearly along an axis
};

double area(Vec3 a, Vec3 b, Vec3 c)
{
    return 0.5 * length(cross(b - a, c - a));
}

/// How many triangles of the cut hold the point.
int cover_count(const std::vector<Vec3>& p, const Triangulation& cut, Vec3 point, Vec3 normal)
{
    int count = 0;
    for (const auto& [a, b, c] : cut.triangles) {
        const auto left_of = [&](Vec3 from, Vec3 to) { return dot(cross(to - from, point - from), normal) > 0; };
        count += left_of(p[a], p[b]) && left_of(p[b], p[c]) && left_of(p[c], p[a]) ? 1 : 0;
    }
    return count;
}

/// Counter-clockwise signed crossings of a ray to the right, in the plane: 1 inside a simple polygon, 0 outside.
int winding_number(const std::vector<double>& x, const std::vector<double>& y, double px, double py)
{
    int winding = 0;
    for (std::size_t i = 0, j = x.size() - 1; i < x.size(); j = i++) {
        if ((y[j] <= py) == (y[i] <= py))
            continue;
        const double crossing = x[j] + (py - y[j]) / (y[i] - y[j]) * (x[i] - x[j]);
        if (crossing > px)
            winding += y[i] > y[j] ? 1 : -1;
    }
    return winding;
}

/// Cuts the polygon in every frame, and compares it at random points with the winding number.
void check_cut(const std::vector<double>& x, const std::vector<double>& y, double radius, std::mt19937_64& random)
{
    std::uniform_real_distribution<double> coordinate(-radius, radius);
    for (const Frame& frame : frames) {
        std::vector<Vec3> corners;
        for (std::size_t i = 0; i < x.size(); ++i)
            corners.push_back(frame.at(x[i], y[i]));
        const Vec3 whole = area_vector(corners);
        const Triangulation cut = clip_ears(corners, whole, 1e-14);
        CHECK_FALSE(cut.crosses_itself);
        double sum = 0.0;
        for (const auto& [a, b, c] : cut.triangles)
            sum += area(corners[a], corners[b], corners[c]);
        CHECK(sum == doctest::Approx(length(whole)).epsilon(1e-9)); // corners 2000 from the origin: 1e-13 of the scene
        for (int i = 0; i < 20; ++i) {
            const double px = coordinate(random);
            const double py = coordinate(random);
            CHECK(cover_count(corners, cut, frame.at(px, py), whole) == winding_number(x, y, px, py));
        }
    }
}

} // namespace

// A polygon is simple if its corners go once around a point inside; their distances may be anything.
TEST_CASE("triangles of a star-shaped polygon cover its inside once and its outside never")
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> distance(0.05, 1.0);
    for (int count = 4; count < 60; count += 3) {
        std::vector<double> x, y;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::acos(-1.0) * i / count;
            const double r = distance(random);
            x.push_back(r * std::cos(angle));
            y.push_back(r * std::sin(angle));
        }
        check_cut(x, y, 1.0, random);
    }
}

TEST_CASE("combs, spirals and polygons with straight or repeated corners are cut without overlap")
{
    std::mt19937_64 random(8);
    std::vector<double> x, y; // a comb: every second corner is reflex
    for (int i = 0; i < 20; ++i) {
        x.insert(x.end(), {i * 0.1, i * 0.1 + 0.05});
        y.insert(y.end(), {0.0, -0.9});
    }
    x.insert(x.end(), {2.0, 0.0});
    y.insert(y.end(), {0.1, 0.1});
    check_cut(x, y, 2.0, random);

    x.clear();
    y.clear();
    for (int i = 0; i <= 100; ++i) { // a spiral of five turns, out and back
        x.push_back((1 + 0.1 * i) * std::cos(0.3 * i));
        y.push_back((1 + 0.1 * i) * std::sin(0.3 * i));
    }
    for (int i = 100; i >= 0; --i) {
        x.push_back((0.5 + 0.1 * i) * std::cos(0.3 * i));
        y.push_back((0.5 + 0.1 * i) * std::sin(0.3 * i));
    }
    check_cut(x, y, 11.0, random);

    check_cut({0, 1, 2, 2, 2, 1, 1, 1, 0, 0, 0}, {0, 0, 0, 1, 2, 2, 1, 1, 1, 1, 0.5}, 2.0, random);
}

// A square with a square hole, joined by a cut that the outline runs along twice.
TEST_CASE("a hole joined to the outline stays a hole")
{
    std::mt19937_64 random(9);
    check_cut({0, 4, 4, 0, 0, 1, 1, 3, 3, 1, 0}, {0, 0, 4, 4, 1, 1, 3, 3, 1, 1, 1}, 4.0, random);
    check_cut({0, 4, 4, 0, 0, 1, 1, 3, 3, 1}, {0, 0, 4, 4, 0, 1, 3, 3, 1, 1}, 4.0, random);
}

TEST_CASE("a polygon that crosses itself is reported, and cut all the same")
{
    const std::vector<Vec3> bow = {{0, 0, 0}, {3, 3, 0}, {3, 0, 0}, {0, 1, 0}};
    const Triangulation cut = clip_ears(bow, area_vector(bow), 1e-14);
    CHECK(cut.crosses_itself);
    CHECK(cut.triangles.size() == 2);
}

TEST_CASE("the area vector is area times normal, and the distance from the plane is in scene units")
{
    const std::vector<Vec3> square = {{1, 1, 2}, {1, 3, 2}, {1, 3, 5}, {1, 1, 5}};
    CHECK(area_vector(square) == Vec3{6, 0, 0});
    CHECK(distance_from_plane(square, area_vector(square)) == 0.0);
    CHECK(reflex_corner_count(square, area_vector(square)) == 0);
    // Corners in turn 0.1 above and below the plane z = 0.
    const std::vector<Vec3> saddle = {{0, 0, 0.1}, {1, 0, -0.1}, {1, 1, 0.1}, {0, 1, -0.1}};
    CHECK(distance_from_plane(saddle, area_vector(saddle)) == doctest::Approx(0.1));
}

} // namespace polygon_test

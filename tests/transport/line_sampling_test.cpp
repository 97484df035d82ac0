#include "transport/line_sampling.h"

#include "geometry/intersector.h"

#include <cmath>
#include <doctest/doctest.h>

using namespace multipath;

// (G1): of N lines of the invariant density through a sphere of radius r, 2 A / (4 pi r^2) N cross a flat patch of area
// A, wherever it lies and however it is turned. Each line crosses it at most once, so the count is binomial.
TEST_CASE("a global line crosses patches in proportion to their area")
{
    const std::vector<Surface> surfaces = {
        {Shape::parallelogram, {0, 0, 0}, {1, 0, 0}, {0, 0, 2}},             // on the border of the box
        {Shape::parallelogram, {0.4, 0.5, 0.9}, {0.2, 0, 0}, {0, 0.2, 0.1}}, // small, in the middle, oblique
        {Shape::triangle, {0.9, 0.1, 0.1}, {0, 0.8, 0}, {0, 0, 1.8}},
        {Shape::parallelogram, {0.0, 1.0, 0.0}, {0.01, 0, 0}, {0, 0, 2}}, // a strip along an edge
    };
    Bounds box;
    for (const Surface& surface : surfaces)
        box.include(surface.bounds());
    const GlobalLines lines(box);
    const Intersector intersector(surfaces);
    const auto sequence = make_sequence("random", 4);

    constexpr std::uint64_t count = 400000;
    std::vector<Item> items(count);
    sequence->generate(0, items);
    std::vector<std::uint64_t> crossings(surfaces.size(), 0);
    std::vector<std::uint64_t> from_front(surfaces.size(), 0);
    std::vector<Hit> hits;
    for (const Item& item : items) {
        intersector.all_hits(lines.line(item), hits);
        for (const Hit& hit : hits) {
            ++crossings[hit.surface];
            from_front[hit.surface] += hit.front ? 1 : 0;
        }
    }
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        CAPTURE(s);
        const double expected = lines.expected_crossings(surfaces[s].area(), count);
        const double p = expected / count;
        CHECK(std::abs(static_cast<double>(crossings[s]) - expected) < 4.0 * std::sqrt(count * p * (1.0 - p)));
        const auto crossed = static_cast<double>(crossings[s]);
        CHECK(std::abs(static_cast<double>(from_front[s]) - 0.5 * crossed) < 4.0 * 0.5 * std::sqrt(crossed));
    }
}

// The box is convex, so the share of the chords of its sphere that meet it is A_box / A_sphere (Crofton).
TEST_CASE("the lines to cast make the wanted number meet the box")
{
    Bounds box;
    box.include(Vec3{-1, 0, 2});
    box.include(Vec3{2, 1, 4});
    const GlobalLines lines(box);
    const std::uint64_t met = 100000;
    const std::uint64_t cast = lines.lines_to_cast(met);
    CHECK(static_cast<double>(cast) == doctest::Approx(met * lines.sphere_area() / box.area()));

    const Vec3 d = box.size();
    const std::vector<Surface> walls = {{Shape::parallelogram, box.low, {d.x, 0, 0}, {0, d.y, 0}},
                                        {Shape::parallelogram, box.low, {d.x, 0, 0}, {0, 0, d.z}},
                                        {Shape::parallelogram, box.low, {0, d.y, 0}, {0, 0, d.z}},
                                        {Shape::parallelogram, box.high, {-d.x, 0, 0}, {0, -d.y, 0}},
                                        {Shape::parallelogram, box.high, {-d.x, 0, 0}, {0, 0, -d.z}},
                                        {Shape::parallelogram, box.high, {0, -d.y, 0}, {0, 0, -d.z}}};
    const Intersector intersector(walls);
    std::vector<Item> items(cast);
    make_sequence("random", 1)->generate(0, items);
    std::vector<Hit> hits;
    std::uint64_t found = 0;
    for (const Item& item : items) {
        intersector.all_hits(lines.line(item), hits);
        found += hits.empty() ? 0 : 1;
    }
    const double p = static_cast<double>(met) / static_cast<double>(cast);
    CHECK(std::abs(static_cast<double>(found) - met) < 4.0 * std::sqrt(static_cast<double>(cast) * p * (1.0 - p)));
}

// Items 0 and 1 of Sobol's sequence can put both ends on one point: such a line counts as cast and meets nothing.
TEST_CASE("a line between equal points meets nothing")
{
    Bounds box;
    box.include(Vec3{0, 0, 0});
    box.include(Vec3{1, 1, 1});
    const GlobalLines lines(box);
    const Intersector intersector({{Shape::parallelogram, {0, 0.5, 0}, {1, 0, 0}, {0, 0, 1}}});
    std::vector<Hit> hits;
    intersector.all_hits(lines.line({0.0, 0.0, 0.0, 0.0}), hits);
    CHECK(hits.empty());
    intersector.all_hits(lines.line({0.5, 0.5, 0.5, 0.5}), hits);
    CHECK(hits.empty());
}

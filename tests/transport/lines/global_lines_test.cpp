#include "transport/lines/global_lines.h"

#include "geometry/intersector/intersector.h"
#include "geometry/intersector/surface_sizes.h"
#include "statistics.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>

namespace line_sampling_test {

using namespace multipath;

namespace {

constexpr std::array<Chords, 2> both_kinds = {Chords::sphere, Chords::box};

Bounds box_between(Vec3 low, Vec3 high)
{
    Bounds box;
    box.include(low);
    box.include(high);
    return box;
}

/// The box from inside.
SurfaceList walls_of(const Bounds& box)
{
    const Vec3 d = box.size();
    return {{Shape::parallelogram, box.low, {0, 0, d.z}, {d.x, 0, 0}},
            {Shape::parallelogram, box.low, {d.x, 0, 0}, {0, d.y, 0}},
            {Shape::parallelogram, box.low, {0, d.y, 0}, {0, 0, d.z}},
            {Shape::parallelogram, box.high, {-d.x, 0, 0}, {0, 0, -d.z}},
            {Shape::parallelogram, box.high, {0, -d.y, 0}, {-d.x, 0, 0}},
            {Shape::parallelogram, box.high, {0, 0, -d.z}, {0, -d.y, 0}}};
}

std::vector<Item> items_of(const char* sequence, std::uint64_t seed, std::uint64_t count)
{
    std::vector<Item> items(static_cast<std::size_t>(count));
    make_sequence(sequence, seed)->generate(0, items);
    return items;
}

/// How often lines cross a surface, and how often they come to its front.
struct Crossings
{
    double all = 0.0;
    double to_front = 0.0;
};

std::vector<Crossings> crossings_of(const SurfaceList& surfaces, const GlobalLines& lines,
                                    const std::vector<Item>& items)
{
    const Intersector intersector(surfaces);
    std::vector<Crossings> crossings(surfaces.size());
    std::vector<Hit> hits;
    for (const Item& item : items) {
        intersector.all_hits(lines.line(item), hits);
        for (const Hit& hit : hits) {
            crossings[hit.surface].all += 1.0;
            crossings[hit.surface].to_front += hit.front ? 1.0 : 0.0;
        }
    }
    return crossings;
}

/// Counts are binomial: a line crosses a flat patch at most once, from either side with probability 1/2.
void check_crossings(const SurfaceList& surfaces, const GlobalLines& lines, std::uint64_t count)
{
    const std::vector<Crossings> crossings = crossings_of(surfaces, lines, items_of("random", 4, count));
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        CAPTURE(s);
        const double expected = lines.expected_crossings(surfaces[s].area(), count);
        const double p = expected / static_cast<double>(count);
        CHECK(std::abs(crossings[s].all - expected) <= 4.0 * std::sqrt(expected * (1.0 - p)));
        CHECK(std::abs(crossings[s].to_front - 0.5 * crossings[s].all) <= 4.0 * 0.5 * std::sqrt(crossings[s].all));
    }
}

} // namespace

// (G1): of N lines of the invariant density through a sphere or a box of area A_0, 2 A / A_0 N cross a flat patch of
// area A, wherever it lies and however it is turned.
TEST_CASE("a global line crosses patches in proportion to their area")
{
    const SurfaceList surfaces = {
        {Shape::parallelogram, {0, 0, 0}, {1, 0, 0}, {0, 0, 2}},             // on the border of the box
        {Shape::parallelogram, {0.4, 0.5, 0.9}, {0.2, 0, 0}, {0, 0.2, 0.1}}, // small, in the middle, oblique
        {Shape::triangle, {0.9, 0.1, 0.1}, {0, 0.8, 0}, {0, 0, 1.8}},
        {Shape::parallelogram, {0.0, 1.0, 0.0}, {0.01, 0, 0}, {0, 0, 2}}, // a strip along an edge
    };
    for (const Chords chords : both_kinds) {
        CAPTURE(static_cast<int>(chords));
        check_crossings(surfaces, GlobalLines(bounds_of(surfaces), chords), 400000);
    }
}

// 24 patches anywhere in a long room, and its walls, which lie in the sides of the box where the lines begin.
TEST_CASE("random patches and the walls themselves are crossed as often as their area says")
{
    const Bounds room = box_between({-1, 0, 2}, {2, 1, 4});
    SurfaceList surfaces = walls_of(room);
    const std::vector<Item> numbers = items_of("random", 9, 72);
    for (std::size_t k = 0; k < numbers.size(); k += 3) {
        const auto vector = [&](std::size_t row) {
            return Vec3{numbers[row][0] - 0.5, numbers[row][1] - 0.5, numbers[row][2] - 0.5};
        };
        const Vec3 centre = room.centre() + Vec3{1.5 * vector(k).x, 0.4 * vector(k).y, vector(k).z};
        const Vec3 u = 0.3 * vector(k + 1);
        const Vec3 v = 0.3 * vector(k + 2);
        surfaces.push_back({Shape::parallelogram, centre - 0.5 * u - 0.5 * v, u, v});
    }
    for (const Chords chords : both_kinds) {
        CAPTURE(static_cast<int>(chords));
        check_crossings(surfaces, GlobalLines(room, chords), 400000);
    }
}

// Lines of the invariant density cross a small patch from directions with density proportional to the cosine: the mean
// of |cos| is 2/3, of its square 1/2, and the azimuth is uniform. The patch lies off the middle, where an error in the
// weights of the sides would show.
TEST_CASE("at any place lines come from all directions alike")
{
    const Bounds room = box_between({0, 0, 0}, {3, 1, 2});
    const Surface patch = {Shape::parallelogram, {2.2, 0.1, 0.2}, {0.3, 0.2, 0.1}, {-0.1, 0.2, 0.3}};
    const Vec3 normal = patch.normal();
    const Vec3 tangent = normalized(patch.edge_u);
    const Vec3 bitangent = cross(normal, tangent);
    const Intersector intersector({patch});
    for (const Chords chords : both_kinds) {
        CAPTURE(static_cast<int>(chords));
        const GlobalLines lines(room, chords);
        std::vector<double> cosines;
        std::vector<double> squares;
        std::array<std::vector<double>, 4> harmonics;
        std::vector<Hit> hits;
        for (const Item& item : items_of("random", 6, 400000)) {
            const Line line = lines.line(item);
            intersector.all_hits(line, hits);
            if (hits.empty())
                continue;
            const Vec3 direction = normalized(line.direction);
            const double cosine = std::abs(dot(direction, normal));
            const double azimuth = std::atan2(dot(direction, bitangent), dot(direction, tangent));
            cosines.push_back(cosine);
            squares.push_back(cosine * cosine);
            harmonics[0].push_back(std::cos(azimuth));
            harmonics[1].push_back(std::sin(azimuth));
            harmonics[2].push_back(std::cos(2.0 * azimuth));
            harmonics[3].push_back(std::sin(2.0 * azimuth));
        }
        CHECK(cosines.size() > 1000);
        CHECK(estimate(cosines).agrees_with(2.0 / 3.0));
        CHECK(estimate(squares).agrees_with(0.5));
        for (const std::vector<double>& harmonic : harmonics)
            CHECK(estimate(harmonic).agrees_with(0.0));
    }
}

// The box is convex, so the share of the chords of its sphere that meet it is A_box / A_sphere (Crofton).
TEST_CASE("the lines to cast make the wanted number meet the box")
{
    const Bounds box = box_between({-1, 0, 2}, {2, 1, 4});
    const GlobalLines lines(box);
    const std::uint64_t met = 100000;
    const std::uint64_t cast = lines.lines_to_cast(met);
    CHECK(static_cast<double>(cast) == doctest::Approx(met * lines.sphere_area() / box.area()));

    const Intersector intersector(walls_of(box));
    std::vector<Hit> hits;
    std::uint64_t found = 0;
    for (const Item& item : items_of("random", 1, cast)) {
        intersector.all_hits(lines.line(item), hits);
        found += hits.empty() ? 0 : 1;
    }
    const double p = static_cast<double>(met) / static_cast<double>(cast);
    CHECK(std::abs(static_cast<double>(found) - met) < 4.0 * std::sqrt(static_cast<double>(cast) * p * (1.0 - p)));
}

// The walls are the sides of the box: a line enters through the back of one of them and ends at the front of another.
// Sobol's first items are the extreme ones: all numbers 0, all 1/2.
TEST_CASE("every line of the box enters it and leaves it")
{
    const Bounds box = box_between({-1, 0, 2}, {2, 1, 4});
    const GlobalLines lines(box, Chords::box);
    const Intersector intersector(walls_of(box));
    std::vector<Hit> hits;
    for (const char* sequence : {"random", "sobol"}) {
        CAPTURE(sequence);
        std::uint64_t crossing = 0;
        const std::vector<Item> items = items_of(sequence, 1, 1u << 16);
        for (const Item& item : items) {
            intersector.all_hits(lines.line(item), hits);
            crossing += hits.size() == 2 && !hits[0].front && hits[1].front ? 1 : 0;
        }
        CHECK(crossing == items.size());
    }
    for (const std::uint64_t met : {std::uint64_t{1}, std::uint64_t{1000003}, std::uint64_t{1} << 48})
        CHECK(lines.lines_to_cast(met) == met);
}

// The box of a flat scene has no thickness and two sides, A_0 = 2 A_plane: every line of the box crosses the plane, and
// a patch as often as its share of it.
TEST_CASE("in a flat scene every line of the box crosses the plane once")
{
    const std::array<Vec3, 4> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
    for (std::size_t k = 0; k < 3; ++k) {
        CAPTURE(k);
        const Vec3 u = 2.0 * axes[k];
        const Vec3 v = axes[k + 1];
        const Vec3 corner = {0.5, -1.0, 3.0};
        const SurfaceList surfaces = {{Shape::parallelogram, corner, 0.25 * u, v},
                                      {Shape::parallelogram, corner + 0.25 * u, 0.75 * u, v}};
        const GlobalLines lines(bounds_of(surfaces), Chords::box);
        constexpr std::uint64_t count = 100000;
        CHECK(lines.expected_crossings(2.0, count) == doctest::Approx(count));
        check_crossings(surfaces, lines, count);
        const std::vector<Crossings> crossings = crossings_of(surfaces, lines, items_of("random", 5, count));
        CHECK(crossings[0].all + crossings[1].all == count);
    }
}

// Items 0 and 1 of Sobol's sequence can put both ends on one point: such a line counts as cast and meets nothing.
TEST_CASE("a line between equal points meets nothing")
{
    const GlobalLines lines(box_between({0, 0, 0}, {1, 1, 1}));
    const Intersector intersector({{Shape::parallelogram, {0, 0.5, 0}, {1, 0, 0}, {0, 0, 1}}});
    std::vector<Hit> hits;
    intersector.all_hits(lines.line({0.0, 0.0, 0.0, 0.0}), hits);
    CHECK(hits.empty());
    intersector.all_hits(lines.line({0.5, 0.5, 0.5, 0.5}), hits);
    CHECK(hits.empty());
}

TEST_CASE("many lines at a time are those of one item each, bit for bit")
{
    Bounds box;
    box.include(Vec3{-1, 2, 0});
    box.include(Vec3{3, 2.5, 7});
    for (const Chords chords : {Chords::sphere, Chords::box}) {
        const GlobalLines lines(box, chords);
        for (const std::size_t count : {1u, 7u, 256u, 1000u}) {
            std::vector<Item> items(count);
            make_sequence("sobol", 1)->generate(0, items);
            std::vector<Line> found(count);
            lines.lines(items.data(), count, found.data());
            for (std::size_t k = 0; k < count; ++k) {
                const Line expected = lines.line(items[k]);
                REQUIRE(found[k].t_max == expected.t_max);
                for (const double t : {0.0, 1.0}) {
                    REQUIRE(found[k].at(t).x == expected.at(t).x);
                    REQUIRE(found[k].at(t).y == expected.at(t).y);
                    REQUIRE(found[k].at(t).z == expected.at(t).z);
                }
            }
        }
    }
}

} // namespace line_sampling_test

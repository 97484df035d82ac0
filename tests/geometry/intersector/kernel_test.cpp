// Every kernel, one line at a time and in blocks, against deciding all surfaces in double precision: the same hits to
// the last bit, without tolerance.

#include "geometry/intersector/kernel.h"
#include "geometry/surface_pieces.h"
#include "kernel_trials.h"
#include "scene/obj/obj_reader.h"

#include <cmath>
#include <doctest/doctest.h>
#include <string>

namespace kernel_test {

using namespace multipath;

namespace {

void add_box(SurfaceList& surfaces, Vec3 low, Vec3 size)
{
    const Vec3 x = {size.x, 0, 0};
    const Vec3 y = {0, size.y, 0};
    const Vec3 z = {0, 0, size.z};
    for (const Surface& face : {rectangle(low, x, z), rectangle(low + y, z, x), rectangle(low, z, y),
                                rectangle(low + x, y, z), rectangle(low, y, x), rectangle(low + z, x, y)})
        surfaces.push_back(face);
}

SurfaceList transformed(SurfaceList surfaces, double scale, Vec3 shift)
{
    for (Surface& s : surfaces)
        s = {s.shape, shift + scale * s.origin, scale * s.edge_u, scale * s.edge_v};
    return surfaces;
}

/// By a small angle.
Vec3 turned(Vec3 p, Vec3 by)
{
    return p + cross(by, p);
}

SurfaceList scattered_triangles(std::size_t count, double size)
{
    SurfaceList surfaces = scattered_surfaces(count, size, 10);
    for (Surface& surface : surfaces)
        surface.shape = Shape::triangle;
    return surfaces;
}

} // namespace

TEST_CASE("the plain kernel is there, and the fastest has another name where the processor has vectors")
{
    const std::vector<const FilterKernel*> kernels = available_kernels();
    REQUIRE(!kernels.empty());
    CHECK(std::string(kernels.back()->name) == "plain");
#if defined(__x86_64__)
    CHECK(std::string(kernels.front()->name) != "plain");
#endif
}

// 128 surfaces that belong to no frame are still all filtered, 129 found through the hierarchy.
TEST_CASE("kernels lose no hit of scattered surfaces, wherever they stand and however large they are")
{
    for (const std::size_t count : {1u, 15u, 17u, 128u, 129u, 300u}) {
        const SurfaceList surfaces = scattered_surfaces(count, count > 50 ? 0.2 : 0.5, count);
        CHECK(wrong_lines(surfaces, difficult_lines(surfaces, 3000, count)) == 0);
        CHECK(wrong_rays(surfaces, rays_from(surfaces, 3000, count)) == 0);
    }
    for (const std::size_t count : {30u, 200u})
        for (const double scale : {1.0, 1e-6, 1e6})
            for (const double shift : {0.0, 1.0, 1e6}) {
                const SurfaceList surfaces =
                    transformed(scattered_surfaces(count, 0.3, count), scale, {shift, -2.0 * shift, 0.5 * shift});
                CHECK(wrong_lines(surfaces, difficult_lines(surfaces, 1000, 5)) == 0);
                CHECK(wrong_rays(surfaces, rays_from(surfaces, 1000, 5)) == 0);
            }
}

// A room, and boxes that stand on its floor, on each other, and stick out; then more than are all filtered.
TEST_CASE("kernels lose no hit of coincident faces")
{
    SurfaceList surfaces;
    Numbers numbers(3);
    add_box(surfaces, {1, 1, 1}, {-1, -1, -1});
    for (int i = 0; i < 7; ++i)
        add_box(surfaces, {0.125 * i, 0, 0.25}, {0.125, 0.5, 0.25 + 0.125 * (i % 3)});
    for (int i = 0; i < 4; ++i)
        add_box(surfaces, {0.125 * i, 0.5, 0.3}, {0.25, 0.125, 0.25});
    for (const bool many : {false, true}) {
        while (many && surfaces.size() <= FlatSurfaces::most)
            add_box(
                surfaces,
                {0.0625 * static_cast<double>(numbers.below(16)), 0, 0.0625 * static_cast<double>(numbers.below(16))},
                {0.0625, 0.25, 0.0625});
        CHECK(wrong_lines(surfaces, difficult_lines(surfaces, 10000, 6)) == 0);
        CHECK(wrong_rays(surfaces, rays_from(surfaces, 10000, 6)) == 0);
        for (Surface& s : surfaces)
            s = moved(s);
        CHECK(wrong_lines(surfaces, difficult_lines(surfaces, 10000, 7)) == 0);
    }
}

// Up to a tolerance of 1e-5 such rectangles share their axes in the filter, beyond it they do not.
TEST_CASE("kernels lose no hit of rectangles whose edges run almost along common axes")
{
    for (const double angle : {0.0, 1e-7, 5e-6, 9e-6, 2e-5, 1e-3}) {
        SurfaceList surfaces;
        add_box(surfaces, {1, 1, 1}, {-1, -1, -1});
        Numbers numbers(12);
        for (int i = 0; i < 15; ++i)
            add_box(surfaces, numbers.point(0.1, 0.8), {0.1, 0.2, 0.05 + 0.01 * i});
        for (Surface& s : surfaces) {
            const Vec3 by = angle * numbers.point(-1, 1);
            s = {s.shape, s.origin, turned(s.edge_u, by), turned(s.edge_v, by)};
        }
        CHECK(wrong_lines(surfaces, difficult_lines(surfaces, 5000, 13)) == 0);
        CHECK(wrong_rays(surfaces, rays_from(surfaces, 5000, 14)) == 0);
    }
}

// Heights from 1e-3 to 1e-16 of the scene: from those that single precision shows well to those whose rows are
// rounding.
TEST_CASE("kernels lose no hit of slivers and tiny triangles")
{
    for (const std::size_t count : {40u, 200u}) {
        Numbers numbers(count);
        SurfaceList surfaces;
        for (std::size_t i = 0; i < count; ++i) {
            const double height = std::pow(10.0, -3.0 - numbers.within(0, 13));
            const Vec3 edge = numbers.point(-0.5, 0.5);
            const Surface sliver = {i % 3 == 0 ? Shape::parallelogram : Shape::triangle, numbers.point(0, 1), edge,
                                    numbers.unit() * edge + height * numbers.point(-1, 1)};
            const Surface tiny = {i % 3 == 1 ? Shape::parallelogram : Shape::triangle, numbers.point(0, 1),
                                  1e-6 * numbers.point(-1, 1), 1e-6 * numbers.point(-1, 1)};
            for (const Surface& s : {sliver, tiny})
                if (s.area() > 0.0)
                    surfaces.push_back(s);
        }
        CHECK(wrong_lines(surfaces, difficult_lines(surfaces, 10000, 8)) == 0);
        CHECK(wrong_rays(surfaces, rays_from(surfaces, 10000, 8)) == 0);
    }
}

// The leaves of a book, which rays pass at a distance of a millionth to a thousandth from its spine: they come almost
// at once, each at a slant whose reciprocal has an error of its own.
TEST_CASE("the nearest of few surfaces is found where others are almost as near")
{
    SurfaceList surfaces = {{Shape::parallelogram, {-1, -1, 3}, {2, 0, 0}, {0, 2, 0}}};
    Numbers numbers(15);
    for (int k = 0; k < 12; ++k) {
        const double angle = 3.0 * (k + 0.3) / 12.0;
        const Vec3 across = {std::cos(angle), 0.0, std::sin(angle)};
        surfaces.push_back({Shape::triangle, Vec3{0, -1, 0} - across, 2.0 * across, {0, 4, 0}});
    }
    RaysFrom from;
    while (from.rays.size() < 20000) {
        const Vec3 start = surfaces[0].at(numbers.unit(), numbers.unit());
        const double size = std::pow(10.0, numbers.within(-6, -3));
        const Vec3 target = {size * numbers.within(-1, 1), numbers.within(-0.9, -0.5), size * numbers.within(-1, 1)};
        from.surfaces.push_back(0);
        from.rays.push_back({start, target - start});
    }
    CHECK(wrong_rays(surfaces, from) == 0);
}

/// Whether one of two surfaces of a plane holds an inner point of the other.
static bool have_area_in_common(const SurfaceList& surfaces, std::uint32_t a, std::uint32_t b)
{
    const SharedPlanes planes = share_planes({surfaces[a], surfaces[b]}, {0, 1});
    const SurfaceTable table({surfaces[a], surfaces[b]}, planes);
    for (int i = 1; i < 16; ++i)
        for (int k = 1; k < 16; ++k)
            if (table.holds(surfaces[a].at(i / 16.0, k / 16.0), 1) ||
                table.holds(surfaces[b].at(i / 16.0, k / 16.0), 0))
                return true;
    return false;
}

// Of 12^2 in one plane and of 40^2 those are compared whose boxes meet in the hierarchy, of few in one plane all. Cells
// that only touch, as at the points on borders, do not count.
TEST_CASE("what lies in the plane of a surface and holds a point is found, in small groups and large ones")
{
    for (const auto& [cells, in_plane] : {std::pair{12, 44}, {12, 144}, {40, 1600}}) {
        SurfaceList surfaces = pieces(rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}), cells);
        add_box(surfaces, {0.3, 0, 0.3}, {0.3, 0.3, 0.3});
        add_box(surfaces, {0.45, 0.3, 0.3}, {0.4, 0.3, 0.4});
        const SurfaceList part(surfaces.begin() + cells * cells - in_plane, surfaces.end());
        const BruteForce brute_force(part);
        const Intersector intersector(part);
        Numbers numbers(4);
        std::size_t coincident = 0;
        for (int n = 0; n < 20000; ++n) {
            const auto s = static_cast<std::uint32_t>(numbers.below(part.size()));
            const Vec3 point = part[s].at(numbers.unit(), n % 5 == 0 ? 0.0 : numbers.unit());
            std::vector<std::uint32_t> found = intersector.coincident_surfaces(s, point);
            std::sort(found.begin(), found.end());
            std::vector<std::uint32_t> expected = brute_force.coincident_surfaces(s, point);
            expected.erase(std::remove_if(expected.begin(), expected.end(),
                                          [&](std::uint32_t o) { return !have_area_in_common(part, s, o); }),
                           expected.end());
            REQUIRE(found == expected);
            coincident += found.size();
        }
        CHECK(coincident > 100);
    }
}

TEST_SUITE_BEGIN("statistics");

TEST_CASE("kernels lose no hit of 300,000 lines through the bundled scenes")
{
    for (const std::string name :
         {"5cubes", "4chairs", "4chairs-up", "cornell", "cube", "furnace", "sphere", "squares"}) {
        const SurfaceList surfaces = read_obj("scenes/" + name + ".obj").surfaces;
        CHECK_MESSAGE(wrong_lines(surfaces, random_chords(surfaces, surfaces.size() > 100 ? 15000 : 40000)) == 0, name);
        CHECK_MESSAGE(wrong_lines(surfaces, difficult_lines(surfaces, 8000, 9)) == 0, name);
        CHECK_MESSAGE(wrong_rays(surfaces, rays_from(surfaces, 8000, 9)) == 0, name);
    }
}

TEST_CASE("kernels lose no hit of a hundred thousand triangles")
{
    const SurfaceList surfaces = scattered_triangles(100000, 0.01);
    CHECK(wrong_lines(surfaces, random_chords(surfaces, 150)) == 0);
    CHECK(wrong_lines(surfaces, difficult_lines(surfaces, 200, 11)) == 0);
}

TEST_CASE("no hit is lost among a million triangles")
{
    const SurfaceList surfaces = scattered_triangles(1000000, 0.01);
    const BruteForce brute_force(surfaces);
    const Intersector intersector(surfaces, *available_kernels()[0], 2);
    std::vector<Line> lines = random_chords(surfaces, 20);
    const std::vector<Line> others = difficult_lines(surfaces, 40, 12);
    lines.insert(lines.end(), others.begin(), others.end());
    HitLists lists;
    intersector.all_hits(lines.data(), lines.size(), lists);
    std::vector<Hit> expected;
    std::size_t wrong = 0;
    std::size_t met = 0;
    for (std::size_t n = 0; n < lines.size(); ++n) {
        brute_force.all_hits(lines[n], expected);
        const HitLists::List found = lists[n];
        wrong += !std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                             [](const Hit& a, const Hit& b) { return same(a, b); });
        met += expected.size();
    }
    CHECK(wrong == 0);
    CHECK(met > 5 * lines.size()); // some of the difficult ones meet nothing
}

TEST_SUITE_END();

} // namespace kernel_test

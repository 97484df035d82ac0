#include "transport/sparse_exchange.h"

#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

using namespace multipath;

namespace {

constexpr std::uint64_t lines = 1u << 20;

CountedLines counted(const Scene& scene, const GlobalLines& global_lines)
{
    return count_lines(scene, global_lines, *make_sequence("sobol", 0), 0, lines, std::size_t{1} << 30, {2});
}

/// A room with a box in it and without one wall.
Scene open_room()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {1, 1, 1}, grey).box({0.2, 0.2, 0.2}, {0.5, 0.6, 0.7}, grey);
    SceneFile file = builder.file();
    file.surfaces.erase(file.surfaces.begin() + 5);
    file.material.pop_back();
    file.group.pop_back();
    file.line.pop_back();
    return Scene(file, 0.1);
}

} // namespace

TEST_CASE("the product with a counted exchange is the sum over all entries, the same bits for any number of threads")
{
    const Scene scene = open_room();
    const GlobalLines global_lines(scene.bounds(), Chords::box);
    const LineCounts counts = counted(scene, global_lines).counts;
    const double crossing_area = 1.0 / global_lines.expected_crossings(1.0, lines);
    const SparseExchange exchange(counts, crossing_area, 2);
    std::vector<Rgb> x;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        x.push_back({1.0, std::sin(i), 1.0 / (1.0 + i)});

    const std::vector<Rgb> y = exchange.apply(x, 1);
    CHECK(exchange.apply(x, 2) == y);
    CHECK(exchange.apply(x, 7) == y);
    std::vector<Rgb> expected(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        for (const CountEntry& entry : counts.row(i)) // by columns, as the exchange is symmetric
            expected[entry.patch] += (crossing_area * static_cast<double>(entry.count)) * x[i];
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        CHECK(y[i].g == doctest::Approx(expected[i].g).epsilon(1e-12).scale(exchange.row_area(i)));
        CHECK(y[i].b == doctest::Approx(expected[i].b).epsilon(1e-12));
        // Whatever leaves the patch arrives, escapes or is lost.
        CHECK(y[i].r + exchange.escaping(i) + exchange.behind(i) ==
              doctest::Approx(exchange.row_area(i)).epsilon(1e-12));
    }
}

// A line crosses a patch of area A in expectation A / crossing_area times. Stratified lines vary less than independent
// ones, whose relative deviation is 1 / sqrt(crossings).
TEST_CASE("rows add up to the areas of the patches, and the missing wall takes its share")
{
    const Scene scene = open_room();
    const GlobalLines global_lines(scene.bounds(), Chords::box);
    const LineCounts counts = counted(scene, global_lines).counts;
    const double crossing_area = 1.0 / global_lines.expected_crossings(1.0, lines);
    const SparseExchange exchange(counts, crossing_area, 2);
    double escaping = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        CHECK(std::abs(exchange.row_area(i) - scene.area(i)) < 4.5 * std::sqrt(scene.area(i) * crossing_area));
        CHECK(exchange.behind(i) == 0.0);
        escaping += exchange.escaping(i);
    }
    CHECK(escaping ==
          doctest::Approx(1.0).epsilon(0.005)); // area of the wall; a million lines, a third of them through it
}

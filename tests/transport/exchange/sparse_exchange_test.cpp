#include "transport/exchange/sparse_exchange.h"

#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

namespace sparse_exchange_test {

using namespace multipath;

namespace {

constexpr std::uint64_t lines = 1u << 20;

CountedLines counted(const Scene& scene, const GlobalLines& global_lines, std::uint64_t lines_cast)
{
    return count_lines(scene, global_lines, *make_sequence("sobol", 0), 0, lines_cast, std::size_t{1} << 30, {2});
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

TEST_CASE(
    "the product with a counted exchange is symmetric, the same bits for any number of threads, and loses nothing")
{
    const Scene scene = open_room();
    const GlobalLines global_lines(scene.bounds(), Chords::box);
    // With 2^20 lines thousands cross every patch; with 2^9 three do, and some have none.
    for (const std::uint64_t lines_cast : {std::uint64_t{1} << 20, std::uint64_t{1} << 9})
        for (const double unseen_lines : {0.0, 1.0}) {
            CAPTURE(lines_cast);
            CAPTURE(unseen_lines);
            const LineCounts counts = counted(scene, global_lines, lines_cast).counts;
            const double crossing_area = 1.0 / global_lines.expected_crossings(1.0, lines_cast);
            const SparseExchange exchange(counts, scene.areas(), crossing_area, unseen_lines, 2);
            std::vector<Rgb> x;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                x.push_back({1.0, std::sin(i), 1.0 / (1.0 + i)});

            const std::vector<Rgb> y = exchange.apply(x, 1);
            CHECK(exchange.apply(x, 2) == y);
            CHECK(exchange.apply(x, 7) == y);
            double there = 0.0;
            double back = 0.0;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                // Whatever leaves the patch arrives, escapes or is lost.
                CHECK(y[i].r + exchange.escaping(i) + exchange.behind(i) ==
                      doctest::Approx(scene.area(i)).epsilon(1e-12));
                CHECK(y[i].b >= 0.0);
                there += x[i].b * y[i].g;
                back += x[i].g * y[i].b;
            }
            CHECK(there == doctest::Approx(back).epsilon(1e-12));
        }
}

// The oracle is the count of each pair: with thousands of lines per patch the factors are 1 to a few percent.
TEST_CASE("with many lines a counted exchange is what the lines counted, and they have seen nearly all of it")
{
    const Scene scene = open_room();
    const GlobalLines global_lines(scene.bounds(), Chords::box);
    const LineCounts counts = counted(scene, global_lines, lines).counts;
    const double crossing_area = 1.0 / global_lines.expected_crossings(1.0, lines);
    const SparseExchange exchange(counts, scene.areas(), crossing_area, 0.0, 2);
    CHECK(exchange.unseen_share() < 1e-3);
    double escaping = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        CHECK(exchange.behind(i) == 0.0);
        escaping += exchange.escaping(i);
    }
    CHECK(escaping ==
          doctest::Approx(1.0).epsilon(0.005)); // area of the wall; a million lines, a third of them through it
    std::vector<Rgb> one(scene.patch_count());
    for (const std::uint32_t j : {0u, 77u, 301u}) {
        one[j] = {1.0, 1.0, 1.0};
        const std::vector<Rgb> column = exchange.apply(one, 2);
        one[j] = {};
        for (const CountEntry& entry : counts.row(j)) {
            const double expected = crossing_area * static_cast<double>(entry.count);
            CHECK(column[entry.patch].g == doctest::Approx(expected).epsilon(0.1).scale(1e-4 * scene.area(j)));
        }
    }
}

TEST_CASE("patches that few lines join only with each other still exchange light with all others")
{
    const Scene scene = open_room();
    const GlobalLines global_lines(scene.bounds(), Chords::box);
    const LineCounts counts = counted(scene, global_lines, 64).counts;
    const double crossing_area = 1.0 / global_lines.expected_crossings(1.0, 64);
    const SparseExchange exchange(counts, scene.areas(), crossing_area, 1.0, 2);
    CHECK(exchange.unseen_share() > 0.3);
    std::vector<Rgb> one(scene.patch_count());
    one[5] = {1.0, 1.0, 1.0};
    for (const Rgb y : exchange.apply(one, 2))
        CHECK(y.r > 0.0);
}

} // namespace sparse_exchange_test

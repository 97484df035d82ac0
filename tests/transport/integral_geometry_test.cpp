// What lines and rays of the right density must find, by closed forms. "Within 4 standard errors": see laws_test.cpp.

#include "geometry/form_factor/exchange_area.h"
#include "geometry/intersector/intersector.h"
#include "statistics.h"
#include "test_scenes.h"
#include "transport/exchange/pair_counts.h"
#include "transport/lines/depth_complexity.h"
#include "transport/lines/global_lines.h"
#include "transport/lines/local_rays.h"

#include <array>
#include <doctest/doctest.h>
#include <initializer_list>

namespace integral_geometry_test {

using namespace multipath;

namespace {

constexpr std::uint64_t line_count = 1 << 13;
constexpr std::uint64_t runs = 16;
constexpr std::array<const char*, 3> sequences = {"random", "sobol-owen", "halton-permuted"};

/// Shares of the lines of one run that meet the room, and means over these.
struct RoomLines
{
    double crossings = 0.0;
    double into_box = 0.0;
    double chord = 0.0; ///< [m]
};

/// Surfaces from `first_of_box` on are the box.
RoomLines lines_of_run(const Scene& scene, std::uint32_t first_of_box, const GlobalLines& lines, const Sequence& items)
{
    RoomLines sum;
    double met = 0.0;
    std::vector<Hit> hits;
    for (std::uint64_t n = 0; n < line_count; ++n) {
        const Line line = lines.line(items.item(n));
        scene.intersector().all_hits(line, hits);
        if (hits.empty())
            continue;
        met += 1.0;
        sum.crossings += static_cast<double>(hits.size());
        sum.chord += (hits.back().t - hits.front().t) * length(line.direction);
        bool meets_box = false;
        for (const Hit& hit : hits)
            meets_box = meets_box || hit.surface >= first_of_box;
        sum.into_box += meets_box ? 1.0 : 0.0;
    }
    return {sum.crossings / met, sum.into_box / met, sum.chord / met};
}

} // namespace

// A line that meets a convex hull crosses n_int = 2 A_T / A_hull surfaces (G2). Of the lines that meet a convex body,
// those that also meet a convex body in it are as their areas (Santalo). The mean chord of a convex body is 4 V / A
// (Cauchy).
TEST_CASE("lines through a room and a box in it obey the theorems on convex bodies" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {1, 2, 3}, wall).box({0.2, 0.6, 0.5}, {0.7, 1.4, 1.5}, wall);
    const Scene scene = builder.scene(10.0);
    const double room_area = 22.0;
    const double box_area = 2.0 * (0.5 * 0.8 + 0.8 * 1.0 + 0.5 * 1.0);
    for (const Chords chords : {Chords::sphere, Chords::box})
        for (const char* sequence : sequences) {
            CAPTURE(sequence);
            std::vector<double> crossings;
            std::vector<double> into_box;
            std::vector<double> chord;
            for (std::uint64_t seed = 1; seed <= runs; ++seed) {
                const RoomLines found =
                    lines_of_run(scene, 6, GlobalLines(scene.bounds(), chords), *make_sequence(sequence, seed));
                crossings.push_back(found.crossings);
                into_box.push_back(found.into_box);
                chord.push_back(found.chord);
            }
            CHECK(estimate(crossings).agrees_with(2.0 * (room_area + box_area) / room_area));
            CHECK(estimate(into_box).agrees_with(box_area / room_area));
            CHECK(estimate(chord).agrees_with(4.0 * 6.0 / room_area));
        }
}

// A_i F_ij: the share of the rays from i that arrive at j, times A_i; by reciprocity the same from j. Of N lines, each
// that joins the two stands for A_0 / 2 N (G1).
TEST_CASE("rays from either of two unlike rectangles and lines through both find their exchange" *
          doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t black = builder.grey(0.0, 1.0);
    builder.rectangle({0.5, 0, 0}, {0, 0, 0.5}, {0.5, 0, 0}, black).rectangle({0, 0.4, 0}, {2, 0, 0}, {0, 0, 1}, black);
    const Scene scene = builder.scene(10.0);
    const double exchange = exchange_area(scene.surfaces()[0], scene.surfaces()[1], 1e-9);
    for (const char* sequence : sequences) {
        CAPTURE(sequence);
        for (const std::uint32_t from : {0u, 1u}) {
            CAPTURE(from);
            std::vector<double> samples;
            for (std::uint64_t seed = 1; seed <= runs; ++seed) {
                const auto items = make_sequence(sequence, seed);
                double arrived = 0.0;
                for (std::uint64_t n = 0; n < line_count; ++n)
                    arrived +=
                        receiver(scene, from, local_line(scene.patch(from), items->item(n))) == 1 - from ? 1.0 : 0.0;
                samples.push_back(scene.area(from) * arrived / line_count);
            }
            CHECK(estimate(samples).agrees_with(exchange));
        }
        for (const Chords chords : {Chords::sphere, Chords::box}) {
            const GlobalLines lines(scene.bounds(), chords);
            const double worth = 1.0 / lines.expected_crossings(1.0, line_count);
            std::vector<double> samples;
            for (std::uint64_t seed = 1; seed <= runs; ++seed)
                samples.push_back(worth * count_pairs(scene, lines, *make_sequence(sequence, seed), 0, line_count, {1})
                                              .pairs.at(0, 1)
                                              .joined);
            CHECK(estimate(samples).agrees_with(exchange));
        }
    }
}

// A line from the box crosses two walls of the room that fills it: one pair.
TEST_CASE("the crossings of a line make as many pairs as can be chosen among them")
{
    SceneBuilder builder;
    const Scene room = builder.room({0, 0, 0}, {3, 2, 1}, builder.grey(0.5, 1.0)).scene(1.0);
    const GlobalLines lines(room.bounds(), Chords::box);
    CHECK(pairs_along_line(room, lines) == doctest::Approx(1.0));
    CHECK(crossings_per_line(room, lines) == doctest::Approx(2.0));
}

} // namespace integral_geometry_test

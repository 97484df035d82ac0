#include "transport/exchange/pair_counts.h"

#include "base/elementary.h"
#include "test_scenes.h"
#include "transport/lines/line_segments.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <optional>

namespace pair_counts_test {

using namespace multipath;

namespace {

PairCounts counted(const Scene& scene, std::uint64_t lines, std::uint64_t first_item = 0, int threads = 2,
                   Chords chords = Chords::box)
{
    return count_pairs(scene, GlobalLines(scene.bounds(), chords), *make_sequence("random", 3), first_item, lines,
                       {threads});
}

/// Calls visit(line) for the lines that are counted.
template <class Visit>
void for_lines(const Scene& scene, std::uint64_t lines, const Visit& visit)
{
    const GlobalLines chords(scene.bounds(), Chords::box);
    const auto sequence = make_sequence("random", 3);
    for (std::uint64_t n = 0; n < lines; ++n)
        visit(chords.line(sequence->item(n)));
}

bool same(const PairCounts& a, const PairCounts& b)
{
    bool equal = a.pairs.size() == b.pairs.size() && a.escaped == b.escaped && a.behind == b.behind;
    for (std::uint32_t i = 0; equal && i < a.pairs.size(); ++i)
        for (std::uint32_t j = 0; j <= i; ++j)
            equal = equal && a.pairs.at(i, j).joined == b.pairs.at(i, j).joined &&
                    a.pairs.at(i, j).through == b.pairs.at(i, j).through;
    return equal;
}

/// Things that hide each other, a wall seen from both sides and one wall missing: every kind of segment occurs.
Scene obstacles(double patch_size, bool two_sided)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 3}, {4, 0, 0}, grey).rectangle({0, 2, 0}, {4, 0, 0}, {0, 0, 3}, grey);
    builder.rectangle({0, 0, 0}, {0, 2, 0}, {0, 0, 3}, grey).rectangle({0, 0, 0}, {4, 0, 0}, {0, 2, 0}, grey);
    builder.box({1, 0.5, 1}, {2, 1, 2}, grey).triangle({2.5, 0.3, 0.2}, {3.5, 1.5, 0.5}, {2.7, 1.2, 2.9}, grey);
    return builder.scene(patch_size, two_sided);
}

/// Two unit squares at distance 1 that look up and at each other or not; the box around them is the unit cube.
Scene two_squares(bool facing)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    const Vec3 x = {1, 0, 0};
    const Vec3 z = {0, 0, 1};
    builder.rectangle({0, 0, 0}, z, x, grey).rectangle({0, 1, 0}, facing ? x : z, facing ? z : x, grey);
    return builder.scene(10.0);
}

/// Exchange area of two unit squares that face each other at distance 1 (catalogue of view factors, C-11).
double facing_squares()
{
    return (std::log(4.0 / 3.0) + 4.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) - pi) / pi;
}

/// A count of lines for which each is right with the same probability is binomial: within 4 standard deviations.
void check_binomial(std::uint64_t count, double expected, std::uint64_t lines)
{
    CAPTURE(count);
    CAPTURE(expected);
    const double p = expected / static_cast<double>(lines);
    CHECK(std::abs(static_cast<double>(count) - expected) < 4.0 * std::sqrt(expected * (1.0 - p)));
}

} // namespace

TEST_CASE("free lines and lost lines are the segments of every single line")
{
    for (const bool two_sided : {false, true}) {
        CAPTURE(two_sided);
        const Scene scene = obstacles(0.7, two_sided);
        constexpr std::uint64_t lines = 20000; // several blocks of lines
        const PairCounts counts = counted(scene, lines);
        PairCounts expected(scene.patch_count());
        std::vector<Hit> hits;
        std::vector<Segment> segments;
        for_lines(scene, lines, [&](const Line& line) {
            scene.intersector().all_hits(line, hits);
            append_segments(scene, hits, segments);
        });
        for (const Segment& segment : segments) {
            if (segment.joins_patches())
                expected.pairs.at(segment.from, segment.to).joined += 1;
            else
                (segment.from == Segment::behind || segment.to == Segment::behind
                     ? expected.behind
                     : expected.escaped)[std::min(segment.from, segment.to)] += 1;
        }
        int pairs = 0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            for (std::uint32_t j = 0; j <= i; ++j) {
                CHECK(counts.pairs.at(i, j).joined == expected.pairs.at(i, j).joined);
                pairs += counts.pairs.at(i, j).joined > 0 ? 1 : 0;
            }
            CHECK(counts.escaped[i] == expected.escaped[i]);
            CHECK(counts.behind[i] == expected.behind[i]);
        }
        CHECK(pairs > 1000);
    }
}

// Each surface, one patch, is looked for by itself.
TEST_CASE("lines through a pair are those that would join it if there were nothing else")
{
    const Scene scene = obstacles(100.0, false);
    constexpr std::uint64_t lines = 5000;
    const auto count = static_cast<std::uint32_t>(scene.surfaces().size());
    REQUIRE(scene.patch_count() == count);
    std::vector<Intersector> alone;
    for (const Surface& surface : scene.surfaces())
        alone.emplace_back(SurfaceList{surface});
    PairMatrix<std::uint32_t> expected(count);
    for_lines(scene, lines, [&](const Line& line) {
        std::vector<std::optional<Hit>> hits;
        for (const Intersector& intersector : alone)
            hits.push_back(intersector.closest_hit({line.origin - 100.0 * line.direction, line.direction}));
        for (std::uint32_t i = 0; i < count; ++i)
            for (std::uint32_t j = 0; j < count; ++j)
                if (hits[i] && hits[j] && !hits[i]->front && hits[j]->front && hits[i]->t < hits[j]->t)
                    expected.at(i, j) += 1;
    });
    const PairCounts counts = counted(scene, lines);
    std::uint64_t hidden = 0;
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = 0; j <= i; ++j) {
            CHECK(counts.pairs.at(i, j).through == expected.at(i, j));
            CHECK(counts.pairs.at(i, j).joined <= counts.pairs.at(i, j).through);
            hidden += counts.pairs.at(i, j).through - counts.pairs.at(i, j).joined;
        }
    CHECK(hidden > 100);
}

// Every line enters such a room through the back of one wall and ends on the front of another.
TEST_CASE("in a convex closed room every line joins a pair and nothing hides another")
{
    SceneBuilder builder;
    const Scene scene = builder.room({0, 0, 0}, {4, 2, 3}, builder.grey(0.5, 1.0)).scene(1.0);
    const PairCounts counts = counted(scene, 20000);
    std::uint64_t joined = 0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        for (std::uint32_t j = 0; j <= i; ++j) {
            CHECK(counts.pairs.at(i, j).joined == counts.pairs.at(i, j).through);
            if (scene.surface_of(i) == scene.surface_of(j))
                CHECK(counts.pairs.at(i, j).through == 0);
            joined += counts.pairs.at(i, j).joined;
        }
        CHECK(counts.escaped[i] == 0);
        CHECK(counts.behind[i] == 0);
    }
    CHECK(joined == 20000);
}

// (G1) for pairs: a line leaves the front of i in one of its directions and reaches that of j with the density that
// G_ij integrates, so that expected_crossings of an area of G_ij join them.
TEST_CASE("the lines through two facing squares are as many as their exchange says")
{
    constexpr std::uint64_t lines = 200000;
    for (const Chords chords : {Chords::box, Chords::sphere}) {
        CAPTURE(static_cast<int>(chords));
        const Scene scene = two_squares(true);
        const PairCounts counts = counted(scene, lines, 0, 2, chords);
        const GlobalLines global(scene.bounds(), chords);
        check_binomial(counts.pairs.at(0, 1).through, global.expected_crossings(facing_squares(), lines), lines);
        CHECK(counts.pairs.at(0, 1).joined == counts.pairs.at(0, 1).through);
        for (const std::uint32_t square : {0u, 1u})
            check_binomial(counts.escaped[square], global.expected_crossings(1.0 - facing_squares(), lines), lines);
    }
}

TEST_CASE("a thing seen from behind takes lines and is no partner")
{
    constexpr std::uint64_t lines = 200000;
    const Scene scene = two_squares(false); // both look up
    const GlobalLines global(scene.bounds(), Chords::box);
    const PairCounts counts = counted(scene, lines);
    CHECK(counts.pairs.at(0, 1).through == 0);
    check_binomial(counts.behind[0], global.expected_crossings(facing_squares(), lines), lines);
    check_binomial(counts.escaped[0], global.expected_crossings(1.0 - facing_squares(), lines), lines);
    CHECK(counts.behind[1] == 0);
    check_binomial(counts.escaped[1], global.expected_crossings(1.0, lines), lines);
}

// Through the opening of a cube without its ceiling the floor loses what it would exchange with the ceiling, and a wall
// the fourth part of the rest.
// Of k sheets that look up, a line that crosses all meets k (k - 1) / 2 pairs if they have fronts and backs; blocks of
// such lines are short, and long lines are counted apart.
TEST_CASE("the pairs along a line through a hundred sheets are all counted, by any number of threads")
{
    constexpr std::uint32_t sheets = 100;
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    for (std::uint32_t k = 0; k < sheets; ++k)
        builder.rectangle({0, 1e-4 * k, 0}, {0, 0, 1}, {1, 0, 0}, grey);
    const Scene scene = builder.scene(10.0, true);
    constexpr std::uint64_t lines = 3000;
    const PairCounts counts = counted(scene, lines, 0, 1);
    PairCounts expected(scene.patch_count());
    std::vector<Hit> hits;
    for_lines(scene, lines, [&](const Line& line) {
        scene.intersector().all_hits(line, hits);
        for (std::size_t a = 0; a < hits.size(); ++a)
            for (std::size_t b = a + 1; b < hits.size(); ++b) {
                PairCount& pair =
                    expected.pairs.at(passage_at(scene, hits[a]).leaves, passage_at(scene, hits[b]).arrives_at);
                pair.through += 1;
                pair.joined += b == a + 1 ? 1 : 0;
            }
        if (!hits.empty()) {
            expected.escaped[passage_at(scene, hits.front()).arrives_at] += 1;
            expected.escaped[passage_at(scene, hits.back()).leaves] += 1;
        }
    });
    CHECK(same(counts, expected));
    CHECK(same(counts, counted(scene, lines, 0, 3)));
}

TEST_CASE("lines escape through a missing wall")
{
    constexpr std::uint64_t lines = 200000;
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    SceneFile file = builder.room({0, 0, 0}, {1, 1, 1}, grey).file();
    file.surfaces.erase(file.surfaces.begin() + 1);
    file.material.pop_back();
    file.group.pop_back();
    file.line.pop_back();
    const Scene scene(file, 10.0);
    const GlobalLines global(scene.bounds(), Chords::box);
    const PairCounts counts = counted(scene, lines);
    check_binomial(counts.escaped[0], global.expected_crossings(facing_squares(), lines), lines);
    for (std::uint32_t wall = 1; wall < 5; ++wall)
        check_binomial(counts.escaped[wall], global.expected_crossings(0.25 * (1.0 - facing_squares()), lines), lines);
}

TEST_CASE("the counts of two parts of the lines add up to those of all")
{
    const Scene scene = obstacles(0.7, true);
    const PairCounts all = counted(scene, 20000);
    const PairCounts first = counted(scene, 6789);
    PairCounts sum = counted(scene, 20000 - 6789, 6789);
    sum += first;
    CHECK(same(sum, all));
    CHECK_FALSE(same(first, all));
}

TEST_CASE("every number of threads counts the same, and tells how many lines it has done")
{
    const Scene scene = obstacles(0.7, false);
    const PairCounts one = counted(scene, 20000, 0, 1);
    CHECK(same(counted(scene, 20000, 0, 2), one));
    CHECK(same(counted(scene, 20000, 0, 7), one));
    std::uint64_t done = 0;
    count_pairs(scene, GlobalLines(scene.bounds()), *make_sequence("random", 3), 0, 20000,
                {2, [&](std::uint64_t lines) { done += lines; }});
    CHECK(done == 20000);
}

} // namespace pair_counts_test

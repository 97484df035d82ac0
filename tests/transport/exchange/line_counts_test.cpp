#include "transport/exchange/line_counts.h"

#include "paused_work.h"
#include "sampling/random.h"
#include "test_scenes.h"
#include "transport/lines/global_lines.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <map>
#include <utility>

namespace line_counts_test {

using namespace multipath;

namespace {

/// Everything that the counts say.
struct Contents
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> joined;
    std::vector<std::uint64_t> escaped;
    std::vector<std::uint64_t> behind;

    bool operator==(const Contents& b) const
    {
        return joined == b.joined && escaped == b.escaped && behind == b.behind;
    }
};

Contents contents(const LineCounts& counts)
{
    Contents result;
    for (std::uint32_t i = 0; i < counts.size(); ++i) {
        for (const std::uint32_t j : counts.row(i))
            ++result.joined[{i, j}];
        result.escaped.push_back(counts.escaped(i));
        result.behind.push_back(counts.behind(i));
    }
    return result;
}

/// An open room with a box and a sheet in it, so that lines escape and meet backs.
Scene open_room(double patch_size)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey);
    builder.rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, grey);
    builder.rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, grey);
    builder.rectangle({0.1, 0.5, 0.1}, {0.4, 0, 0}, {0, 0.1, 0.4}, grey);
    builder.box({0.5, 0.0, 0.5}, {0.8, 0.3, 0.9}, grey);
    return builder.scene(patch_size);
}

std::vector<Segment> segments_of(const Scene& scene, std::uint64_t first, std::uint64_t lines)
{
    const GlobalLines global_lines(scene.bounds(), Chords::box);
    const std::unique_ptr<Sequence> sequence = make_sequence("sobol", 0);
    std::vector<Segment> segments;
    std::vector<Hit> hits;
    for (std::uint64_t n = first; n < first + lines; ++n) {
        scene.intersector().all_hits(global_lines.line(sequence->item(n)), hits);
        append_segments(scene, hits, segments);
    }
    return segments;
}

LineCounts counted(const Scene& scene, std::uint64_t first, std::uint64_t lines, int threads)
{
    const std::vector<Segment> segments = segments_of(scene, first, lines);
    LineCounts counts(scene.patch_count());
    constexpr std::uint64_t segments_at_a_time = 1000;
    const Blocks blocks = {segments.size(), segments_at_a_time};
    parallel_blocks(blocks.count(), threads, [&](std::uint64_t block) {
        const auto begin = segments.begin() + static_cast<std::ptrdiff_t>(blocks.first(block));
        counts.add(std::vector<Segment>(begin, begin + static_cast<std::ptrdiff_t>(blocks.length(block))));
    });
    counts.merge(threads);
    return counts;
}

constexpr std::uint64_t lines = 1u << 16;

/// An uneven number of rays for each patch, none for some.
Allotment some_rays(const Scene& scene)
{
    std::vector<double> expected;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        expected.push_back(i % 7 == 3 ? 0.0 : 100.3 + i % 5);
    return {expected, 0.3};
}

/// Counts of the rays of some blocks, and how many blocks there were.
struct RayCounts
{
    LineCounts counts;
    ShardRange range;
};

RayCounts ray_counts(const Scene& scene, Shard shard, int threads, Checkpoint* checkpoint = nullptr)
{
    const Allotment rays = some_rays(scene);
    RayCounts result{LineCounts(scene.patch_count()), ShardRange::of(ray_blocks(rays).count(), shard)};
    count_rays(scene, rays, *make_sequence("sobol", 0), 1000, result.range, {threads, {}, checkpoint}, result.counts);
    return result;
}

} // namespace

TEST_CASE("counts are those of a plain list of all segments, for any number of threads")
{
    const Scene scene = open_room(0.05);
    Contents expected;
    expected.escaped.resize(scene.patch_count());
    expected.behind.resize(scene.patch_count());
    const auto note = [&](std::uint32_t patch, std::uint32_t end) {
        if (!Segment::is_patch(patch))
            return;
        if (Segment::is_patch(end))
            ++expected.joined[{patch, end}];
        else
            ++(end == Segment::outside ? expected.escaped : expected.behind)[patch];
    };
    for (const Segment& segment : segments_of(scene, 0, lines)) {
        note(segment.from, segment.to);
        note(segment.to, segment.from);
    }
    REQUIRE(*std::max_element(expected.escaped.begin(), expected.escaped.end()) > 0);
    REQUIRE(*std::max_element(expected.behind.begin(), expected.behind.end()) > 0);
    for (const int threads : {1, 2, 7}) {
        CAPTURE(threads);
        CHECK(contents(counted(scene, 0, lines, threads)) == expected);
    }
}

TEST_CASE("counts of parts of the lines add up to the counts of all")
{
    const Scene scene = open_room(0.05);
    LineCounts sum = counted(scene, lines / 3, lines - lines / 3, 2);
    sum.add(counted(scene, 0, lines / 3, 1), 2);
    CHECK(contents(sum) == contents(counted(scene, 0, lines, 2)));
}

// The oracle: rays cast one by one.
TEST_CASE("the rays of an allotment are counted at both ends, for any number of threads and shards")
{
    const Scene scene = open_room(0.05);
    const Allotment rays = some_rays(scene);
    const std::unique_ptr<Sequence> sequence = make_sequence("sobol", 0);
    LineCounts expected(scene.patch_count());
    std::vector<Segment> segments;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        for (std::uint64_t ray = rays.first_ray(i); ray < rays.first_ray(i + 1); ++ray) {
            const Line line = local_line(scene.patch(i), sequence->item(1000 + ray));
            segments.push_back({i, receiver(scene, scene.surface_of(i), line)});
        }
    REQUIRE(segments.size() > 3 * 4096);
    expected.add(segments);
    expected.merge(1);
    for (const int threads : {1, 2, 7}) {
        CAPTURE(threads);
        CHECK(contents(ray_counts(scene, {}, threads).counts) == contents(expected));
    }
    LineCounts sum(scene.patch_count());
    for (const std::uint64_t number : {2u, 0u, 1u})
        sum.add(ray_counts(scene, {number, 3}, 2).counts, 1);
    CHECK(contents(sum) == contents(expected));
}

TEST_CASE("counting that is stopped has the counts of the blocks that it tells")
{
    const Scene scene = open_room(0.05);
    const std::uint64_t blocks = ray_blocks(some_rays(scene)).count();
    TestCheckpoint stop(3);
    RayCounts part = ray_counts(scene, {}, 1, &stop);
    REQUIRE(part.range.next > 0);
    REQUIRE(part.range.next < blocks);
    ShardRange rest = part.range;
    LineCounts counts(scene.patch_count());
    count_rays(scene, some_rays(scene), *make_sequence("sobol", 0), 1000, rest, {2}, counts);
    counts.add(std::move(part.counts), 1);
    CHECK(contents(counts) == contents(ray_counts(scene, {}, 2).counts));
}

TEST_CASE("keys of any width are sorted, few and many")
{
    for (const int bits : {1, 11, 12, 33, 63})
        for (const std::size_t count : {0u, 1u, 300u, 700u, 20000u}) {
            CAPTURE(bits);
            CAPTURE(count);
            std::vector<std::uint64_t> keys;
            for (std::uint64_t k = 0; k < count; ++k)
                keys.push_back(random_bits(17, k) & ((std::uint64_t{1} << bits) - 1));
            std::vector<std::uint64_t> expected = keys;
            std::sort(expected.begin(), expected.end());
            sort_keys(keys, bits);
            CHECK(keys == expected);
        }
}

} // namespace line_counts_test

#include "transport/exchange/line_counts.h"

#include "paused_work.h"
#include "sampling/random.h"
#include "test_scenes.h"

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
        for (const CountEntry& entry : counts.row(i))
            result.joined[{i, entry.patch}] = entry.count;
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

CountedLines counted(const Scene& scene, std::uint64_t first, std::uint64_t lines, int threads,
                     std::size_t byte_limit = std::size_t{1} << 30)
{
    return count_lines(scene, GlobalLines(scene.bounds(), Chords::box), *make_sequence("sobol", 0), first, lines,
                       byte_limit, {threads});
}

constexpr std::uint64_t lines = 1u << 18; // more than one round between merges

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
        const CountedLines result = counted(scene, 0, lines, threads);
        CHECK(result.lines_cast == lines);
        CHECK(contents(result.counts) == expected);
    }
}

TEST_CASE("counts of parts of the lines add up to the counts of all")
{
    const Scene scene = open_room(0.05);
    LineCounts sum = counted(scene, lines / 3, lines - lines / 3, 2).counts;
    sum.add(counted(scene, 0, lines / 3, 1).counts, 2);
    const LineCounts all = counted(scene, 0, lines, 2).counts;
    CHECK(contents(sum) == contents(all));
    CHECK(sum.line_ends() == all.line_ends());
}

TEST_CASE("counting ends when the memory is full, at the same line for any number of threads")
{
    const Scene scene = open_room(0.01); // 25,000 patches: most pairs are new
    constexpr std::size_t limit = 5u << 20;
    const CountedLines one = counted(scene, 0, 1u << 22, 1, limit);
    const CountedLines two = counted(scene, 0, 1u << 22, 2, limit);
    CHECK(one.counts.full());
    CHECK(one.lines_cast < 1u << 22);
    CHECK(one.counts.bytes() <= limit);
    CHECK(two.lines_cast == one.lines_cast);
    CHECK(contents(two.counts) == contents(one.counts));
    CHECK_FALSE(counted(scene, 0, 4096, 1).counts.full());
}

TEST_CASE("counting that is stopped has the counts of the lines that it tells")
{
    const Scene scene = open_room(0.05);
    for (const int pause : {0, 3, 10}) {
        TestCheckpoint stop(pause);
        const CountedLines part =
            count_lines(scene, GlobalLines(scene.bounds(), Chords::box), *make_sequence("sobol", 0), 0, lines,
                        std::size_t{1} << 30, {1, {}, &stop});
        CAPTURE(part.lines_cast);
        REQUIRE(part.lines_cast > 0);
        REQUIRE(part.lines_cast < lines);
        CHECK(contents(part.counts) == contents(counted(scene, 0, part.lines_cast, 1).counts));
    }
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

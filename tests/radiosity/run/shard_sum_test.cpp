#include "radiosity/run/shard_sum.h"

#include "paused_work.h"
#include "radiosity/reuse/line_reuse.h"
#include "radiosity/run/memory_estimate.h"
#include "radiosity/run/replicates.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace shard_sum_test {

using namespace multipath;

namespace {

constexpr std::uint64_t share_count = 3;

Scene room()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.room({0, 0, 0}, {2, 2, 2}, {grey, builder.grey(0.5, 2.0), grey, grey, grey, grey});
    return builder.box({0.5, 0.2, 0.6}, {1.1, 0.9, 1.2}, builder.material({0.7, 0.3, 0.2}, {})).scene(0.25);
}

/// A room of another shape whose ceiling is open, with a sheet in it: light escapes, and meets the back of the sheet.
Scene open_room()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 3}, {2, 0, 0}, grey).rectangle({0, 0, 0}, {0, 1, 0}, {0, 0, 3}, grey);
    builder.rectangle({0, 0, 0}, {2, 0, 0}, {0, 1, 0}, grey).rectangle({0, 0, 3}, {0, 1, 0}, {2, 0, 0}, grey);
    builder.rectangle({2, 0, 0}, {0, 0, 3}, {0, 1, 0}, builder.grey(0.2, 2.0));
    return builder.rectangle({0.5, 0.3, 0.4}, {0.9, 0, 0}, {0, 0.2, 1.1}, builder.material({0.7, 0.3, 0.2}, {}))
        .scene(0.4);
}

std::unique_ptr<TestCheckpoint> checkpoint_from(const std::optional<SavedWork>& work)
{
    return work ? std::make_unique<TestCheckpoint>(-1, *work) : std::make_unique<TestCheckpoint>(-1);
}

Solution solved(const Scene& scene, const SolveOptions& options, TestCheckpoint& checkpoint, Shard shard = {})
{
    return solve_incrementally(
        scene, options, 1, [](double) {}, &checkpoint, shard);
}

/// Sum of what the shards of the next stage publish.
SavedWork next_stage(const Scene& scene, const SolveOptions& options, const std::optional<SavedWork>& work)
{
    std::vector<SavedWork> shares;
    for (std::uint64_t number = 0; number < share_count; ++number) {
        const auto checkpoint = checkpoint_from(work);
        solved(scene, options, *checkpoint, {number, share_count});
        REQUIRE(!checkpoint->finished());
        shares.push_back(checkpoint->saved());
    }
    std::vector<std::unique_ptr<StateReader>> readers;
    std::vector<Archive*> archives;
    for (const SavedWork& share : shares) {
        readers.push_back(std::make_unique<StateReader>("share", share.bytes));
        archives.push_back(readers.back().get());
    }
    SavedWork all{"", shares[0].parts};
    StateWriter sum([&](std::string_view bytes) { all.bytes += bytes; });
    add_up_shards(archives, all.parts, scene.patch_count(), 1, sum);
    readers[0]->copy_rest(sum);
    sum.finish();
    return all;
}

} // namespace

TEST_CASE("shares of a run add up to the bits of one run, after each stage that is shared")
{
    bool open = false;
    SUBCASE("in a room") {}
    SUBCASE("where light is lost")
    {
        open = true;
    }
    const Scene scene = open ? open_room() : room();
    SolveOptions options;
    options.method = Method::reuse;
    options.sequence = "sobol";
    options.lines = 40000;
    int stages = 2; // lines are counted, then pairs are looked at closer
    SUBCASE("with a table of pairs") {}
    SUBCASE("with rays alone")
    {
        options.memory = run_bytes(static_cast<double>(scene.surfaces().size()), scene.patch_count()) +
                         0.999 * reuse_bytes(scene); // no table
        stages = 1;
    }
    TestCheckpoint alone(-1);
    const Solution whole = solved(scene, options, alone);
    CHECK((mean(whole.balance.escaped) > 0.0) == open);
    CHECK((mean(whole.balance.behind) > 0.0) == open);
    std::optional<SavedWork> work;
    for (int stage = 0; stage < stages; ++stage) {
        CAPTURE(stage);
        work = next_stage(scene, options, work);
        const auto rest = checkpoint_from(work);
        CHECK(solved(scene, options, *rest).radiosity == whole.radiosity);
        CHECK(rest->finished());
    }
}

} // namespace shard_sum_test

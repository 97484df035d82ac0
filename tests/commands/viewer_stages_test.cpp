#include "commands/viewer_stages.h"

#include "test_scenes.h"

#include <algorithm>
#include <doctest/doctest.h>

namespace viewer_stages_test {

using namespace multipath;

TEST_CASE("stages go from 2^8 lines in steps of four to below the lines asked for")
{
    CHECK(stage_lines(1u << 14, 1000) == std::vector<std::uint64_t>{256, 1024, 4096});
    CHECK(stage_lines((1u << 14) + 1, 1000) == std::vector<std::uint64_t>{256, 1024, 4096, 16384});
    CHECK(stage_lines(256, 1000).empty());
    CHECK(stage_lines(1, 1).empty());
}

TEST_CASE("a page of many patches has fewer stages, and one of very many none")
{
    CHECK(stage_lines(std::uint64_t{1} << 40, 300001).empty());
    for (const std::uint32_t patches : {1u, 1000u, 100000u, 300000u}) {
        const std::vector<std::uint64_t> lines = stage_lines(std::uint64_t{1} << 40, patches);
        REQUIRE(!lines.empty());
        CHECK(lines.size() * patches <= 300000);
        CHECK(lines.front() == 256);
        CHECK(lines.back() < std::uint64_t{1} << 40);
    }
}

TEST_CASE("a stage is what solve gives for its lines, and one that cannot be is left out")
{
    SceneBuilder builder;
    const Scene scene =
        builder.room({0, 0, 0}, {2, 1, 1}, {builder.grey(0.5, 0), builder.grey(0.5, 1), 0, 0, 0, 0}).scene(0.5);
    SolveOptions options;
    options.method = Method::first_shot;
    double last = 0.0;
    const auto rises = [&](double done) {
        CHECK(done >= last);
        last = done;
    };
    const std::vector<ViewerStage> stages = solve_stages(scene, options, {256, 1024}, rises);
    REQUIRE(stages.size() == 2);
    CHECK(last <= 1.0 + 1e-12);
    CHECK(stages[1].lines == 1024);
    options.lines = 1024;
    CHECK(stages[1].radiosity == solve(scene, options, [](double) {}).radiosity);

    // The source has 2 W: at 1/500 W each it takes 1000 rays, more than 256 lines.
    options.power_by_line = 1.0 / 500.0;
    const std::vector<ViewerStage> some = solve_stages(scene, options, {256, 4096}, [](double) {});
    REQUIRE(some.size() == 1);
    CHECK(some[0].lines == 4096);
}

} // namespace viewer_stages_test

#include "commands/solve/solution_page.h"

#include "test_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace solution_page_test {

using namespace multipath;

namespace {

Scene lit_room()
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.6, 0.0);
    const std::uint32_t lamp = builder.grey(0.5, 3.0);
    return builder.room({0, 0, 0}, {2, 1, 3}, {wall, lamp, wall, wall, wall, wall}).scene(0.5);
}

std::vector<StageTrace> trace(const Scene& scene, Method method, std::uint64_t lines)
{
    SolveOptions options;
    options.method = method;
    options.lines = lines;
    return viewer_chapters(scene, options);
}

/// True if the point lies on the patch, a rectangle.
bool lies_on(const Scene& scene, std::uint32_t patch, Vec3 point)
{
    const Surface shape = scene.patch(patch).shape;
    const Vec3 from = point - shape.origin;
    const double u = dot(from, shape.edge_u) / dot(shape.edge_u, shape.edge_u);
    const double v = dot(from, shape.edge_v) / dot(shape.edge_v, shape.edge_v);
    const double off = std::abs(dot(from, shape.normal()));
    return off < 1e-9 && std::min(u, v) > -1e-9 && std::max(u, v) < 1.0 + 1e-9; // rounding
}

} // namespace

TEST_CASE("power goes along its segment of a traced line, from a patch at one end to the patch at the other")
{
    const Scene scene = lit_room();
    for (const Method method : all_methods()) {
        std::size_t transfers = 0;
        for (const StageTrace& chapter : trace(scene, method, 1u << 16)) {
            CHECK(chapter.lines.size() == 100);
            for (const TracedLine& line : chapter.lines)
                for (const Transfer& transfer : line.transfers) {
                    CHECK(line.joins.at(transfer.segment) == Segment::is_patch(transfer.to));
                    if (!Segment::is_patch(transfer.to))
                        continue;
                    const Vec3 begin = line.points.at(transfer.segment);
                    const Vec3 far = line.points.at(transfer.segment + 1);
                    const bool forwards = lies_on(scene, transfer.from, begin);
                    CHECK(lies_on(scene, transfer.from, forwards ? begin : far));
                    // A walk brings light back along its whole path.
                    const Vec3 end = method == Method::gathering ? line.points.front() : forwards ? far : begin;
                    CHECK(lies_on(scene, transfer.to, end));
                    ++transfers;
                }
        }
        CHECK(transfers > 50);
    }
}

TEST_CASE("each method has its chapters, the lines of reuse being those of the extended walk")
{
    const Scene scene = lit_room();
    CHECK(trace(scene, Method::local, 4096).size() == 1);
    CHECK(trace(scene, Method::global, 4096).size() == 1);
    CHECK(trace(scene, Method::extended, 4096).size() == 2);
    const std::vector<StageTrace> reuse = trace(scene, Method::reuse, 4096);
    REQUIRE(reuse.size() == 2);
    CHECK(reuse[1].title == "Lines of the global pass");
    CHECK(reuse[1].context.back().find("--method extended") != std::string::npos);
    CHECK(reuse[1].lines[7].points[1] == trace(scene, Method::extended, 4096)[1].lines[7].points[1]);
}

TEST_CASE("a run with few lines has shorter traces")
{
    const Scene scene = lit_room();
    const std::vector<StageTrace> chapters = trace(scene, Method::global, 20);
    REQUIRE(chapters.size() == 1);
    CHECK(chapters[0].lines.size() == 10);
}

} // namespace solution_page_test

#include "explain/line_trace.h"

#include "base/errors.h"
#include "scene/scene_builder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <vector>

namespace bundle_trace_test {

using namespace multipath;

namespace {

/// A closed room with a block and a lamp.
Scene room()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.6, 0.0);
    const std::uint32_t lamp = builder.grey(0.2, 9.0);
    builder.room({0, 0, 0}, {3, 1, 2}, grey).box({0.5, 0.2, 0.5}, {1.1, 0.6, 1.0}, grey);
    builder.rectangle({1.8, 0.9, 0.8}, {0.4, 0, 0}, {0, 0, 0.4}, lamp); // looks down
    return builder.scene(0.5);
}

SolveOptions run(std::uint64_t lines)
{
    SolveOptions options;
    options.method = Method::transillumination;
    options.lines = lines;
    return options;
}

} // namespace

TEST_CASE("the lines of a bundle are parallel, and cross surfaces in proportion to their areas across them")
{
    const Scene scene = room();
    SolveOptions options = run(1u << 16);
    options.bundle = 2048;
    const BundleTrace first = trace_bundle(scene, options, {0, 1});
    const BundleTrace trace = trace_bundle(scene, options, {0, first.lines_cast});
    REQUIRE(trace.lines.size() == trace.lines_cast);
    CHECK(std::abs(length(trace.direction) - 1.0) < 1e-12);
    double crossed = 0.0; // [m^2] as the lines tell
    for (const GlobalLine& line : trace.lines) {
        CHECK(length(cross(line.to - line.from, trace.direction)) < 1e-12);
        crossed += static_cast<double>(line.crossings.size()) * trace.section;
        CHECK((line.crossings.empty() || dot(line.to - line.crossings.back().point, trace.direction) > 0.0));
    }
    double across = 0.0;
    for (const Surface& surface : scene.surfaces())
        across += surface.area() * std::abs(dot(surface.normal(), trace.direction));
    CHECK(crossed == doctest::Approx(across).epsilon(0.02));
}

TEST_CASE("along a line of a bundle two patches exchange power, each the same along every line")
{
    const Scene scene = room();
    SolveOptions options = run(1u << 14);
    options.bundle = 256;
    const BundleTrace trace = trace_bundle(scene, options, {0, 200});
    std::map<std::uint32_t, double> sent; // [W] by each patch
    std::size_t exchanges = 0;
    for (const GlobalLine& line : trace.lines)
        for (const TracedSegment& traced : line.segments) {
            REQUIRE(traced.transfers.size() == (traced.segment.joins_patches() ? 2 : 1));
            exchanges += traced.segment.joins_patches() ? 1 : 0;
            for (const Transfer& transfer : traced.transfers) {
                CHECK(transfer.held == Rgb{});
                const auto known = sent.emplace(transfer.from, transfer.sent().g).first;
                CHECK(known->second == transfer.sent().g);
            }
        }
    CHECK(exchanges > 100);
    CHECK(sent.size() > 20);
}

TEST_CASE("lines that the direction does not have are refused")
{
    const Scene scene = room();
    const BundleTrace trace = trace_bundle(scene, run(1u << 12), {0, 1});
    CHECK_NOTHROW(trace_bundle(scene, run(1u << 12), {trace.lines_cast - 1, 1}));
    CHECK_THROWS_AS(trace_bundle(scene, run(1u << 12), {trace.lines_cast, 1}), SettingsError);
}

} // namespace bundle_trace_test

#include "explain/stage_trace.h"

#include "base/errors.h"
#include "radiosity/family/transillumination.h"
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
    const StageTrace first = trace_bundle(scene, options, {0, 1});
    const StageTrace trace = trace_bundle(scene, options, {0, first.count});
    REQUIRE(trace.lines.size() == trace.count);
    const Bundle bundle(scene.bounds(), trace.lines.front().origin.numbers, *options.bundle);
    CHECK(std::abs(length(bundle.direction()) - 1.0) < 1e-12);
    // [m^2] per line: the lines traced share the same rectangle, but are not quite as many
    const double section = bundle.section() * static_cast<double>(bundle.count()) / static_cast<double>(trace.count);
    double crossed = 0.0; // [m^2] as the lines tell
    for (const TracedLine& line : trace.lines) {
        const Vec3 end = line.points.back();
        CHECK(length(cross(end - line.points.front(), bundle.direction())) < 1e-12);
        crossed += static_cast<double>(line.crossings.size()) * section;
        CHECK((line.crossings.empty() || dot(end - line.crossings.back().point, bundle.direction()) > 0.0));
    }
    double across = 0.0;
    for (const Surface& surface : scene.surfaces())
        across += surface.area() * std::abs(dot(surface.normal(), bundle.direction()));
    CHECK(crossed == doctest::Approx(across).epsilon(0.02));
}

TEST_CASE("along a line of a bundle two patches exchange power, each the same along every line")
{
    const Scene scene = room();
    SolveOptions options = run(1u << 14);
    options.bundle = 256;
    const StageTrace trace = trace_bundle(scene, options, {0, 200});
    std::map<std::uint32_t, double> sent; // [W] by each patch
    std::size_t exchanges = 0;
    for (const TracedLine& line : trace.lines) {
        std::vector<int> transfers(line.joins.size()); // per segment
        for (const Transfer& transfer : line.transfers) {
            ++transfers.at(transfer.segment);
            CHECK(transfer.held == Rgb{});
            const auto known = sent.emplace(transfer.from, transfer.sent().g).first;
            CHECK(known->second == transfer.sent().g);
        }
        for (std::size_t k = 0; k < transfers.size(); ++k) {
            CHECK((transfers[k] == 2) == line.joins[k]);
            exchanges += line.joins[k] ? 1 : 0;
        }
    }
    CHECK(exchanges > 100);
    CHECK(sent.size() > 20);
}

TEST_CASE("lines that the direction does not have are refused")
{
    const Scene scene = room();
    const StageTrace trace = trace_bundle(scene, run(1u << 12), {0, 1});
    CHECK_NOTHROW(trace_bundle(scene, run(1u << 12), {trace.count - 1, 1}));
    CHECK_THROWS_AS(trace_bundle(scene, run(1u << 12), {trace.count, 1}), SettingsError);
}

} // namespace bundle_trace_test

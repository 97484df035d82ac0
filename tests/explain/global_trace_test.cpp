#include "explain/stage_trace.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "radiosity/paper/first_shot.h"
#include "radiosity/run/run.h"
#include "radiosity/run/solve.h"
#include "test_scenes.h"

#include <doctest/doctest.h>
#include <string>

namespace global_trace_test {

using namespace multipath;

namespace {

/// A room with a box on its floor and coloured walls: lines meet two to four surfaces, some of them at one place.
Scene furnished_room(bool two_sided = false)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.6, 0.0);
    const std::uint32_t red = builder.material({0.8, 0.2, 0.1}, {});
    const std::uint32_t lamp = builder.material({0.5, 0.5, 0.5}, {3.0, 2.0, 1.0});
    builder.room({0, 0, 0}, {2, 1, 3}, {grey, lamp, red, grey, grey, red});
    builder.box({0.5, 0, 0.5}, {1, 0.5, 1.5}, red);
    return builder.scene(0.5, two_sided);
}

/// A floor below a lamp, open on all sides.
Scene open_scene()
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.7, 0.0));
    builder.rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.2, 1.0));
    return builder.scene(0.25);
}

SolveOptions short_run(Method method)
{
    SolveOptions options;
    options.method = method;
    options.lines = 600;
    options.sequence = "random";
    options.skip = 2;
    return options;
}

StageTrace tell_all(const Scene& scene, const SolveOptions& options)
{
    const std::uint64_t cast = trace_global_pass(scene, options, {0, 1}).count;
    return trace_global_pass(scene, options, {0, cast});
}

/// Solves by what is told: what the transfers bring, added up in their order to what the first stage brought.
std::vector<Rgb> radiosity_told(const Scene& scene, const SolveOptions& options, const StageTrace& trace)
{
    Run solver(scene, options);
    shoot_first(solver);
    PowerState& state = solver.state;
    std::vector<Rgb> received(scene.patch_count());
    for (const TracedLine& line : trace.lines)
        for (const Transfer& transfer : line.transfers)
            if (Segment::is_patch(transfer.to))
                received[transfer.to] += transfer.sent();
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        state.incident[i] += received[i];
    return radiosity(scene, state);
}

/// True if the first paragraph about the stage has these words.
bool says(const StageTrace& trace, const std::string& words)
{
    return trace.context.front().find(words) != std::string::npos;
}

Rgb lost(const StageTrace& trace, std::uint32_t where)
{
    Rgb power;
    for (const TracedLine& line : trace.lines)
        for (const Transfer& transfer : line.transfers)
            if (transfer.to == where)
                power += transfer.sent();
    return power;
}

} // namespace

TEST_CASE("the lines told are the box's where the run draws them from the box")
{
    const Scene scene = furnished_room();
    SolveOptions options = short_run(Method::first_shot);
    options.chords = Chords::box;
    const StageTrace trace = tell_all(scene, options);
    const Solution solution = solve(scene, options, [](double) {});
    CHECK(trace.count == solution.global_lines);
    CHECK(trace.lines.size() == solution.global_lines_cast);
    CHECK(radiosity_told(scene, options, trace) == solution.radiosity); // the same sums in the same order
}

// The oracle is the solver. The same powers are added in the same order, so the bits must agree.
TEST_CASE("the powers told for all global lines add up to the solver's radiosity")
{
    for (const Method method : {Method::global, Method::first_shot, Method::extended})
        for (const bool bidirectional : {true, false})
            for (const bool two_sided : {true, false}) {
                CAPTURE(method->name);
                CAPTURE(bidirectional);
                const Scene scene = furnished_room(two_sided);
                SolveOptions options = short_run(method);
                options.bidirectional = bidirectional;
                const StageTrace trace = tell_all(scene, options);
                const Solution solution = solve(scene, options, [](double) {});
                CHECK(says(trace, "with " + grouped(solution.global_lines) + " global lines"));
                CHECK(says(trace, "took " + grouped(solution.local_lines) + " of the lines") ==
                      (method->name != "global"));
                CHECK(trace.lines.size() == solution.global_lines_cast);
                CHECK(radiosity_told(scene, options, trace) == solution.radiosity);
            }
}

// Sums of a few hundred positive numbers in another order than the solver's: 1e-13 is far above their rounding.
TEST_CASE("what is told as lost is what the solver finds to have left the scene or met backs")
{
    const Scene scene = open_scene();
    for (const bool bidirectional : {true, false}) {
        SolveOptions options = short_run(Method::global);
        options.bidirectional = bidirectional;
        const StageTrace trace = tell_all(scene, options);
        const PowerBalance balance = solve(scene, options, [](double) {}).balance;
        CHECK(mean(balance.escaped) > 0.0);
        CHECK(mean(lost(trace, Segment::outside)) == doctest::Approx(mean(balance.escaped)).epsilon(1e-13));
        CHECK(mean(lost(trace, Segment::behind)) == doctest::Approx(mean(balance.behind)).epsilon(1e-13));
    }
}

// All patches are of one size.
TEST_CASE("a source sends all its power in as many forecasts as it is told to send")
{
    const Scene scene = open_scene();
    for (const bool bidirectional : {true, false}) {
        CAPTURE(bidirectional);
        SolveOptions options = short_run(Method::global);
        options.bidirectional = bidirectional;
        const StageTrace trace = tell_all(scene, options);
        const std::string before = "so it can send ";
        const std::size_t begin = trace.context.at(1).find(before);
        REQUIRE(begin != std::string::npos);
        const double times = std::stod(trace.context[1].substr(begin + before.size())); // four digits
        for (const TracedLine& line : trace.lines)
            for (const Transfer& transfer : line.transfers)
                if (const Rgb power = scene.area(transfer.from) * scene.emittance(transfer.from); power != Rgb{})
                    CHECK(times * transfer.forecast.g == doctest::Approx(power.g).epsilon(1e-3));
    }
}

TEST_CASE("what a patch is told to hold after a line is what it is told to hold before its next one")
{
    const Scene scene = furnished_room();
    for (const bool bidirectional : {true, false}) {
        SolveOptions options = short_run(Method::first_shot);
        options.bidirectional = bidirectional;
        std::vector<Rgb> holds(scene.patch_count());
        int compared = 0;
        for (const TracedLine& line : tell_all(scene, options).lines)
            for (std::size_t k = 0; k < line.transfers.size(); ++k) {
                const Transfer& transfer = line.transfers[k];
                CHECK(transfer.held == holds[transfer.from]);
                compared += mean(transfer.held) > 0.0 ? 1 : 0;
                const bool returns = k > 0 && line.transfers[k - 1].segment == transfer.segment;
                const bool is_answered =
                    k + 1 < line.transfers.size() && line.transfers[k + 1].segment == transfer.segment;
                if (is_answered)
                    continue; // both send before they receive
                if (returns)
                    holds[transfer.from] = line.transfers[k - 1].then_held;
                else
                    holds[transfer.from] = {};
                if (Segment::is_patch(transfer.to))
                    holds[transfer.to] = transfer.then_held;
            }
        CHECK(compared > 100);
    }
}

TEST_CASE("a traced segment lies between the two crossings that it names")
{
    for (const bool two_sided : {true, false})
        for (const TracedLine& line : tell_all(furnished_room(two_sided), short_run(Method::global)).lines)
            for (const Transfer& transfer : line.transfers) {
                const std::size_t after = transfer.segment;
                REQUIRE(after <= line.crossings.size());
                const std::uint32_t from = after == 0 ? Segment::outside : line.crossings[after - 1].patches.leaves;
                const std::uint32_t to =
                    after == line.crossings.size() ? Segment::outside : line.crossings[after].patches.arrives_at;
                CHECK(((transfer.from == from && transfer.to == to) || (transfer.from == to && transfer.to == from)));
                CHECK(line.joins[after] == (Segment::is_patch(from) && Segment::is_patch(to)));
            }
}

TEST_CASE("a later line is told with the powers that the lines before it left")
{
    const Scene scene = furnished_room();
    const SolveOptions options = short_run(Method::first_shot);
    const StageTrace from_the_start = trace_global_pass(scene, options, {0, 200});
    const StageTrace late = trace_global_pass(scene, options, {190, 10});
    REQUIRE(late.lines.size() == 10);
    for (std::size_t k = 0; k < 10; ++k) {
        const TracedLine& a = from_the_start.lines[190 + k];
        const TracedLine& b = late.lines[k];
        CHECK(a.origin.number == b.origin.number);
        CHECK(a.origin.item == b.origin.item);
        REQUIRE(a.transfers.size() == b.transfers.size());
        for (std::size_t t = 0; t < a.transfers.size(); ++t)
            CHECK(a.transfers[t].then_held == b.transfers[t].then_held);
    }
}

TEST_CASE("lines that the pass does not cast are refused")
{
    const Scene scene = furnished_room();
    const SolveOptions options = short_run(Method::global);
    const std::uint64_t cast = trace_global_pass(scene, options, {0, 1}).count;
    CHECK(trace_global_pass(scene, options, {cast - 1, 1}).lines.size() == 1);
    CHECK_THROWS_AS(trace_global_pass(scene, options, {cast, 1}), InputError);
    CHECK_THROWS_AS(trace_global_pass(scene, options, {cast - 1, 2}), InputError);
}

} // namespace global_trace_test

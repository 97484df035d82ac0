#include "radiosity/run/run.h"

#include "base/errors.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

namespace run_test {

using namespace multipath;

namespace {

SolveOptions options_of(const std::string& sequence, std::uint64_t lines, std::uint64_t skip)
{
    SolveOptions options;
    options.sequence = sequence;
    options.lines = lines;
    options.skip = skip;
    options.chords = Chords::box; // all lines meet the box: as many are cast
    return options;
}

} // namespace

TEST_CASE("the stages take successive items of the sequence, and none twice")
{
    const Scene scene = coloured_room();
    const SolveOptions options = options_of("sobol", 6000, 10);
    Run run(scene, options);
    CHECK(run.next_item() == 10);
    run.solution.local_lines = 1000;
    run.plan_global_lines();
    CHECK(run.next_item() == 1010);
    CHECK(run.solution.global_lines_cast == 5000);
}

TEST_CASE("a sequence that is too short is refused before it ends")
{
    const Scene scene = coloured_room();
    const auto start = [&](const std::string& sequence, std::uint64_t lines, std::uint64_t skip) {
        const SolveOptions options = options_of(sequence, lines, skip);
        Run run(scene, options);
        run.solution.local_lines = 40;
        run.plan_global_lines();
    };
    CHECK_NOTHROW(start("hammersley:100", 100, 0));
    CHECK_NOTHROW(start("hammersley:100", 99, 1));
    CHECK_THROWS_AS(start("hammersley:100", 101, 0), InputError);
    CHECK_THROWS_AS(start("hammersley:100", 100, 1), InputError);
    CHECK_THROWS_AS(start("hammersley:100", 1, 101), InputError);
    CHECK_THROWS_AS(start("sobol", 2, ~0ull), InputError);
}

} // namespace run_test

#include "selftest/known_scenes.h"

#include "geometry/form_factor/exchange_area.h"
#include "radiosity/run/solve.h"
#include "seeded_runs.h"

#include <doctest/doctest.h>
#include <initializer_list>
#include <map>
#include <vector>

namespace known_scenes_test {

using namespace multipath;

namespace {

std::map<std::string, KnownScene> scenes_by_name()
{
    std::map<std::string, KnownScene> scenes;
    for (const KnownScene& scene : known_scenes())
        scenes[scene.name] = scene;
    return scenes;
}

} // namespace

// The formulas of the known scenes are Howell's; the contour integral of the program is another way to the same
// numbers.
TEST_CASE("the exchange of the known rectangles is that of the contour integral")
{
    const KnownScene known = scenes_by_name()["perpendicular"];
    CHECK(known.answers[0].value ==
          doctest::Approx(exchange_area(known.file.surfaces[0], known.file.surfaces[1], 1e-9)).epsilon(1e-7));
    const KnownScene facing = scenes_by_name()["facing-squares"]; // B_2 = 0.7 F B_1
    const double f = exchange_area(facing.file.surfaces[0], facing.file.surfaces[1], 1e-9);
    CHECK(facing.answers[1].value == doctest::Approx(0.7 * f * facing.answers[0].value).epsilon(1e-7));
    CHECK(facing.answers[0].value == doctest::Approx(2.0 / (1.0 - 0.4 * 0.7 * f * f)).epsilon(1e-7));
}

// B_o (1 - rho_o (1 - F_oi)) = rho_o F_oi B_i and B_i = 3 + rho_i B_o, with F_oi = 6 * 0.16 / 6.
TEST_CASE("the light between nested cubes balances")
{
    const KnownScene nested = scenes_by_name()["nested-cubes"];
    const double outer = nested.answers[0].value;
    const double inner = nested.answers[1].value;
    CHECK(inner == doctest::Approx(3.0 + 0.6 * outer));
    CHECK(outer == doctest::Approx(0.5 * (0.16 * inner + 0.84 * outer)));
}

// Each surface is one patch, and the answers name patches by number.
TEST_CASE("the most accurate method finds every known answer")
{
    for (const KnownScene& known : known_scenes()) {
        const Scene scene(known.file, 1e3);
        CHECK(scene.patch_count() == known.file.surfaces.size());
        SolveOptions options = random_lines(Method::reuse, 1u << 15, 1);
        options.sequence = "sobol-owen";
        const Solution solution = solve(scene, options, silent);
        CAPTURE(known.name);
        CHECK_MESSAGE(mean(solution.balance.behind) == 0.0,
                      "light meets surfaces from behind; turn those that look away");
        for (const KnownAnswer& answer : known.answers) {
            CAPTURE(answer.quantity);
            CHECK(answer.read(scene, solution) == doctest::Approx(answer.value).epsilon(2e-3));
        }
    }
}

} // namespace known_scenes_test

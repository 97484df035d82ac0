#include "radiosity/reuse/gathered_light.h"

#include "scene/obj/obj_reader.h"

#include <doctest/doctest.h>

namespace direct_radiosity_test {

using namespace multipath;

// Two facing unit squares of one patch each, F = 0.199825 (see the scene file): the lamp keeps its emittance of 1,
// since what comes back to it has been reflected twice, and the target gets 0.7 F.
TEST_CASE("direct radiosity is what is emitted and what is reflected once")
{
    const Scene scene(read_obj("scenes/squares.obj"), 1.0);
    const std::vector<Rgb> direct = direct_radiosity(scene, 1);
    REQUIRE(direct.size() == 2);
    CHECK(direct[0].r == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(direct[1].r == doctest::Approx(0.7 * 0.199825).epsilon(1e-4)); // of the quadrature
    CHECK(direct_radiosity(scene, 3) == direct);
}

// In the furnace every wall gets E from the others, so that E + rho E is sent on, to be compared with E / (1 - rho).
TEST_CASE("in the furnace the direct radiosity is E (1 + rho)")
{
    const Scene scene(read_obj("scenes/furnace.obj"), 0.5);
    for (const Rgb& b : direct_radiosity(scene, 2)) {
        CHECK(b.r == doctest::Approx(1.5 * 1.25).epsilon(1e-3)); // of the quadrature, where walls meet
        CHECK(b.g == doctest::Approx(1.0 * 1.5).epsilon(1e-3));
        CHECK(b.b == doctest::Approx(0.5 * 1.75).epsilon(1e-3));
    }
}

} // namespace direct_radiosity_test

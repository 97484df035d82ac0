#include "exam/broken_law.h"

#include "sampling/warp.h"
#include "scene/scene_builder.h"

#include <doctest/doctest.h>

namespace broken_law_test {

using namespace multipath;

namespace {

std::unique_ptr<Sequence> sobol()
{
    return make_sequence("sobol", 0);
}

} // namespace

TEST_CASE("every law has its name")
{
    CHECK(broken_law_named("bidirectional") == BrokenLaw::bidirectional);
    CHECK(broken_law_named("forecast") == BrokenLaw::forecast);
    CHECK(broken_law_named("visibility") == BrokenLaw::visibility);
    CHECK(broken_law_names.size() == 8);
}

TEST_CASE("without a broken law nothing is changed")
{
    for (std::uint64_t n = 0; n < 20; ++n) {
        CHECK(items_of_rays(sobol(), {})->item(n) == sobol()->item(n));
        CHECK(items_of_lines(sobol(), {})->item(n) == sobol()->item(n));
        CHECK(items_of_lines(sobol(), BrokenLaw::reflectance)->item(n) == sobol()->item(n));
    }
}

// Archimedes: evenly over the hemisphere the cosine is uniform, with mean 1/2; Lambert's mean is 2/3.
TEST_CASE("the broken cosine law makes directions even over the hemisphere")
{
    const auto items = items_of_rays(sobol(), BrokenLaw::cosine);
    double sum = 0.0;
    double squares = 0.0;
    for (std::uint64_t n = 0; n < 4096; ++n) {
        const Item item = items->item(n);
        const double cosine = square_to_cosine_hemisphere(item[2], item[3]).z;
        sum += cosine / 4096;
        squares += cosine * cosine / 4096;
    }
    CHECK(sum == doctest::Approx(0.5).epsilon(0.01));
    CHECK(squares == doctest::Approx(1.0 / 3.0).epsilon(0.01));
}

TEST_CASE("the broken laws of lines bend their items")
{
    double starts = 0.0;
    for (std::uint64_t n = 0; n < 1024; ++n) {
        const Item down = items_of_lines(sobol(), BrokenLaw::bidirectional)->item(n);
        CHECK(down[0] <= down[2]);
        const Item second = items_of_lines(sobol(), BrokenLaw::forecast)->item(n);
        CHECK((n % 2 == 0 || (second[0] == second[2] && second[1] == second[3])));
        starts += items_of_lines(sobol(), BrokenLaw::crossings)->item(n)[0] / 1024;
    }
    CHECK(starts == doctest::Approx(1.0 / 3.0).epsilon(0.01)); // the mean of x^2
}

TEST_CASE("the broken laws of scenes dim them and take screens away")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    const std::uint32_t screen = builder.material(screen_material, {0.5, 0.5, 0.5}, {});
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, wall).rectangle({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, screen);
    CHECK(with_law_broken(builder.file(), {}).surfaces.size() == 2);
    const SceneFile open = with_law_broken(builder.file(), BrokenLaw::visibility);
    CHECK(open.surfaces.size() == 1);
    CHECK(open.surfaces[0].origin == Vec3{0, 0, 0});
    CHECK(with_law_broken(builder.file(), BrokenLaw::reflectance).materials[wall].reflectance.g ==
          doctest::Approx(0.45));
}

} // namespace broken_law_test

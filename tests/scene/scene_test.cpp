#include "base/errors.h"
#include "scene/scene.h"

#include "scene/input_problem.h"
#include "test_scenes.h"

#include <cstdint>
#include <doctest/doctest.h>
#include <functional>
#include <set>

namespace scene_test {

using namespace multipath;

TEST_CASE("a scene's patches cover its surfaces on the sides that exist")
{
    SceneBuilder builder;
    const std::uint32_t lamp = builder.material({0.5, 0.4, 0.3}, {3, 2, 1});
    const std::uint32_t wall = builder.grey(0.8, 0.0);
    builder.rectangle({0, 0, 0}, {2, 0, 0}, {0, 0, 1}, lamp).triangle({0, 1, 0}, {2, 1, 0}, {0, 1, 3}, wall);
    for (const bool two_sided : {false, true}) {
        const Scene scene = builder.scene(0.4, two_sided);
        double area = 0.0;
        Rgb power;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            area += scene.area(i);
            power += scene.area(i) * scene.emittance(i);
            CHECK(scene.patch(i).shape.area() == doctest::Approx(scene.area(i)));
        }
        CHECK(area == doctest::Approx(two_sided ? 10.0 : 5.0).epsilon(1e-12));
        CHECK(area == doctest::Approx(scene.total_area()).epsilon(1e-12));
        CHECK(power.r == doctest::Approx(6.0).epsilon(1e-12)); // fronts alone emit
        CHECK(scene.source_power().g == doctest::Approx(4.0));
        CHECK(scene.average_reflectance().r == doctest::Approx((2 * 0.5 + 3 * 0.8) / 5));
        CHECK((scene.patch_at(0, 0.5, 0.5, false) == Scene::no_patch) == !two_sided);
    }
    const Scene scene = builder.scene(0.4, true);
    const std::uint32_t front = scene.patch_at(1, 0.3, 0.2, true);
    const std::uint32_t back = scene.patch_at(1, 0.3, 0.2, false);
    CHECK(dot(scene.patch(front).shape.normal(), scene.patch(back).shape.normal()) == doctest::Approx(-1.0));
    CHECK(length(scene.patch(front).shape.centre() - scene.patch(back).shape.centre()) < 1e-15);
}

TEST_CASE("a scene without light or surfaces is refused")
{
    SceneBuilder dark;
    const std::uint32_t wall = dark.grey(0.5, 0.0);
    CHECK_THROWS_AS(dark.scene(1.0), InputError);
    dark.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, wall);
    CHECK_THROWS_AS(dark.scene(1.0), InputError);
}

TEST_CASE("more patches than fit are refused, and all of them counted")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, builder.grey(0.5, 1.0));
    CHECK(
        contains(problem_of([&] { builder.scene(1e-4, true); }), "gives 3200000000 patches; expected fewer than 2^31"));
}

TEST_CASE("the scene's hash tells what changes the result from what does not")
{
    const auto hash = [](double y, double reflectance, double size, const char* name) {
        SceneBuilder builder;
        SceneFile file = builder.rectangle({0, y, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(reflectance, 1.0)).file();
        file.materials[0].name = name;
        return Scene(file, size).hash();
    };
    CHECK(hash(0.0, 0.5, 1.0, "a") == hash(-0.0, 0.5, 1.0, "b"));
    CHECK(hash(0.0, 0.5, 1.0, "a") != hash(1e-9, 0.5, 1.0, "a"));
    CHECK(hash(0.0, 0.5, 1.0, "a") != hash(0.0, 0.6, 1.0, "a"));
    CHECK(hash(0.0, 0.5, 1.0, "a") != hash(0.0, 0.5, 0.5, "a"));
}

// A run goes on from its state only if the scene is the same.
TEST_CASE("the scene's hash changes with every number of a surface and its material, and with the sides")
{
    SceneBuilder builder;
    const SceneFile file =
        builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, builder.material({0.5, 0.4, 0.3}, {3, 2, 1})).file();
    const auto hash = [&](const std::function<void(SceneFile&)>& change, bool two_sided = false) {
        SceneFile changed = file;
        change(changed);
        return Scene(changed, 0.3, two_sided).hash();
    };
    std::set<std::uint64_t> hashes = {hash([](SceneFile&) {}), hash([](SceneFile&) {}, true)};
    std::size_t count = 2;
    const auto check = [&](const std::function<void(SceneFile&)>& change) {
        hashes.insert(hash(change));
        CHECK(hashes.size() == ++count);
    };
    for (Vec3 Surface::*vector : {&Surface::origin, &Surface::edge_u, &Surface::edge_v})
        for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z})
            check([&](SceneFile& changed) { changed.surfaces[0].*vector.*axis += 0.01; });
    for (Rgb Material::*colour : {&Material::reflectance, &Material::emittance})
        for (double Rgb::*channel : {&Rgb::r, &Rgb::g, &Rgb::b})
            check([&](SceneFile& changed) { changed.materials[0].*colour.*channel += 0.01; });
    check([](SceneFile& changed) { changed.surfaces[0].shape = Shape::triangle; });

    const auto cells = [&](std::uint32_t u, std::uint32_t v) {
        return scene_hash(file, {{Shape::parallelogram, u, v, nullptr}}, false);
    };
    CHECK(cells(4, 4) == hash([](SceneFile&) {}));
    CHECK(cells(4, 5) != cells(4, 4));
    CHECK(cells(5, 4) != cells(4, 4));
    CHECK(cells(5, 4) != cells(4, 5));
}

TEST_CASE("a refined scene has the areas, the cells and the numbers of its trees on both sides")
{
    SceneBuilder builder;
    builder.rectangle({0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, builder.grey(0.5, 0.0));
    builder.triangle({0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, {0.0, 1.0, 1.0}, builder.grey(0.5, 1.0));
    const Scene coarse(builder.file(), 1.5, true, 1);
    REQUIRE(coarse.patch_count() == 2 * 3);
    CHECK(coarse.levels().empty());
    const std::vector<std::uint8_t> levels = {0, 1, 1, 2, 2, 2, 2, 1, 1, 1, 1, 1};
    const Scene scene = coarse.refined(levels);
    CHECK(scene.levels() == levels);
    CHECK(scene.hash() != coarse.hash());
    REQUIRE(scene.patch_count() == 2 * levels.size());
    CHECK(scene.total_area() == coarse.total_area());
    double area = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const Patch patch = scene.patch(i);
        CHECK(scene.area(i) == doctest::Approx(patch.shape.area()).epsilon(1e-14)); // rounding
        const Vec3 centre = patch.shape.centre();
        CHECK(scene.patch_at(patch.surface, centre.x / (patch.surface == 0 ? 2.0 : 1.0), centre.y, scene.is_front(i)) ==
              i);
        area += scene.area(i);
    }
    CHECK(area == doctest::Approx(scene.total_area()).epsilon(1e-14));
    CHECK(scene.refined(std::vector<std::uint8_t>(3, 0)).hash() == coarse.hash());
    for (const std::vector<std::uint8_t>& wrong : std::vector<std::vector<std::uint8_t>>{
             {}, {0, 0}, {0, 0, 0, 0}, {0, 1, 1, 1, 0}, {0, 1, 2, 1, 1, 1, 1, 1, 0}, {200, 0, 0}, {0, 0, 1, 1, 1}})
        CHECK_THROWS_AS(coarse.refined(wrong), std::invalid_argument);
}

} // namespace scene_test

#include "export/mesh/covered_patches.h"

#include "export/mesh/mesh_scenes.h"
#include "export/mesh/patch_mesh.h"
#include "image/camera.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <optional>

namespace covered_patches_test {

using namespace multipath;

namespace {

/// A lamp over what is tested.
SceneBuilder lamp()
{
    SceneBuilder builder;
    return builder.rectangle({0, 5, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.0, 1.0));
}

Vec3 x(double length)
{
    return {length, 0, 0};
}
Vec3 z(double length)
{
    return {0, 0, length};
}

std::size_t count_covered(const Scene& scene)
{
    const std::vector<bool> covered = covered_patches(scene, 2);
    return static_cast<std::size_t>(std::count(covered.begin(), covered.end(), true));
}

/// Does a picture from right above show the patch somewhere, at n x n points of it?
bool is_seen(const Scene& scene, std::uint32_t patch, int n)
{
    const Patch place = scene.patch(patch);
    const Vec3 up = 1e-3 * place.shape.normal();
    VisibleHits visible(scene);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double u = (i + 0.5) / n;
            const double v = (j + 0.5) / n * (place.shape.shape == Shape::triangle ? 1.0 - u : 1.0);
            const std::optional<Hit> hit = visible.first({{place.shape.at(u, v) + up, -up}})[0];
            if (hit && scene.patch_at(hit->surface, hit->u, hit->v, hit->front) == patch)
                return true;
        }
    return false;
}

} // namespace

TEST_CASE("patches under a smaller face are covered, and those that look out from under it are not")
{
    SceneBuilder builder = lamp();
    builder.rectangle({0, 0, 0}, z(4), x(4), 0);             // patches of 1 x 1
    builder.rectangle({0.5, 0, 0.999}, z(2.002), x(2.5), 0); // over 2 x 2 of them, and parts of 10 others
    CHECK(count_covered(builder.scene(1.0)) == 4);
}

TEST_CASE("two triangles cover together what neither covers alone")
{
    SceneBuilder builder = lamp();
    builder.rectangle({0, 0, 0}, z(4), x(4), 0);
    builder.triangle({1, 0, 1}, {1, 0, 3}, {3, 0, 3}, 0).triangle({1, 0, 1}, {3, 0, 3}, {3, 0, 1}, 0);
    CHECK(count_covered(builder.scene(1.0)) == 4);
    CHECK(count_covered(builder.scene(2.0)) == 0); // patches of 2 x 2, a fourth of each covered
}

TEST_CASE("of equal faces one is covered, and of faces that look at each other none")
{
    CHECK(count_covered(lamp().rectangle({0, 0, 0}, z(1), x(1), 0).rectangle({0, 0, 0}, z(1), x(1), 0).scene(2.0)) ==
          1);
    CHECK(count_covered(lamp().rectangle({0, 0, 0}, z(1), x(1), 0).rectangle({0, 0, 0}, x(1), z(1), 0).scene(2.0)) ==
          0);
}

TEST_CASE("a patch is covered if the ray caster shows none of it")
{
    for (const bool two_sided : {false, true})
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            auto random = [&, n = std::uint64_t{0}]() mutable { return bits_to_unit(random_bits(seed, n++)); };
            SceneBuilder builder = lamp();
            for (int k = 0; k < 12; ++k) {
                const Vec3 corner = {3 * random(), 0, 3 * random()};
                const Vec3 a = x(0.2 + 2 * random()) + z(random());
                const Vec3 b = z(0.2 + 2 * random()) - x(random());
                builder.surface({k % 3 == 0 ? Shape::triangle : Shape::parallelogram, corner, k % 4 == 0 ? a : b,
                                 k % 4 == 0 ? b : a},
                                0);
            }
            const Scene scene = builder.scene(0.3, two_sided);
            const std::vector<bool> covered = covered_patches(scene, 1);
            CHECK(std::count(covered.begin(), covered.end(), true) > 5);
            for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
                if (covered[patch])
                    REQUIRE_FALSE(is_seen(scene, patch, 15));
                else if (!is_seen(scene, patch, 15))
                    CHECK(is_seen(scene, patch, 400)); // a narrow strip
            }
        }
}

TEST_CASE("meshes leave covered patches out, and have no cracks around the holes")
{
    SceneBuilder builder = lamp();
    builder.rectangle({0, 0, 0}, z(4), x(4), 0).rectangle({1, 0, 1}, z(2), x(2), 0);
    const Scene scene = builder.scene(1.0);
    const std::vector<Rgb> values = some_values(scene);
    const PatchMesh mesh = patch_mesh(scene, flat_corners(values), {});
    CHECK(mesh.faces.size() == scene.patch_count() - 4);
    for (const MeshFace& face : mesh.faces)
        CHECK(is_seen(scene, face.patch, 1));
}

} // namespace covered_patches_test

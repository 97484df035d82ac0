#include "export/mesh/patch_mesh.h"

#include "export/mesh/mesh_scenes.h"
#include "image/camera.h"
#include "image/shading/smooth_shading.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <optional>
#include <set>

namespace patch_mesh_test {

using namespace multipath;

namespace {

PatchMesh flat_mesh(const Scene& scene, const std::vector<Rgb>& values)
{
    return patch_mesh(scene, flat_corners(values), {});
}

PatchMesh smooth_mesh(const Scene& scene, const std::vector<Rgb>& values)
{
    const SmoothShading shading(scene, values, 1);
    return patch_mesh(scene, [&](std::uint32_t patch) { return shading.at_corners(patch); }, {});
}

/// Twice the area, in the direction from which the corners run counter-clockwise.
Vec3 area_vector(const PatchMesh& mesh, const MeshFace& face)
{
    const Vec3 origin = to_vec3(mesh.positions[face.corners[0]]);
    Vec3 sum;
    for (std::uint32_t k = 1; k + 1 < face.corner_count; ++k)
        sum = sum + cross(to_vec3(mesh.positions[face.corners[k]]) - origin,
                          to_vec3(mesh.positions[face.corners[k + 1]]) - origin);
    return sum;
}

/// How many vertices lie inside edges of faces, to within a millionth: all with all.
int cracks(const PatchMesh& mesh)
{
    int found = 0;
    for (const MeshFace& face : mesh.faces)
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const Vec3 start = to_vec3(mesh.positions[face.corners[k]]);
            const Vec3 along = to_vec3(mesh.positions[face.corners[(k + 1) % face.corner_count]]) - start;
            for (const Float3& position : mesh.positions) {
                const Vec3 way = to_vec3(position) - start;
                const double share = dot(way, along) / dot(along, along);
                const bool inside = share > 1e-6 && share < 1.0 - 1e-6;
                found += inside && length(way - share * along) < 1e-6 ? 1 : 0;
            }
        }
    return found;
}

} // namespace

// Whatever was cut, the faces of a patch together are the patch, and look where it does.
TEST_CASE("the faces of every patch have its area and side")
{
    for (const int kind : {0, 1, 2, 3}) {
        const Scene whole = walls_that_do_not_match().scene(1.0, kind % 2 != 0);
        const Scene scene = kind < 2 ? whole : unevenly_refined(whole);
        const PatchMesh mesh = smooth_mesh(scene, some_values(scene));
        std::vector<Vec3> doubled(scene.patch_count());
        for (const MeshSide& side : mesh.sides)
            for (std::size_t n = side.first_face; n < side.first_face + side.face_count; ++n) {
                const Vec3 area = area_vector(mesh, mesh.faces[n]);
                REQUIRE(dot(area, side.normal) > 0.0);
                REQUIRE(scene.surface_of(mesh.faces[n].patch) == side.surface);
                doubled[mesh.faces[n].patch] = doubled[mesh.faces[n].patch] + area;
            }
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            const Vec3 expected = 2.0 * scene.area(patch) * scene.patch(patch).shape.normal();
            REQUIRE(length(doubled[patch] - expected) < 1e-5); // floats, of coordinates up to 5
        }
    }
}

TEST_CASE("no corner lies on another face's edge, whatever meets there")
{
    const Scene whole = walls_that_do_not_match().scene(1.0);
    for (const Scene& scene : {whole, unevenly_refined(whole)}) {
        CHECK(cracks(flat_mesh(scene, some_values(scene))) == 0);
        const PatchMesh mesh = smooth_mesh(scene, some_values(scene));
        CHECK(cracks(mesh) == 0);
        CHECK(mesh.faces.size() > scene.patch_count()); // there was something to sew
    }
}

TEST_CASE("corners of different surfaces that differ by rounding come to lie in one place")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, paint);
    const Scene scene = builder.rectangle({1 + 3e-7, 0, 0}, {0, 0, 1}, {0, 1 - 2e-7, 0}, paint).scene(0.25);
    const PatchMesh mesh = flat_mesh(scene, std::vector<Rgb>(scene.patch_count(), Rgb{1, 1, 1}));
    std::set<Float3> places(mesh.positions.begin(), mesh.positions.end());
    CHECK(places.size() == 5 * 5 + 4 * 5); // the two squares share five corners

    // Here patches touch the common side with nothing but a corner.
    SceneBuilder of_triangles;
    const std::uint32_t lamp = of_triangles.grey(0.5, 1.0);
    of_triangles.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, lamp);
    of_triangles.triangle({3e-7, 0, 1e-7}, {3e-7, 1, 1e-7}, {-1, 0, 0}, lamp);
    const Scene triangles = of_triangles.scene(0.36);
    const PatchMesh flat = flat_mesh(triangles, some_values(triangles));
    places = {flat.positions.begin(), flat.positions.end()};
    CHECK(places.size() == 15 + 10); // they share five
}

TEST_CASE("flat patches keep their own values, smooth ones share vertices inside a side")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, builder.grey(0.5, 0.0));
    const Scene scene = builder.rectangle({0, 50, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 1.0)).scene(1.0);
    const std::vector<Rgb> values = some_values(scene);
    const PatchMesh flat = flat_mesh(scene, values);
    CHECK(flat.positions.size() == 4 * 13);
    for (const MeshFace& face : flat.faces)
        for (const std::uint32_t corner : face)
            REQUIRE(flat.radiosity[corner] == single(values[face.patch]));

    const PatchMesh smooth = smooth_mesh(scene, values);
    CHECK(smooth.positions.size() == 5 * 4 + 4); // a grid of 4 x 3 patches, and the lamp
    const SmoothShading shading(scene, values, 1);
    for (const MeshFace& face : smooth.faces)
        for (std::uint32_t k = 0; k < 4; ++k)
            REQUIRE(smooth.radiosity[face.corners[k]] == single(shading.at_corners(face.patch)[k]));
}

TEST_CASE("patches of one value but different errors share no vertex")
{
    SceneBuilder builder;
    const Scene scene = builder.rectangle({0, 0, 0}, {2, 0, 0}, {0, 1, 0}, builder.grey(0.5, 1.0)).scene(1.0);
    const std::vector<Rgb> same(scene.patch_count(), Rgb{1, 1, 1});
    const std::vector<Rgb> different = some_values(scene);
    CHECK(patch_mesh(scene, flat_corners(same), {}).positions.size() == 6);
    CHECK(patch_mesh(scene, flat_corners(same), flat_corners(different)).positions.size() == 8);
}

// A linear ramp is the same from whatever vertices it is interpolated.
TEST_CASE("new corners have the values of where they are")
{
    const Scene scene = walls_that_do_not_match().scene(1.0);
    const auto ramp = [](Vec3 p) { return 1.0 + 0.5 * p.x + 0.25 * p.y + 0.125 * p.z; };
    const auto at_corners = [&](std::uint32_t patch, double factor) {
        std::array<Rgb, 4> values;
        const CellCorners corners = scene.corners(patch);
        const std::uint32_t surface = scene.surface_of(patch);
        const Tessellation& cut = scene.tessellation(surface);
        for (std::size_t k = 0; k < corners.count; ++k) {
            const double value =
                factor * ramp(scene.surfaces()[surface].at(static_cast<double>(corners.points[k].i) / cut.cells_u,
                                                           static_cast<double>(corners.points[k].j) / cut.cells_v));
            values[k] = {value, 2.0 * value, 3.0 * value};
        }
        return values;
    };
    const PatchMesh mesh = patch_mesh(
        scene, [&](std::uint32_t patch) { return at_corners(patch, 1.0); },
        [&](std::uint32_t patch) { return at_corners(patch, 0.25); });
    REQUIRE(mesh.error.size() == mesh.radiosity.size());
    for (std::size_t n = 0; n < mesh.positions.size(); ++n) {
        const double value = ramp(to_vec3(mesh.positions[n]));
        const double tolerance = 1e-6 * value; // floats
        REQUIRE(std::abs(static_cast<double>(mesh.radiosity[n][0]) - value) < tolerance);
        REQUIRE(std::abs(static_cast<double>(mesh.radiosity[n][2]) - 3.0 * value) < 3.0 * tolerance);
        REQUIRE(std::abs(static_cast<double>(mesh.error[n][2]) - 0.75 * value) < tolerance);
    }
}

TEST_CASE("sides follow each other, each front before its back")
{
    const Scene scene = walls_that_do_not_match().scene(1.0, true);
    const PatchMesh mesh = flat_mesh(scene, some_values(scene));
    REQUIRE(mesh.sides.size() == 2 * scene.surfaces().size());
    std::size_t vertices = 0;
    std::size_t faces = 0;
    for (std::size_t n = 0; n < mesh.sides.size(); ++n) {
        const MeshSide& side = mesh.sides[n];
        CHECK(side.surface == n / 2);
        CHECK(side.first_vertex == vertices);
        CHECK(side.first_face == faces);
        for (std::size_t f = side.first_face; f < side.first_face + side.face_count; ++f)
            for (const std::uint32_t corner : mesh.faces[f]) {
                REQUIRE(corner >= side.first_vertex);
                REQUIRE(corner < side.first_vertex + side.vertex_count);
            }
        vertices += side.vertex_count;
        faces += side.face_count;
    }
    CHECK(vertices == mesh.positions.size());
    CHECK(faces == mesh.faces.size());
}

} // namespace patch_mesh_test

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

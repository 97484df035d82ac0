#include "export/mesh/coloured_mesh.h"

#include "export/mesh/mesh_scenes.h"
#include "export/mesh/ply_reader.h"
#include "image/shading/smooth_shading.h"
#include "scene/obj/obj_reader.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

namespace coloured_mesh_test {

using namespace multipath;

namespace {

Rgb halved(Rgb radiosity)
{
    return 0.5 * radiosity;
}

double area(const PlyFile& file, const PlyFile::Face& face)
{
    Vec3 sum;
    const Vec3 origin = file.vertices[face.corners[0]].position;
    for (std::size_t k = 1; k + 1 < face.corners.size(); ++k)
        sum = sum + cross(file.vertices[face.corners[k]].position - origin,
                          file.vertices[face.corners[k + 1]].position - origin);
    return 0.5 * length(sum);
}

} // namespace

TEST_CASE("another reader finds every part of a PLY")
{
    SceneBuilder builder;
    const Scene scene = builder.rectangle({1, 2, 3}, {0, 0, 2}, {1, 0, 0}, builder.grey(0.5, 1.0)).scene(1.0);
    const std::vector<Rgb> radiosity = {{0.25, 0.5, 2.0}, {0.75, 1.0, 0.0}};
    const std::vector<Rgb> error = {{0.125, 0.25, 0.5}, {0.0, 1.0, 2.0}};
    const PatchMesh mesh = patch_mesh(scene, flat_corners(radiosity), flat_corners(error));
    const PlyFile file = read_ply(ply_bytes(mesh, radiosity, halved, {"one", "command: two"}));
    CHECK(file.comments == std::vector<std::string>{"one", "command: two"});
    CHECK(file.vertex_properties ==
          std::vector<std::string>{"float x", "float y", "float z", "float nx", "float ny", "float nz", "uchar red",
                                   "uchar green", "uchar blue", "float radiosity_r", "float radiosity_g",
                                   "float radiosity_b", "float error_r", "float error_g", "float error_b"});
    CHECK(file.face_properties == std::vector<std::string>{"list uchar int vertex_indices", "int patch",
                                                           "float radiosity_r", "float radiosity_g",
                                                           "float radiosity_b"});
    REQUIRE(file.vertices.size() == 8);
    REQUIRE(file.faces.size() == 2);
    CHECK(file.faces[1].patch == 1);
    CHECK(file.faces[1].radiosity == radiosity[1]);
    const PlyFile::Vertex& vertex = file.vertices[file.faces[0].corners[1]];
    CHECK(vertex.position == Vec3{1, 2, 4});
    CHECK(vertex.normal == Vec3{0, 1, 0});
    CHECK(vertex.radiosity == radiosity[0]);
    CHECK(vertex.error == error[0]);
    CHECK(vertex.colour == Rgb{32, 64, 255}); // 255 / 8 and 255 / 4, rounded
}

TEST_CASE("without standard errors there are no columns for them")
{
    const Scene scene = walls_that_do_not_match().scene(1.0);
    const std::vector<Rgb> radiosity = some_values(scene);
    const PlyFile file = read_ply(ply_bytes(patch_mesh(scene, flat_corners(radiosity), {}), radiosity, halved, {}));
    CHECK(file.vertex_properties.size() == 12);
}

// The light of the room, twice: from the faces of the file and from the patches.
TEST_CASE("areas and powers add up to those of the scene")
{
    const Scene scene = walls_that_do_not_match().scene(0.3, true);
    const std::vector<Rgb> radiosity = some_values(scene);
    const SmoothShading shading(scene, radiosity, 1);
    const PatchMesh mesh = patch_mesh(scene, [&](std::uint32_t patch) { return shading.at_corners(patch); }, {});
    const PlyFile file = read_ply(ply_bytes(mesh, radiosity, halved, {}));
    double total = 0.0;
    Rgb power;
    for (const PlyFile::Face& face : file.faces) {
        total += area(file, face);
        power += area(file, face) * face.radiosity;
    }
    Rgb expected;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        expected += scene.area(i) * radiosity[i];
    CHECK(total == doctest::Approx(scene.total_area()).epsilon(1e-6)); // floats
    CHECK(power.r == doctest::Approx(expected.r).epsilon(1e-6));
    CHECK(power.g == doctest::Approx(expected.g).epsilon(1e-6));
    CHECK(power.b == doctest::Approx(expected.b).epsilon(1e-6));
}

TEST_CASE("an OBJ has its record, places with colours, names, and faces that count from one")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, -0.1}, {0, 0, 1}, {2.5, 0, 0}, builder.grey(0.5, 1.0));
    SceneFile file = builder.file();
    file.groups = {"the floor"};
    file.materials[0].name = "caf\xc3\xa9 \"au\" lait";
    const Scene scene(file, 4.0);
    const std::vector<Rgb> radiosity = {{0.25, 0.5, 1.0 / 3.0}};
    CHECK(obj_text(patch_mesh(scene, flat_corners(radiosity), {}), scene, halved, {"one", "two"}) ==
          "# one\n# two\nv 0 0 -0.1 0.1250 0.2500 0.1667\nv 0 0 0.9 0.1250 0.2500 0.1667\n"
          "v 2.5 0 0.9 0.1250 0.2500 0.1667\nv 2.5 0 -0.1 0.1250 0.2500 0.1667\n"
          "g the floor\nusemtl caf\xc3\xa9 \"au\" lait\nf 1 2 3 4\n");
}

TEST_CASE("PLY and OBJ are exact to a millionth of the scene's size however far away and large that is")
{
    const Scene unmoved = walls_that_do_not_match().scene(1.0);
    const std::vector<Rgb> radiosity = some_values(unmoved);
    const auto ply_of = [&](const Scene& scene) {
        return read_ply(ply_bytes(patch_mesh(scene, flat_corners(radiosity), {}), radiosity, halved, {"one"}));
    };
    const auto obj_of = [&](const Scene& scene) {
        return obj_positions(obj_text(patch_mesh(scene, flat_corners(radiosity), {}), scene, halved, {}));
    };
    const auto positions = [](const PlyFile& file, Vec3 offset) {
        std::vector<Vec3> points;
        for (const PlyFile::Vertex& vertex : file.vertices)
            points.push_back(offset + vertex.position);
        return points;
    };
    const PlyFile near = ply_of(unmoved);
    CHECK(near.comments.size() == 1);
    for (const Placement& placement : far_and_other_sizes()) {
        CAPTURE(placement.scale);
        const Scene scene(placement.moved(walls_that_do_not_match().file()), placement.scale);
        REQUIRE(scene.patch_count() == unmoved.patch_count());
        const PlyFile file = ply_of(scene);
        Vec3 offset;
        if (file.comments.size() == 2) { // "offset: x y z"
            std::istringstream words(file.comments[1].substr(7));
            words >> offset.x >> offset.y >> offset.z;
        }
        CHECK(offset == mesh_origin(scene));
        for (const double x : {offset.x, offset.y, offset.z})
            CHECK(static_cast<double>(static_cast<float>(x)) == x);
        CHECK(largest_miss(positions(file, offset), placement, positions(near, {}), unmoved) < 1e-6);
        for (const PlyFile::Face& face : file.faces)
            REQUIRE(area(file, face) > 0.0);
        CHECK(largest_miss(obj_of(scene), placement, obj_of(unmoved), unmoved) < 1e-6);
    }
}

// Names come from files, so that the reader of such files is the judge.
TEST_CASE("the reader of scenes reads the mesh back, with all names")
{
    SceneFile file = walls_that_do_not_match().file();
    file.materials[0].name = "paint #1 (old)";
    file.materials[1].name = "red";
    file.groups = {"", "one wall"};
    file.group[2] = 1;
    const Scene scene(file, 1.0);
    const std::vector<Rgb> radiosity = some_values(scene);
    const ScratchFolder folder;
    folder.write("lit.mtl", "newmtl paint #1 (old)\nKd 0.5 0.5 0.5\nnewmtl red\nKe 1 1 1\nnewmtl material2\n");
    const std::string text = obj_text(patch_mesh(scene, flat_corners(radiosity), {}), scene, halved, {"one"});
    const std::string path = folder.write("lit.obj", "mtllib lit.mtl\n" + text);
    const SceneFile lit = read_obj(path);
    double area = 0.0;
    for (const Surface& surface : lit.surfaces)
        area += surface.area();
    CHECK(area == doctest::Approx(scene.total_area()).epsilon(1e-6)); // seven digits
    CHECK(lit.unknown_materials.empty());
    REQUIRE(lit.materials.size() == 3);
    CHECK(lit.materials[lit.material[0]].name == "paint #1 (old)");
    CHECK(lit.groups == std::vector<std::string>{"", "one wall"});
}

} // namespace coloured_mesh_test

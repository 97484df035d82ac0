#include "export/mesh/obj_colours.h"

#include "export/mesh/mesh_scenes.h"
#include "scene/obj/obj_reader.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <sstream>

namespace obj_colours_test {

using namespace multipath;

namespace {

Rgb halved(Rgb radiosity)
{
    return 0.5 * radiosity;
}

} // namespace

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

} // namespace obj_colours_test

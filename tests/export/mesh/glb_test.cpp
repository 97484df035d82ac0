#include "export/mesh/glb.h"

#include "base/elementary.h"
#include "export/mesh/glb_reader.h"
#include "export/mesh/json_reader.h"
#include "export/mesh/mesh_scenes.h"
#include "image/shading/smooth_shading.h"

#include <doctest/doctest.h>

#include <cmath>

namespace glb_test {

using namespace multipath;

namespace {

Vec3 at(const std::vector<double>& positions, double vertex)
{
    const auto first = 3 * static_cast<std::size_t>(vertex);
    return {positions.at(first), positions.at(first + 1), positions.at(first + 2)};
}

} // namespace

TEST_CASE("a GLB has one unlit mesh per material, with the names and physics of the scene, and its record")
{
    SceneFile file = walls_that_do_not_match().file();
    file.materials.push_back({"unused", {}, {}, "test"});
    file.materials[1].name = "\"red\" caf\xe9"; // Latin-1
    const Scene scene(file, 1.0);
    const std::vector<Rgb> radiosity = some_values(scene);
    const GlbFile glb(
        glb_bytes(patch_mesh(scene, flat_corners(radiosity), {}), scene, 0.5, {}, {"one", "command: \"two\""}));
    CHECK(glb.json["asset"]["version"].text == "2.0");
    CHECK(glb.json["asset"]["extras"]["record"][1].text == "command: \\\"two\\\"");
    CHECK(glb.json["asset"]["extras"]["color_scale"].number() == 0.5);
    CHECK(glb.json["extensionsUsed"][0].text == "KHR_materials_unlit");
    REQUIRE(glb.json["meshes"].list.size() == 3);
    REQUIRE(glb.json["materials"].list.size() == 3);
    CHECK(glb.json["scenes"][0]["nodes"].list.size() == 3);
    for (std::size_t n = 0; n < 3; ++n) {
        const JsonValue& material = glb.json["materials"][n];
        CHECK(glb.json["nodes"][n]["mesh"].count() == n);
        CHECK(glb.json["meshes"][n]["primitives"][0]["material"].count() == n);
        CHECK(material["extensions"].members.count("KHR_materials_unlit") == 1);
        CHECK(material["doubleSided"].text == "false");
        CHECK(material["extras"]["reflectance"][0].number() == file.materials[n].reflectance.r);
        CHECK(material["extras"]["emittance"][2].number() == file.materials[n].emittance.b);
        CHECK(material["name"].text == glb.json["meshes"][n]["name"].text);
    }
    CHECK(glb.json["materials"][1]["name"].text == "\\\"red\\\" caf\xc3\xa9");
}

TEST_CASE("a material that lies wholly under others in its planes has no mesh in a GLB")
{
    SceneBuilder builder;
    const std::uint32_t under = builder.grey(0.5, 0.0);
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {4, 0, 0}, under);
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {2, 0, 0}, paint).rectangle({2, 0, 0}, {0, 0, 2}, {2, 0, 0}, paint);
    const Scene scene = builder.scene(1.0);
    const GlbFile glb(glb_bytes(patch_mesh(scene, flat_corners(some_values(scene)), {}), scene, 0.5, {}, {}));
    REQUIRE(glb.json["meshes"].list.size() == 1);
    CHECK(glb.json["materials"].list.size() == 1);
    CHECK(glb.json["meshes"][0]["name"].text == scene.materials()[paint].name);
    for (const JsonValue& accessor : glb.json["accessors"].list)
        CHECK(accessor["count"].count() > 0);
    CHECK(glb.corners().size() == 3 * 2 * 8); // of 4 x 2 squares, each in two triangles
}

TEST_CASE("cameras of a GLB stand at their eyes and look along their views")
{
    const Scene scene = walls_that_do_not_match().scene(1.0);
    const PatchMesh mesh = patch_mesh(scene, flat_corners(some_values(scene)), {});
    const GlbFile without(glb_bytes(mesh, scene, 0.5, {}, {}));
    CHECK(without.json.members.count("cameras") == 0);

    const GlbCamera door{"door", {1, 2, 3}, {1, 2, 7}, {0, 1, 1}, 60.0};
    const GlbCamera top{"top", {0, 5, 0}, {1, 1, 0}, {0, 0, 2}, 90.0};
    const GlbFile glb(glb_bytes(mesh, scene, 0.5, {door, top}, {}));
    REQUIRE(glb.json["cameras"].list.size() == 2);
    const std::size_t meshes = glb.json["meshes"].list.size();
    CHECK(glb.json["scenes"][0]["nodes"].list.size() == meshes + 2);
    for (std::size_t k = 0; k < 2; ++k) {
        const GlbCamera& camera = k == 0 ? door : top;
        const JsonValue& node = glb.json["nodes"][meshes + k];
        CHECK(node["name"].text == camera.name);
        CHECK(node["camera"].count() == k);
        std::vector<double> m;
        for (std::size_t i = 0; i < 16; ++i)
            m.push_back(node["matrix"][i].number());
        const Vec3 x{m[0], m[1], m[2]}, y{m[4], m[5], m[6]}, z{m[8], m[9], m[10]};
        CHECK(length(Vec3{m[12], m[13], m[14]} - camera.eye) == 0.0);
        CHECK(length(normalized(camera.eye - camera.target) - z) < 1e-15);
        CHECK(length(cross(x, y) - z) < 1e-15);
        CHECK(dot(y, camera.up) > 0.0);
        CHECK(std::abs(dot(x, camera.up)) < 1e-15);
        CHECK(m[15] == 1.0);
        CHECK(glb.json["cameras"][k]["perspective"]["yfov"].number() ==
              doctest::Approx(camera.field_of_view * pi / 180));
    }
}

// Triangle by triangle: each lies in the scene, looks the right way, and has the radiosity of a smooth picture.
TEST_CASE("the triangles of a GLB cover the surfaces of their material")
{
    const Scene scene = walls_that_do_not_match().scene(1.0, true);
    const std::vector<Rgb> radiosity = some_values(scene);
    const SmoothShading shading(scene, radiosity, 1);
    const PatchMesh mesh = patch_mesh(scene, [&](std::uint32_t patch) { return shading.at_corners(patch); }, {});
    const GlbFile glb(glb_bytes(mesh, scene, 0.5, {}, {}));
    for (std::size_t n = 0; n < scene.materials().size(); ++n) {
        const JsonValue& primitive = glb.json["meshes"][n]["primitives"][0];
        const std::vector<double> positions = glb.attribute(primitive, "POSITION");
        const std::vector<double> corners = glb.values(primitive["indices"].count());
        double area = 0.0;
        Vec3 facing;
        for (std::size_t t = 0; t < corners.size(); t += 3) {
            const Vec3 a = at(positions, corners[t]);
            const Vec3 doubled = cross(at(positions, corners[t + 1]) - a, at(positions, corners[t + 2]) - a);
            REQUIRE(length(doubled) > 1e-3);
            area += 0.5 * length(doubled);
            facing = facing + doubled;
        }
        double expected = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            expected += scene.file().material[scene.surface_of(i)] == n ? scene.area(i) : 0.0;
        CHECK(area == doctest::Approx(expected).epsilon(1e-6)); // floats
        CHECK(length(facing) < 1e-4);                           // fronts and backs
    }
}

// Each vertex, also within the face, shows the place of the texture that the OBJ gives it.
TEST_CASE("texture coordinates of a GLB are those of the OBJ, however faces and textures are slanted, turned and moved")
{
    const std::vector<TexturedFace> faces = textured_faces();
    for (const TexturedFace& face : faces) {
        const Scene whole(scene_of(face), 0.4, true);
        const Scene scene = unevenly_refined(whole);
        const std::vector<Rgb> radiosity = some_values(scene);
        const GlbFile glb(
            glb_bytes(patch_mesh(scene, flat_corners(radiosity), {}), scene, 0.5, {}, {}, {{"image/png", "an image"}}));
        CAPTURE(&face - &faces[0]);
        std::size_t textured = 0;
        for (std::size_t n = 0; n < glb.json["meshes"].list.size(); ++n) {
            if (glb.json["materials"][n]["name"].text != "paper")
                continue;
            const std::vector<double> p = glb.attribute(glb.primitive(n), "POSITION");
            const std::vector<double> st = glb.attribute(glb.primitive(n), "TEXCOORD_0");
            for (std::size_t k = 0; k < p.size() / 3; ++k) {
                const TexturePoint wanted = face.at(glb.placed("mesh", n, {p[3 * k], p[3 * k + 1], p[3 * k + 2]}));
                const double s = st[2 * k] - wanted.s;
                const double t = 1.0 - st[2 * k + 1] - wanted.t;
                REQUIRE(std::abs(s - std::round(s)) < 1e-5); // floats up to 7
                REQUIRE(std::abs(t - std::round(t)) < 1e-5);
                const bool near = std::abs(wanted.s) < 256; // further away whole images are left out
                REQUIRE((near ? std::abs(s) + std::abs(t) < 1 : std::abs(st[2 * k]) + std::abs(st[2 * k + 1]) < 20));
                ++textured;
            }
        }
        CHECK(textured > 100);
    }
}

TEST_CASE("a GLB holds the images of the textures as they are, with their types and how they repeat")
{
    SceneFile file = scene_of(textured_faces()[0]);
    const Texture& known = *file.textures[0];
    file.textures.push_back(std::make_shared<const Texture>(known.name(), known.bytes(), !known.repeats()));
    const Scene scene(file, 0.4);
    const std::vector<ImageFile> images = {{"image/png", "first"}, {"image/jpeg", "the second"}};
    const GlbFile glb(glb_bytes(patch_mesh(scene, flat_corners(some_values(scene)), {}), scene, 0.5, {}, {}, images));
    REQUIRE(glb.json["images"].list.size() == 2);
    REQUIRE(glb.json["textures"].list.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        const std::string wrap = file.textures[k]->repeats() ? "10497" : "33071"; // REPEAT, CLAMP_TO_EDGE
        CHECK(glb.view(glb.json["images"][k]["bufferView"].count()) == images[k].bytes);
        CHECK(glb.json["images"][k]["mimeType"].text == images[k].type);
        CHECK(glb.json["textures"][k]["source"].count() == k);
        CHECK(glb.json["samplers"][glb.json["textures"][k]["sampler"].count()]["wrapS"].text == wrap);
        CHECK(glb.json["samplers"][glb.json["textures"][k]["sampler"].count()]["wrapT"].text == wrap);
    }
}

TEST_CASE("colours are linear and clipped, radiosity and error are as they are, and ranges are right")
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {1, 0, 0}, paint).rectangle({0, 5, 0}, {1, 0, 0}, {0, 0, 1}, paint);
    const Scene scene = builder.scene(1.0);
    const std::vector<Rgb> radiosity = {{0.25, 0.5, 8.0}, {1, 1, 1}, {2, 0.125, 0}};
    const std::vector<Rgb> error = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
    const GlbFile glb(glb_bytes(patch_mesh(scene, flat_corners(radiosity), flat_corners(error)), scene, 0.25, {}, {}));
    const JsonValue& primitive = glb.json["meshes"][0]["primitives"][0];
    const std::vector<double> colours = glb.attribute(primitive, "COLOR_0");
    CHECK(colours[0] == 0.0625);
    CHECK(colours[1] == 0.125);
    CHECK(colours[2] == 1.0);
    CHECK(glb.attribute(primitive, "_RADIOSITY")[2] == 8.0);
    CHECK(glb.attribute(primitive, "_RADIOSITY")[3 * 11] == 2.0);
    CHECK(glb.attribute(primitive, "_ERROR")[3 * 11 + 2] == 9.0);
    const JsonValue& range = glb.json["accessors"][primitive["attributes"]["POSITION"].count()];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        CHECK(range["min"][axis].number() == 0.0);
        CHECK(range["max"][axis].number() == std::vector<double>{1, 5, 2}[axis]);
    }
}

// Moved back, the meshes are those of the unmoved room.
TEST_CASE("a GLB is exact to a millionth of the scene's size however far away and large that is, cameras included")
{
    const auto glb_of = [](const Scene& scene, const GlbCamera& camera, Vec3 up) {
        return GlbFile(
            glb_bytes(patch_mesh(scene, flat_corners(some_values(scene)), {}), scene, 0.5, {camera}, {}, {}, up));
    };
    const Scene unmoved = walls_that_do_not_match().scene(1.0);
    const GlbCamera camera{"door", {1, 2, 3}, {1, 4, 7}, {0, 1, 0}, 60.0};
    const GlbFile near = glb_of(unmoved, camera, {0, 1, 0});
    CHECK(near.json["scenes"][0]["nodes"].list.size() == near.json["nodes"].list.size()); // all at the top
    const std::vector<Vec3> expected = near.corners();
    for (const Placement& placement : far_and_other_sizes()) {
        CAPTURE(placement.scale);
        const Scene scene(placement.moved(walls_that_do_not_match().file()), placement.scale);
        GlbCamera moved = camera;
        moved.eye = placement.scale * camera.eye + placement.shift;
        moved.target = placement.scale * camera.target + placement.shift;
        const GlbFile glb = glb_of(scene, moved, {0, 1, 0});
        const std::vector<Vec3> corners = glb.corners();
        CHECK(largest_miss(corners, placement, expected, unmoved) < 1e-6);
        for (std::size_t n = 0; n < corners.size(); n += 3)
            REQUIRE(length(cross(corners[n + 1] - corners[n], corners[n + 2] - corners[n])) > 0.0);
        CHECK(largest_miss({glb.placed("camera", 0, {})}, placement, {camera.eye}, unmoved) < 1e-6);
    }
}

TEST_CASE(
    "a GLB has y upwards, whatever the upward direction of the scene, and its nodes turn it exactly by right angles")
{
    for (const Vec3 up : {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -3}, Vec3{2, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, -7, 0},
                          Vec3{1, -2, 3}, Vec3{1e-9, -1, 0}})
        for (const Vec3 shift : {Vec3{}, Vec3{500000, 120, 4649776}}) {
            CAPTURE(up.x + 10 * up.y + 100 * up.z);
            const Scene scene(Placement{1.0, shift}.moved(walls_that_do_not_match().file()), 1.0);
            const GlbCamera camera{"door", shift + Vec3{1, 2, 3}, shift + Vec3{2, 4, 7}, {1, 1, 0}, 60.0};
            const PatchMesh mesh = patch_mesh(scene, flat_corners(some_values(scene)), {});
            const GlbFile glb(glb_bytes(mesh, scene, 0.5, {camera}, {}, {}, up));
            // Where the corners of the scene's axes go: a rotation, which takes `up` to y.
            const Vec3 x = glb.placed("mesh", 0, {1, 0, 0}) - glb.placed("mesh", 0, {});
            const Vec3 y = glb.placed("mesh", 0, {0, 1, 0}) - glb.placed("mesh", 0, {});
            const Vec3 z = glb.placed("mesh", 0, {0, 0, 1}) - glb.placed("mesh", 0, {});
            const int zeros = (up.x == 0 ? 1 : 0) + (up.y == 0 ? 1 : 0) + (up.z == 0 ? 1 : 0);
            const double rounding = zeros == 2 ? 0.0 : shift == Vec3{} ? 1e-15 : 1e-8; // of places millions away
            const Vec3 upright = (1.0 / length(up)) * (up.x * x + up.y * y + up.z * z);
            CHECK(length(upright - Vec3{0, 1, 0}) <= rounding);
            CHECK(length(cross(x, y) - z) <= 2 * rounding);
            CHECK(std::abs(dot(x, y)) <= 2 * rounding);
            CHECK(std::abs(length(x) - 1.0) <= 2 * rounding);
            CHECK(std::abs(length(y) - 1.0) <= 2 * rounding);
            // The camera sees the room as before: from the same point relative to it, along the same line.
            const auto turned = [&](Vec3 p) { return p.x * x + p.y * y + p.z * z; };
            const Vec3 corner = glb.placed("mesh", 0, shift - mesh.origin);    // of the first wall
            CHECK(length(corner - turned(shift)) <= (zeros == 2 ? 0.0 : 0.1)); // of millions, by axes of eight digits
            CHECK(length(glb.placed("camera", 0, {}) - corner - turned(camera.eye - shift)) < 1e-6);
            const Vec3 ahead = glb.placed("camera", 0, {0, 0, -1}) - glb.placed("camera", 0, {});
            CHECK(length(ahead - turned(normalized(camera.target - camera.eye))) < 1e-8);
            const bool as_it_was = up == Vec3{0, 1, 0} && shift == Vec3{};
            CHECK(glb.json["scenes"][0]["nodes"].list.size() == (as_it_was ? glb.json["nodes"].list.size() : 1));
        }
}

} // namespace glb_test

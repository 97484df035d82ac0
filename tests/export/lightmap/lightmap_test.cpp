#include "export/lightmap/lightmap.h"

#include "base/errors.h"
#include "export/lightmap/lightmap_glb.h"
#include "export/mesh/glb_reader.h"
#include "export/mesh/json_reader.h"
#include "export/mesh/mesh_scenes.h"
#include "scene/obj/obj_reader.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

namespace lightmap_test {

using namespace multipath;

namespace {

Rgb to_light(Vec3 p)
{
    return {p.x, p.y, p.z};
}

Vec3 to_place(Rgb light)
{
    return {light.r, light.g, light.b};
}

/// Light that says where it is.
SurfaceLight places_of(const Scene& scene)
{
    return [&scene](std::uint32_t s, bool, double u, double v) { return to_light(scene.surfaces()[s].at(u, v)); };
}

/// As graphics processors do it: between the middles of four texels.
Rgb bilinear(const Lightmap& map, TexturePoint place)
{
    const double x = place.s * map.width - 0.5;
    const double y = (1.0 - place.t) * map.height - 0.5;
    const double column = std::floor(x);
    const double row = std::floor(y);
    const auto texel = [&](double i, double j) {
        return map.texels.at(static_cast<std::size_t>(j) * map.width + static_cast<std::size_t>(i));
    };
    const auto between = [](Rgb a, Rgb b, double share) { return (1.0 - share) * a + share * b; };
    return between(between(texel(column, row), texel(column + 1, row), x - column),
                   between(texel(column, row + 1), texel(column + 1, row + 1), x - column), y - row);
}

/// The point (u, v) of a side that lies at a place of the atlas.
std::array<double, 2> point_at(const TextureFrame& frame, TexturePoint place)
{
    const double s = place.s - frame.origin.s;
    const double t = place.t - frame.origin.t;
    const double determinant = frame.along_u.s * frame.along_v.t - frame.along_u.t * frame.along_v.s;
    return {(s * frame.along_v.t - t * frame.along_v.s) / determinant,
            (frame.along_u.s * t - frame.along_u.t * s) / determinant};
}

std::vector<std::array<double, 2>> unit_corners_of(const Surface& surface)
{
    if (surface.shape == Shape::triangle)
        return {{0, 0}, {1, 0}, {0, 1}};
    return {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}

/// Pieces of a wall, an even floor of a rectangle and a fan of triangles around it, slanted parallelograms, rows of
/// rectangles and triangles whose charts are turned, and a speck.
SceneBuilder all_kinds()
{
    SceneBuilder builder = walls_that_do_not_match();
    const std::uint32_t floor = builder.grey(0.3, 0.0);
    builder.rectangle({10, 0, 0}, {0, 0, 2}, {3, 0, 0}, floor);
    builder.triangle({13, 0, 0}, {13, 0, 2}, {15, 0, 1}, floor);
    builder.triangle({10, 0, 2}, {11, 0, 4}, {13, 0, 2}, floor);
    builder.triangle({13, 0, 2}, {11, 0, 4}, {14.5, 0, 3}, floor);
    builder.rectangle({20, 1, 0.5}, {2, 1, 0.3}, {-0.4, 0.2, 1.7}, floor);
    for (const double x : {0.0, 0.9, 1.8}) // in a row whose longer side is across their own
        builder.rectangle({30 + x, 2, 0}, {0, 0, 1}, {0.9, 0, 0}, floor);
    const Vec3 aside = {0.4, 0.3, 0.2}; // slanted triangles of one longest edge beside each other, likewise
    for (int n = 0; n < 4; ++n) {
        const Vec3 begin = Vec3{40, 0, 0} + n * aside;
        builder.triangle(begin, begin + Vec3{0, 1, -0.5}, begin + aside, floor);
        builder.triangle(begin + aside + Vec3{0, 1, -0.5}, begin + aside, begin + Vec3{0, 1, -0.5}, floor);
    }
    builder.rectangle({20, 5, 0.5}, {4, 0.1, 0}, {0, 1e-3, 1e-3}, floor);
    return builder.rectangle({25, 5, 0.5}, {1e-4, 0, 0}, {0, 2e-4, 0}, floor);
}

SceneBuilder random_triangles(std::size_t count)
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 1.0);
    std::uint64_t counter = 0;
    const auto within = [&](double low, double high) {
        return low + (high - low) * bits_to_unit(random_bits(7, counter++));
    };
    for (std::size_t n = 0; n < count; ++n) {
        const Vec3 a = {within(0, 9), within(0, 9), within(0, 9)};
        const auto near = [&] { return a + Vec3{within(-0.2, 0.2), within(-0.2, 0.2), within(-0.2, 0.2)}; };
        builder.triangle(a, near(), near(), paint);
    }
    return builder;
}

/// all_kinds() with two textures, of which the second is unused; of the two surfaces with the first, one does not lie
/// on it.
SceneFile with_textures()
{
    SceneFile file = all_kinds().file();
    file.textures = {std::make_shared<const Texture>("grey.pgm", "P2 2 1 255\n255 99 ", true),
                     std::make_shared<const Texture>("white.pgm", "P2 1 1 255\n255 ", false)};
    file.texture_frames.resize(file.surfaces.size());
    file.materials.push_back({"paper", {0.3, 0.3, 0.3}, {}, "test", 0, {0.5, 0.5, 0.5}});
    for (const std::size_t surface : {4u, 5u})
        file.material[surface] = static_cast<std::uint32_t>(file.materials.size() - 1);
    file.texture_frames[4] = {{0.25, 0.5}, {2, 0}, {0, 3}, true};
    file.materials[0].emittance = {1, 1, 1}; // the lamp has become paper
    return file;
}

} // namespace

TEST_CASE("surfaces lie on a lightmap undistorted, at one scale, within it, and as they are seen from the front")
{
    const Scene scene(all_kinds().file(), 1.0);
    const Lightmap map = lightmap(scene, 512, places_of(scene), 1);
    REQUIRE(map.width == 512);
    REQUIRE(map.height == 512);
    REQUIRE(map.frames.size() == scene.surfaces().size());
    REQUIRE(map.texels_per_unit > 30.0);
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s) {
        const TextureFrame& frame = map.frame(s, true);
        const Surface& surface = scene.surfaces()[s];
        const auto texels = [](TexturePoint d) { return Vec3{512 * d.s, 512 * d.t, 0.0}; };
        const Vec3 u = texels(frame.along_u);
        const Vec3 v = texels(frame.along_v);
        CHECK(cross(u, v).z > 0.0);
        if (surface.area() > 0.02) { // the others are narrower than a texel
            const double square = map.texels_per_unit * map.texels_per_unit;
            CHECK(dot(u, u) == doctest::Approx(square * dot(surface.edge_u, surface.edge_u)).epsilon(1e-9));
            CHECK(dot(v, v) == doctest::Approx(square * dot(surface.edge_v, surface.edge_v)).epsilon(1e-9));
            CHECK(std::abs(dot(u, v) - square * dot(surface.edge_u, surface.edge_v)) < 1e-9 * square);
        }
        for (const auto& [x, y] : unit_corners_of(surface)) {
            const TexturePoint place = frame.at(x, y);
            CHECK(std::min(place.s, place.t) > 2.0 / 512);
            CHECK(std::max(place.s, place.t) < 1.0 - 2.0 / 512);
            CHECK(std::abs(point_at(frame, place)[0] - x) < 1e-9);
            CHECK(std::abs(point_at(frame, place)[1] - y) < 1e-9);
        }
    }
}

TEST_CASE("what is narrower than a texel is one texel wide")
{
    const Scene scene(all_kinds().file(), 1.0);
    const Lightmap map = lightmap(scene, 512, places_of(scene), 1);
    const auto last = static_cast<std::uint32_t>(scene.surfaces().size() - 1);
    const TextureFrame& speck = map.frame(last, true);
    CHECK(512 * std::hypot(speck.along_u.s, speck.along_u.t) == doctest::Approx(1.0));
    CHECK(512 * std::hypot(speck.along_v.s, speck.along_v.t) == doctest::Approx(1.0));
    const TextureFrame& strip = map.frame(last - 1, true);
    CHECK(512 * std::hypot(strip.along_u.s, strip.along_u.t) ==
          doctest::Approx(map.texels_per_unit * length(scene.surfaces()[last - 1].edge_u)));
    CHECK(512 * std::hypot(strip.along_v.s, strip.along_v.t) == doctest::Approx(1.0));
}

TEST_CASE("no texel within two of a side is within two of another")
{
    const bool with_backs = true;
    for (const SceneFile& file : {all_kinds().file(), random_triangles(300).file()}) {
        const Scene scene(file, 1.0, with_backs);
        const Lightmap map = lightmap(scene, 256, places_of(scene), 1);
        std::vector<bool> held(map.texels.size());
        for (std::size_t side = 0; side < map.frames.size(); ++side) {
            Bounds box;
            for (const auto& [u, v] : unit_corners_of(scene.surfaces()[side % scene.own_surfaces()])) {
                const TexturePoint place = map.frames[side].at(u, v);
                box.include(Vec3{place.s * map.width, place.t * map.height, 0.0});
            }
            const auto texel_at = [](double x) { return static_cast<std::uint32_t>(x); };
            for (std::uint32_t y = texel_at(box.low.y - 2.0); y <= texel_at(box.high.y + 2.0); ++y)
                for (std::uint32_t x = texel_at(box.low.x - 2.0); x <= texel_at(box.high.x + 2.0); ++x) {
                    REQUIRE_FALSE(held.at(std::size_t{y} * map.width + x));
                    held[std::size_t{y} * map.width + x] = true;
                }
        }
        CHECK(static_cast<std::size_t>(std::count(held.begin(), held.end(), true)) > map.texels.size() / 2);
    }
}

// Edges of charts that are not on middles of texels lie between a point inside and the nearest one on the edge.
TEST_CASE("bilinear lookup finds linear light: exactly inside, within a texel's step on edges and corners")
{
    const Scene scene(all_kinds().file(), 1.0);
    const Lightmap map = lightmap(scene, 512, places_of(scene), 1);
    const double step = 1.0 / map.texels_per_unit;
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s) {
        const Surface& surface = scene.surfaces()[s];
        const auto miss = [&](double u, double v) {
            return length(to_place(bilinear(map, map.frame(s, true).at(u, v))) - surface.at(u, v));
        };
        for (const double u : {0.25, 0.3, 0.4})
            for (const double v : {0.2, 0.31, 0.37})
                if (surface.area() > 0.02)
                    CHECK(miss(u, v) < 1e-9);
        const auto corners = unit_corners_of(surface);
        for (std::size_t k = 0; k < corners.size(); ++k)
            for (const double share : {0.0, 0.01, 0.3, 0.777}) {
                const auto& a = corners[k];
                const auto& b = corners[(k + 1) % corners.size()];
                CHECK(miss(a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])) < step);
            }
    }
}

// Light that is the number of the patch: from the picture back to the scene.
TEST_CASE(
    "the texel at the middle of a patch shows this patch, on either side, whatever axes, mirrors and moves there are")
{
    for (const int kind : {0, 1, 2, 3}) {
        SceneFile file = all_kinds().file();
        const auto turned = [&](Vec3 p) {
            return kind == 1 ? Vec3{p.z, p.x, p.y} : kind == 2 ? Vec3{-p.x, p.y, p.z} : p;
        };
        for (Surface& s : file.surfaces)
            s = {s.shape, turned(s.origin) + (kind == 3 ? Vec3{500000, 120, 4649776} : Vec3{}), turned(s.edge_u),
                 turned(s.edge_v)};
        const Scene scene(file, 0.7, true);
        const SurfaceLight numbers = [&](std::uint32_t s, bool front, double u, double v) {
            const double number = scene.patch_at(s, u, v, front);
            return Rgb{number, number, number};
        };
        const Lightmap map = lightmap(scene, 1024, numbers, 1);
        std::size_t seen = 0;
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            const Patch place = scene.patch(patch);
            const Surface& surface = scene.surfaces()[place.surface];
            if (place.shape.area() < 0.01)
                continue; // a few texels
            // The middle in coordinates of the surface, by areas.
            const Vec3 p = place.shape.centre() - surface.origin;
            const Vec3 normal = cross(surface.edge_u, surface.edge_v);
            const double u = dot(cross(p, surface.edge_v), normal) / dot(normal, normal);
            const double v = dot(cross(surface.edge_u, p), normal) / dot(normal, normal);
            const TexturePoint there = map.frame(place.surface, scene.is_front(patch)).at(u, v);
            const auto column = static_cast<std::size_t>(there.s * map.width);
            const auto row = static_cast<std::size_t>((1.0 - there.t) * map.height);
            REQUIRE(map.texels.at(row * map.width + column).g == patch);
            ++seen;
        }
        CHECK(seen > 100);
    }
}

TEST_CASE("light on an edge along the axes of its chart is exact where the chart begins")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {3, 0, 0}, {0, 0.777, 0}, builder.grey(0.5, 1.0));
    const Scene scene = builder.scene(1.0);
    const Lightmap map = lightmap(scene, 64, places_of(scene), 1);
    for (const double share : {0.0, 0.1, 0.5, 0.9}) {
        CHECK(length(to_place(bilinear(map, map.frame(0, true).at(share, 0))) - Vec3{3 * share, 0, 0}) < 1e-12);
        CHECK(length(to_place(bilinear(map, map.frame(0, true).at(0, share))) - Vec3{0, 0.777 * share, 0}) < 1e-12);
    }
}

TEST_CASE("the two sides of a surface have places and light of their own")
{
    const Scene scene(all_kinds().file(), 1.0, true);
    const Lightmap map = lightmap(
        scene, 512,
        [](std::uint32_t, bool front, double, double) {
            return front ? Rgb{1, 0, 0} : Rgb{0, 1, 0};
        },
        1);
    REQUIRE(map.frames.size() == 2 * scene.surfaces().size());
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
        for (const auto& [u, v] : unit_corners_of(scene.surfaces()[s])) {
            CHECK(length(to_place(bilinear(map, map.frame(s, true).at(u, v))) - Vec3{1, 0, 0}) < 1e-12);
            CHECK(length(to_place(bilinear(map, map.frame(s, false).at(u, v))) - Vec3{0, 1, 0}) < 1e-12);
        }
}

TEST_CASE("the sky has no place in a lightmap")
{
    SceneFile file = all_kinds().file();
    file.sky_surfaces = 1;
    const Scene scene(file, 1.0);
    std::set<std::uint32_t> asked;
    const Lightmap map = lightmap(
        scene, 256,
        [&](std::uint32_t s, bool, double, double) {
            asked.insert(s);
            return Rgb{};
        },
        1);
    CHECK(map.frames.size() == file.surfaces.size() - 1);
    CHECK(asked.size() == file.surfaces.size() - 1);
    CHECK(asked.count(static_cast<std::uint32_t>(file.surfaces.size() - 1)) == 0);
}

TEST_CASE("over a texture a texel is the mean of its square")
{
    SceneFile file = all_kinds().file();
    file.textures = {std::make_shared<const Texture>("grey.pgm", "P2 1 1 255\n255 ", true)};
    file.texture_frames.resize(file.surfaces.size());
    file.materials[0].texture = 0;
    const Scene scene(file, 1.0);
    const double texels_per_unit = lightmap(scene, 256, places_of(scene), 1).texels_per_unit;
    const auto stripes = [&](std::uint32_t s, bool, double u, double v) { // 33 pairs to a texel
        const double x = scene.surfaces()[s].at(u, v).x;
        return Rgb{std::abs(std::remainder(33.0 * texels_per_unit * x, 1.0)) < 0.25 ? 1.0 : 0.0, x, 0.0};
    };
    const Lightmap map = lightmap(scene, 256, stripes, 1);
    double sum = 0.0;
    for (int k = 5; k < 95; ++k) {
        const double u = 0.01 * k;
        const Rgb light = bilinear(map, map.frame(0, true).at(u, 0.5));
        CHECK(light.g == doctest::Approx(4.0 * u)); // linear light stays what it is
        CHECK(light.r > 0.0);
        CHECK(light.r < 1.0);
        sum += light.r / 90.0;
    }
    CHECK(sum == doctest::Approx(0.5).epsilon(0.1));
}

TEST_CASE("a lightmap is the same for any number of threads")
{
    const Scene scene(random_triangles(500).file(), 9.0, true);
    const Lightmap one = lightmap(scene, 512, places_of(scene), 1);
    const Lightmap three = lightmap(scene, 512, places_of(scene), 3);
    CHECK(one.texels == three.texels);
    CHECK(lightmap_glb(scene, one, "png", 1.0, {}, {}) == lightmap_glb(scene, three, "png", 1.0, {}, {}));
}

TEST_CASE("many triangles find their places, where they need it in a larger picture, or are refused")
{
    const Scene scene = random_triangles(20000).scene(9.0);
    const SurfaceLight dark = [](std::uint32_t, bool, double, double) { return Rgb{}; };
    const Lightmap map = lightmap(scene, 2048, dark, 2);
    CHECK(map.width == 2048);
    CHECK(map.frames.size() == 20000);
    double used_share = 0.0;
    for (const TextureFrame& frame : map.frames)
        used_share += 0.5 * (frame.along_u.s * frame.along_v.t - frame.along_u.t * frame.along_v.s);
    CHECK(used_share > 0.15); // of the half that triangles leave in their rectangles, margins take the larger part
    CHECK(lightmap(scene, 512, dark, 2).width == 1024);
    std::string message;
    try {
        lightmap(scene, 100, dark, 1, 799);
    } catch (const InputError& error) {
        message = error.what();
    }
    CHECK(message == "memory: its surfaces do not fit into a lightmap of 400 x 400 texels; expected fewer surfaces");
}

// Light that says where it is makes the picture itself the judge: looked up at a vertex, it must show the vertex.
TEST_CASE("a lightmap GLB has all surfaces as triangles, which find their light by their texture coordinates")
{
    for (const bool two_sided : {false, true}) {
        const Scene scene(with_textures(), 1.0, two_sided);
        const Lightmap map = lightmap(scene, 512, places_of(scene), 1);
        const GlbFile glb(lightmap_glb(scene, map, "png!!", 0.5, {}, {"one", "two"}));
        CHECK(glb.json["asset"]["version"].text == "2.0");
        CHECK(glb.json["asset"]["extras"]["record"][1].text == "two");
        CHECK(glb.json["asset"]["extras"]["color_scale"].number() == 0.5);
        CHECK(glb.json["extensionsUsed"][0].text == "KHR_materials_unlit");
        CHECK(glb.json.members.count("cameras") == 0);
        double area = 0.0;
        Vec3 facing;
        Vec3 front_facing;
        for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
            front_facing = front_facing + scene.surfaces()[s].area() * scene.surfaces()[s].normal();
        for (std::size_t mesh = 0; mesh < glb.json["meshes"].list.size(); ++mesh) {
            const JsonValue& primitive = glb.primitive(mesh);
            const std::vector<double> p = glb.values(primitive["attributes"]["POSITION"]);
            const std::vector<double> st = glb.values(primitive["attributes"]["TEXCOORD_0"]);
            const std::vector<double> triangles = glb.values(primitive["indices"]);
            REQUIRE(3 * st.size() == 2 * p.size());
            const auto position = [&](double vertex) {
                const std::size_t n = 3 * static_cast<std::size_t>(vertex);
                return Vec3{p.at(n), p.at(n + 1), p.at(n + 2)};
            };
            Bounds box;
            for (std::size_t t = 0; t < triangles.size(); t += 3) {
                const Vec3 a = position(triangles[t]);
                const Vec3 twice = cross(position(triangles[t + 1]) - a, position(triangles[t + 2]) - a);
                area += 0.5 * length(twice);
                facing = facing + 0.5 * twice;
                Vec3 middle;
                TexturePoint place;
                for (std::size_t k = t; k < t + 3; ++k) {
                    const std::size_t n = 2 * static_cast<std::size_t>(triangles[k]);
                    middle = middle + (1.0 / 3.0) * position(triangles[k]);
                    place = {place.s + st.at(n) / 3.0, place.t + (1.0 - st.at(n + 1)) / 3.0};
                    box.include(position(triangles[k]));
                    CHECK(length(to_place(bilinear(map, {st.at(n), 1.0 - st.at(n + 1)})) - position(triangles[k])) <
                          1.0 / map.texels_per_unit);
                }
                CHECK(length(to_place(bilinear(map, place)) - middle) < 1.0 / map.texels_per_unit);
            }
            const JsonValue& range = glb.json["accessors"][primitive["attributes"]["POSITION"].count()];
            CHECK(range["min"][0].number() == box.low.x);
            CHECK(range["max"][2].number() == box.high.z);
        }
        CHECK(area == doctest::Approx(scene.total_area()).epsilon(1e-6)); // floats
        CHECK(length(facing - (two_sided ? Vec3{} : front_facing)) < 1e-4);
    }
}

TEST_CASE(
    "materials of a lightmap GLB keep their names, are unlit, and show the atlas; places on their own texture are kept")
{
    const Scene scene(with_textures(), 1.0);
    const Lightmap map = lightmap(scene, 256, places_of(scene), 1);
    const GlbFile glb(lightmap_glb(scene, map, "the atlas", 1.0, {}, {}));
    const std::size_t materials = glb.json["materials"].list.size();
    CHECK(materials == 4); // the lamp's is unused
    REQUIRE(glb.json["meshes"].list.size() == materials);
    for (std::size_t n = 0; n < materials; ++n) {
        const JsonValue& material = glb.json["materials"][n];
        const bool paper = material["name"].text == "paper";
        CHECK(glb.primitive(n)["material"].count() == n);
        CHECK(glb.json["meshes"][n]["name"].text == material["name"].text);
        CHECK(glb.json["nodes"][n]["mesh"].count() == n);
        CHECK(material["extensions"].members.count("KHR_materials_unlit") == 1);
        CHECK(material["pbrMetallicRoughness"]["baseColorTexture"]["index"].count() == 0);
        CHECK(material["pbrMetallicRoughness"]["baseColorTexture"].members.count("texCoord") == 0);
        CHECK(glb.primitive(n)["attributes"].members.count("TEXCOORD_1") == (paper ? 1 : 0));
        if (paper) {
            // The corners of a triangle and a rectangle of which only the first lies on the texture.
            const std::vector<double> st = glb.values(glb.primitive(n)["attributes"]["TEXCOORD_1"]);
            CHECK(st == std::vector<double>{0.25, 0.5, 2.25, 0.5, 0.25, -2.5, 0, 1, 0, 1, 0, 1, 0, 1});
        }
    }
    REQUIRE(glb.json["images"].list.size() == 1);
    REQUIRE(glb.json["textures"].list.size() == 1);
    CHECK(glb.view(glb.json["images"][0]["bufferView"].count()) == "the atlas");
    CHECK(glb.json["textures"][0]["source"].count() == 0);
    CHECK(glb.json["samplers"][0]["wrapS"].text == "33071");
    CHECK(glb.json["samplers"][0]["minFilter"].text == "9729"); // no small copies, which would mix charts
}

TEST_CASE("cameras of a lightmap GLB stand at their eyes and look along their views")
{
    const Scene scene = all_kinds().scene(1.0);
    const Lightmap map = lightmap(scene, 128, places_of(scene), 1);
    const GlbCamera door{"door", {1, 2, 3}, {1, 2, 7}, {0, 1, 1}, 60.0};
    const GlbCamera top{"top", {0, 5, 0}, {1, 1, 0}, {0, 0, 2}, 90.0};
    const GlbFile glb(lightmap_glb(scene, map, "png", 1.0, {door, top}, {}));
    const std::size_t meshes = glb.json["meshes"].list.size();
    REQUIRE(glb.json["cameras"].list.size() == 2);
    CHECK(glb.json["scenes"][0]["nodes"].list.size() == meshes + 2);
    CHECK(glb.json["cameras"][1]["perspective"]["yfov"].number() == doctest::Approx(std::acos(0.0)));
    const JsonValue& node = glb.json["nodes"][meshes];
    CHECK(node["name"].text == "door");
    std::vector<double> matrix;
    for (const JsonValue& number : node["matrix"].list)
        matrix.push_back(number.number());
    CHECK(matrix == std::vector<double>{-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 1, 2, 3, 1});
}

TEST_CASE("lightmap meshes are exact to a millionth of the scene's size however far away and large that is")
{
    const SurfaceLight dark = [](std::uint32_t, bool, double, double) { return Rgb{}; };
    const auto glb_of = [&](const Scene& scene, Vec3 up) {
        return GlbFile(lightmap_glb(scene, lightmap(scene, 256, dark, 1), "png", 1.0, {}, {}, up));
    };
    const Scene unmoved = walls_that_do_not_match().scene(1.0);
    const std::vector<Vec3> expected = glb_of(unmoved, {0, 1, 0}).corners();
    for (const Placement& placement : far_and_other_sizes()) {
        CAPTURE(placement.scale);
        const Scene scene(placement.moved(walls_that_do_not_match().file()), placement.scale);
        const std::vector<Vec3> corners = glb_of(scene, {0, 1, 0}).corners();
        CHECK(largest_miss(corners, placement, expected, unmoved) < 1e-6);
        for (std::size_t n = 0; n < corners.size(); n += 3)
            REQUIRE(length(cross(corners[n + 1] - corners[n], corners[n + 2] - corners[n])) > 0.0);
        std::vector<Vec3> turned = glb_of(scene, {0, 0, 1}).corners();
        for (Vec3& p : turned)
            p = {p.x, -p.z, p.y}; // z upwards again
        CHECK(largest_miss(turned, placement, expected, unmoved) < 1e-6);
    }
}

} // namespace lightmap_test

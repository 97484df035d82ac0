#include "irregular_scene.h"

#include "base/elementary.h"
#include "export/csv_text.h"
#include "export/mesh/coloured_mesh.h"
#include "export/mesh/glb.h"
#include "export/mesh/glb_reader.h"
#include "export/mesh/patch_mesh.h"
#include "export/mesh/ply_reader.h"
#include "export/patch_table.h"
#include "export/state_file.h"
#include "geometry/intersector/intersector.h"
#include "geometry/polygon.h"
#include "image/camera.h"
#include "image/gather/light_grid.h"
#include "image/png.h"
#include "image/render.h"
#include "image/shading/smooth_shading.h"
#include "scene/random_ray.h"
#include "scene/scratch_folder.h"
#include "viewer/typed_array.h"
#include "viewer/viewer_page.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

// One scene in which nothing coincides, through whatever reads, writes or shows scenes and their light.

namespace irregular_scene_test {

using namespace multipath;

namespace {

std::string state_of(ArchivedScene scene)
{
    std::string bytes;
    StateWriter writer([&](std::string_view more) { bytes += more; });
    scene.visit(writer);
    writer.finish();
    return bytes;
}

Vec3 area_vector(const std::vector<Vec3>& corners)
{
    Vec3 sum;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        sum = sum + 0.5 * cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    return sum;
}

bool nearly(Rgb a, Rgb b, double tolerance)
{
    const Rgb d = a - b;
    const double size = 1.0 + std::max({std::abs(a.r), std::abs(a.g), std::abs(a.b)});
    return std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b)}) <= tolerance * size;
}

} // namespace

TEST_CASE("a state gives back every property of a scene")
{
    const Scene scene = irregular_scene();
    const std::string bytes = state_of(archived(scene));
    StateReader reader("test.state", bytes);
    ArchivedScene read;
    read.visit(reader);
    CHECK(state_of(read) == bytes);
    const Scene again = restored(read);
    CHECK(again.levels() == scene.levels());
    CHECK(again.two_sided());
    CHECK(again.patch_size() == scene.patch_size());
    const SceneFile& a = again.file();
    const SceneFile& b = scene.file();
    CHECK(a.path == b.path);
    CHECK(a.groups == b.groups);
    CHECK(a.material == b.material);
    CHECK(a.group == b.group);
    CHECK(a.line == b.line);
    CHECK(a.sky_surfaces == b.sky_surfaces);
    CHECK(a.surfaces == b.surfaces);
    CHECK(a.sun->direction == b.sun->direction);
    CHECK(a.sun->irradiance == b.sun->irradiance);
    REQUIRE(a.materials.size() == b.materials.size());
    for (std::size_t m = 0; m < a.materials.size(); ++m) {
        CHECK(a.materials[m].name == b.materials[m].name);
        CHECK(a.materials[m].source == b.materials[m].source);
        CHECK(a.materials[m].reflectance == b.materials[m].reflectance);
        CHECK(a.materials[m].emittance == b.materials[m].emittance);
        CHECK(a.materials[m].texture == b.materials[m].texture);
        CHECK(a.materials[m].texture_scale == b.materials[m].texture_scale);
    }
    REQUIRE(a.textures.size() == b.textures.size());
    for (std::size_t k = 0; k < a.textures.size(); ++k) {
        CHECK(a.textures[k]->name() == b.textures[k]->name());
        CHECK(a.textures[k]->bytes() == b.textures[k]->bytes());
        CHECK(a.textures[k]->repeats() == b.textures[k]->repeats());
    }
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        CHECK(again.reflectance(i) == scene.reflectance(i));
}

TEST_CASE("tables and meshes say the same of every patch")
{
    const Scene scene = irregular_scene();
    const std::vector<Rgb> radiosity = irregular_values(scene.patch_count(), 1);
    const std::vector<Rgb> error = irregular_values(scene.patch_count(), 2);
    const ScratchFolder folder;
    const std::string path = folder.write("a.csv", patch_table(scene, radiosity, error, {}));
    const PatchTable table = read_patch_table(path);
    const CsvTable csv = read_csv(path);
    const PatchMesh mesh = patch_mesh(scene, flat_corners(radiosity), flat_corners(error));
    const PlyFile ply = read_ply(ply_bytes(mesh, radiosity, [](Rgb c) { return 0.1 * c; }, {}));
    std::vector<Vec3> area(scene.patch_count());
    std::vector<Vec3> moment(scene.patch_count()); // area times centroid
    for (const PlyFile::Face& face : ply.faces) {
        CAPTURE(face.patch);
        std::vector<Vec3> corners;
        for (const std::size_t corner : face.corners) {
            const PlyFile::Vertex& vertex = ply.vertices[corner];
            corners.push_back(vertex.position);
            CHECK(length(vertex.normal - scene.patch(face.patch).shape.normal()) < 1e-6);
            CHECK(nearly(vertex.radiosity, radiosity[face.patch], 1e-6));
            CHECK(nearly(vertex.error, error[face.patch], 1e-6));
        }
        CHECK(nearly(face.radiosity, radiosity[face.patch], 1e-6));
        for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
            const Vec3 part = area_vector({corners[0], corners[k], corners[k + 1]});
            area[face.patch] = area[face.patch] + part;
            moment[face.patch] = moment[face.patch] + length(part) / 3.0 * (corners[0] + corners[k] + corners[k + 1]);
        }
    }
    REQUIRE(table.areas.size() == scene.patch_count());
    CHECK(table.radiosity == radiosity);
    CHECK(table.standard_error == error);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        CAPTURE(i);
        const Patch patch = scene.patch(i);
        const auto number = [&](const char* name) { return csv.number(csv.rows[i], csv.column(name)); };
        CHECK(number("surface") == patch.surface);
        CHECK(csv.rows[i].fields[csv.column("material")] == scene.material_of(i).name);
        if (scene.is_sky(patch.surface)) {
            CHECK(table.areas[i] == 0.0);
            CHECK(length(area[i]) == 0.0);
            continue;
        }
        CHECK(length(area[i] - table.areas[i] * patch.shape.normal()) < 1e-5);
        CHECK(length(moment[i] - table.areas[i] * Vec3{number("x"), number("y"), number("z")}) < 1e-5);
    }

    // By material, with the textures' part of the colour taken out.
    const GlbFile glb(glb_bytes(mesh, scene, 0.1, {}, {}, texture_files(scene)));
    std::map<std::string, Vec3> of_glb, of_table;
    std::map<std::string, Rgb> light_of_glb, error_of_glb, light_of_table, error_of_table;
    for (std::size_t n = 0; n < glb.json["meshes"].list.size(); ++n) {
        const std::string name = glb.json["meshes"][n]["name"].text;
        const std::vector<double> corners = glb.values(glb.primitive(n)["indices"]);
        const std::vector<double> light = glb.attribute(glb.primitive(n), "_RADIOSITY");
        const std::vector<double> errors = glb.attribute(glb.primitive(n), "_ERROR");
        const std::vector<Vec3> places = glb.corners(n);
        for (std::size_t k = 0; k < corners.size(); k += 3) {
            const Vec3 part = area_vector({places[k], places[k + 1], places[k + 2]});
            of_glb[name] =
                of_glb[name] + length(part) * Vec3{1, 0, 0} + part.y * Vec3{0, 1, 0} + part.z * Vec3{0, 0, 1};
            for (std::size_t c = k; c < k + 3; ++c) {
                const auto at = 3 * static_cast<std::size_t>(corners[c]);
                light_of_glb[name] += length(part) / 3.0 * Rgb{light[at], light[at + 1], light[at + 2]};
                error_of_glb[name] += length(part) / 3.0 * Rgb{errors[at], errors[at + 1], errors[at + 2]};
            }
        }
    }
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const std::string& name = scene.material_of(i).name;
        const Vec3 normal = scene.patch(i).shape.normal();
        if (table.areas[i] == 0.0)
            continue;
        of_table[name] = of_table[name] + table.areas[i] * Vec3{1, normal.y, normal.z};
        light_of_table[name] += table.areas[i] * radiosity[i];
        error_of_table[name] += table.areas[i] * error[i];
    }
    CHECK(of_glb.size() == of_table.size());
    for (const auto& [name, all] : of_table) {
        CAPTURE(name);
        CHECK(length(of_glb[name] - all) < 1e-5);
        CHECK(nearly(light_of_glb[name], light_of_table[name], 1e-5));
        CHECK(nearly(error_of_glb[name], error_of_table[name], 1e-5));
    }
}

namespace {

std::vector<double> numbers(const JsonValue& list)
{
    std::vector<double> result;
    for (const JsonValue& value : list.list)
        result.push_back(value.number());
    return result;
}

std::vector<double> channels(Rgb c)
{
    return {c.r, c.g, c.b};
}

/// Packed light, as a reader of the page's document unpacks it.
std::vector<Rgb> unpacked(const JsonValue& json, const std::string& key)
{
    std::vector<Rgb> light;
    const std::vector<double> numbers = float16_array(json[key].text);
    for (std::size_t k = 0; k + 2 < numbers.size(); k += 3)
        light.push_back(json[key + "_unit"].number() * Rgb{numbers[k], numbers[k + 1], numbers[k + 2]});
    return light;
}

} // namespace

TEST_CASE("a page says the same of every surface, material and patch")
{
    const Scene scene = irregular_scene();
    const SceneFile& file = scene.file();
    ViewerContent content;
    content.camera = {{1.9, 2.9, 0.9}, {1.7, 2.6, -1.8}, {0.2, 1.0, 0.1}, 65.0};
    content.render.width = 40;
    content.render.height = 30;
    content.tone.exposure = 0.75;
    content.shown = 1;
    for (std::uint64_t key = 1; key <= 2; ++key)
        content.quantities.push_back({key == 1 ? "radiosity" : "more", key == 1 ? "Radiosity" : "More", "W", true,
                                      irregular_values(scene.patch_count(), key)});
    TracedLine line;
    line.points = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9.5}};
    line.joins = {false, true};
    line.crossings = {{{}, {4, 5, 6}, {}}};
    line.transfers = {{1, 5, 7, {1, 1, 2}, {3, 4, 4}, {6, 5, 6}, {}},
                      {0, 6, Segment::behind, {2, 2, 2}, {}, {9, 8, 7}, {}}};
    content.chapters.emplace_back().lines = {line};
    const std::string page = viewer_page(scene, content);
    const std::size_t begin = page.find(room_data_begin) + std::string(room_data_begin).size();
    const JsonValue room = JsonReader(page.substr(begin, page.find(room_data_end, begin) - begin)).document();

    const JsonValue& surfaces = room["surfaces"];
    const std::string triangles = base64_decoded(surfaces["triangles"].text);
    const std::vector<float> geometry = float32_array(surfaces["geometry"].text);
    const std::vector<std::uint32_t> grids = uint32_array(surfaces["grids"].text);
    const std::vector<std::uint32_t> cells = uint32_array(surfaces["cells"].text);
    const std::vector<float> frames = float32_array(surfaces["texture_frames"].text);
    REQUIRE(geometry.size() == 9 * file.surfaces.size());
    REQUIRE(frames.size() == 6 * file.surfaces.size());
    for (std::uint32_t s = 0; s < file.surfaces.size(); ++s) {
        CAPTURE(s);
        const Surface& surface = file.surfaces[s];
        CHECK(triangles[s] == (surface.shape == Shape::triangle ? 1 : 0));
        const Tessellation& cut = scene.tessellation(s);
        CHECK(grids[3 * s] == cut.grid_u());
        CHECK(grids[3 * s + 1] == cut.grid_v());
        CHECK(grids[3 * s + 2] == scene.first_patch(s));
        for (std::uint32_t k = 0; k < cut.cell_count(); ++k) {
            const std::size_t place = 3 * (std::size_t{scene.first_patch(s)} + k);
            const CellCorners corners = cut.corners(k);
            CHECK(cells[place] == corners.points[0].i);
            CHECK(cells[place + 1] == corners.points[0].j);
            CHECK(cells[place] + cells[place + 2] == corners.points[1].i);
        }
        std::size_t at = 9 * s;
        for (const Vec3 v : {surface.origin - mesh_origin(scene), surface.edge_u, surface.edge_v})
            for (const double x : {v.x, v.y, v.z})
                CHECK(geometry[at++] == doctest::Approx(x));
        at = 6 * s;
        const TextureFrame frame = scene.shows_texture(s) ? file.texture_frames[s] : TextureFrame{};
        for (const TexturePoint p : {frame.origin, frame.along_u, frame.along_v})
            for (const double x : {p.s, p.t}) {
                CHECK(std::isnan(frames[at]) == !scene.shows_texture(s));
                CHECK((std::isnan(frames[at]) || std::abs(frames[at] - x) < 1e-6));
                ++at;
            }
    }
    CHECK(uint32_array(surfaces["materials"].text) == file.material);
    CHECK(uint32_array(surfaces["groups"].text) == file.group);
    CHECK(uint32_array(surfaces["lines"].text) == file.line);
    std::vector<std::uint32_t> covered;
    const std::vector<bool> is_covered = covered_patches(scene, 1);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (is_covered[i] || scene.is_sky(scene.surface_of(i)))
            covered.push_back(i);
    CHECK(uint32_array(surfaces["covered"].text) == covered);

    REQUIRE(room["materials"].list.size() == file.materials.size());
    for (std::size_t m = 0; m < file.materials.size(); ++m) {
        const JsonValue& material = room["materials"][m];
        CHECK(material["name"].text == file.materials[m].name);
        CHECK(numbers(material["reflectance"]) == channels(file.materials[m].reflectance));
        CHECK(numbers(material["emittance"]) == channels(file.materials[m].emittance));
        if (file.materials[m].texture != Material::no_texture) {
            CHECK(material["texture"].count() == file.materials[m].texture);
            CHECK(numbers(material["white"]) == channels(file.materials[m].texture_scale));
        }
    }
    REQUIRE(room["textures"].list.size() == file.textures.size());
    for (std::size_t k = 0; k < file.textures.size(); ++k) {
        CHECK((room["textures"][k]["repeats"].text == "true") == file.textures[k]->repeats());
        CHECK(base64_decoded(room["textures"][k]["data"].text) == texture_files(scene)[k].bytes);
    }
    for (std::size_t k = 0; k < file.groups.size(); ++k)
        CHECK(room["groups"][k].text == file.groups[k]);

    const auto check_colours = [&](const JsonValue& packed, const auto& right) {
        const std::vector<float> found = float32_array(packed.text);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            CHECK(nearly({found.at(3 * i), found.at(3 * i + 1), found.at(3 * i + 2)}, right(i), 1e-6));
    };
    check_colours(room["reflectances"], [&](std::uint32_t i) { return scene.reflectance(i); });
    for (std::size_t k = 0; k < 2; ++k) {
        const std::vector<Rgb>& values = content.quantities[k].values;
        check_colours(room["quantities"][k]["values"], [&](std::uint32_t i) { return values[i]; });
        const CornerValues right = corner_values(scene, without_texture(scene, values), 1);
        const std::vector<Rgb> corners = unpacked(room["quantities"][k], "corners");
        REQUIRE(corners.size() == right.values.size());
        CHECK(uint32_array(room["quantities"][k]["own_places"].text) == right.own_places);
        for (std::size_t n = 0; n < corners.size(); ++n)
            CHECK(nearly(corners[n], right.values[n], 5e-4));
    }
    CHECK(room["shown"].count() == 1);
    CHECK(room["patches"].count() == scene.patch_count());
    CHECK(room["two_sided"].text == "true");
    CHECK(room["tone"]["exposure"].number() == 0.75);
    CHECK(numbers(room["camera"]["eye"]) == std::vector<double>{1.9, 2.9, 0.9});
    CHECK(numbers(room["camera"]["target"]) == std::vector<double>{1.7, 2.6, -1.8});
    CHECK(numbers(room["camera"]["up"]) == std::vector<double>{0.2, 1.0, 0.1});
    CHECK(room["camera"]["field_of_view"].number() == 65.0);

    const JsonValue& told = room["trace"][0]["lines"][0];
    CHECK(numbers(told["points"]) == std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9.5});
    CHECK(numbers(told["joins"]) == std::vector<double>{0, 1});
    CHECK(numbers(told["crossings"]) == std::vector<double>{4, 5, 6});
    CHECK(told["transfers"][0]["from"].count() == 5);
    CHECK(told["transfers"][0]["to"].count() == 7);
    CHECK(told["transfers"][1]["to"].text == "null");
    CHECK(numbers(told["transfers"][0]["forecast"]) == std::vector<double>{1, 1, 2});
    CHECK(numbers(told["transfers"][0]["held"]) == std::vector<double>{3, 4, 4});
    const Rgb gain = (1.0 / scene.area(7)) * (scene.reflectance(7) * Rgb{6, 5, 6});
    const std::vector<double> told_gain = numbers(told["transfers"][0]["gain"]);
    CHECK(nearly({told_gain.at(0), told_gain.at(1), told_gain.at(2)}, gain, 1e-5));
    CHECK(numbers(told["transfers"][1]["gain"]) == std::vector<double>{0, 0, 0});
    CHECK(numbers(told["transfers"][1]["forecast"]) == std::vector<double>{2, 2, 2});
}

namespace {

/// Axes and colours exchanged in a circle: x to y to z to x, red to green to blue to red.
Vec3 exchanged(Vec3 p)
{
    return {p.z, p.x, p.y};
}
Rgb exchanged(Rgb c)
{
    return {c.b, c.r, c.g};
}

SceneFile exchanged(SceneFile file)
{
    for (Surface& s : file.surfaces)
        s = {s.shape, exchanged(s.origin), exchanged(s.edge_u), exchanged(s.edge_v)};
    for (Material& material : file.materials) {
        material.reflectance = exchanged(material.reflectance);
        material.emittance = exchanged(material.emittance);
        material.texture_scale = exchanged(material.texture_scale);
    }
    file.sun = Sun{exchanged(file.sun->direction), exchanged(file.sun->irradiance)};
    return file;
}

/// `textured`: with a texture of pixels that each lack a channel, else with none.
Scene paint_scene(bool is_exchanged, bool textured)
{
    SceneFile file = irregular_file();
    const char* pixels = is_exchanged ? "P3 3 2 255\n0 250 90 40 0 200 130 60 0\n0 70 240 220 0 30 80 160 0\n"
                                      : "P3 3 2 255\n250 90 0 0 200 40 60 0 130\n70 240 0 0 30 220 160 0 80\n";
    const auto texture = std::make_shared<const Texture>("paint.ppm", pixels, true);
    for (Material& material : file.materials)
        if (material.texture != Material::no_texture) {
            material.texture = textured ? 0 : Material::no_texture;
            const Rgb mean =
                is_exchanged ? Rgb{texture->mean().g, texture->mean().b, texture->mean().r} : texture->mean();
            material.reflectance = material.texture_scale * mean;
        }
    file.textures.clear();
    if (textured)
        file.textures = {texture};
    else
        file.texture_frames.clear();
    return unevenly_refined(Scene(is_exchanged ? exchanged(file) : file, 0.7, true));
}

std::vector<Rgb> exchanged(std::vector<Rgb> values)
{
    for (Rgb& value : values)
        value = exchanged(value);
    return values;
}

Camera exchanged(Camera camera)
{
    return {exchanged(camera.eye), exchanged(camera.target), exchanged(camera.up), camera.field_of_view};
}

/// The number of pixels that differ by more than the tolerance.
std::size_t different(const Image& image, const Image& other, double tolerance)
{
    REQUIRE(image.pixels.size() == other.pixels.size());
    std::size_t count = 0;
    for (std::size_t k = 0; k < image.pixels.size(); ++k)
        count += nearly(exchanged(image.pixels[k]), other.pixels[k], tolerance) ? 0 : 1;
    return count;
}

} // namespace

TEST_CASE("with axes and colours exchanged everything shows the same, exchanged")
{
    const Scene one = paint_scene(false, true);
    const Scene other = paint_scene(true, true);
    for (std::uint32_t i = 0; i < one.patch_count(); ++i) {
        CHECK(nearly(exchanged(one.reflectance(i)), other.reflectance(i), 1e-12));
        CHECK(nearly(exchanged(one.sunlight(i)), other.sunlight(i), 1e-12));
    }
    const std::vector<Rgb> light = irregular_values(one.patch_count(), 3);
    const std::vector<Rgb> other_light = exchanged(light);
    const std::vector<Rgb> plain = without_texture(one, light);
    const std::vector<Rgb> other_plain = without_texture(other, other_light);
    for (std::uint32_t i = 0; i < one.patch_count(); ++i)
        CHECK(nearly(exchanged(plain[i]), other_plain[i], 1e-12));
    const Vec3 up = normalized(Vec3{0.2, 1.0, 0.1});
    const Camera camera = {{1.9, 2.9, 0.9}, {1.7, 2.6, -1.8}, up, 65.0};
    RenderOptions options;
    options.width = 32;
    options.height = 24;
    options.samples_per_pixel = 1;
    for (const Shading shading : {Shading::flat, Shading::smooth, Shading::gather}) {
        CAPTURE(static_cast<int>(shading));
        options.shading = shading;
        const Image image = render(one, light, camera, options);
        const Image again = render(other, other_light, exchanged(camera), options);
        const bool same_rays = shading != Shading::gather; // directions around a point depend on the axes
        CHECK(different(image, again, same_rays ? 1e-9 : 0.1) <= (same_rays ? 2 : 20));
    }
}

namespace {

/// One value for each side of a surface, which smooth shading does not change.
std::vector<Rgb> values_of_sides(const Scene& scene, std::uint64_t key)
{
    const std::vector<Rgb> values = irregular_values(2 * scene.surfaces().size(), key);
    std::vector<Rgb> light;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        light.push_back(scene.emittance(i) + (scene.is_sky(scene.surface_of(i)) ? 0.0 : 1.0) *
                                                 values[2 * scene.surface_of(i) + (scene.is_front(i) ? 0 : 1)]);
    return light;
}

} // namespace

TEST_CASE("a light grid fills the scene at its height, with the light that random rays find there")
{
    const Scene scene = paint_scene(false, false);
    const std::vector<Rgb> light = values_of_sides(scene, 4);
    const GridPlan plan = {1.4, 0.45, normalized(Vec3{0.2, 1.0, 0.1})};
    constexpr int rays = 4096;
    const LightGrid grid = light_grid(scene, light, plan, rays, 1);
    double level = std::numeric_limits<double>::infinity();
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
        for (const Vec3 corner : corners_of(scene.surfaces()[s]))
            level = std::min(level, dot(corner, plan.up));
    level += plan.height;
    RandomRay random;
    Rgb sum;
    for (const GridPointLight& place : grid.points) {
        CHECK(dot(place.point, plan.up) == doctest::Approx(level));
        Rgb all, squares;
        for (int k = 0; k < rays; ++k) {
            const double z = 2.0 * random.number() - 1.0; // the normal plus a point of the unit sphere: a cosine
            const double angle = 2.0 * pi * random.number();
            const double r = std::sqrt(1.0 - z * z);
            const Vec3 towards = plan.up + Vec3{r * std::cos(angle), r * std::sin(angle), z};
            const auto hit = scene.intersector().closest_hit({place.point, towards});
            const Rgb found = hit ? light[scene.patch_at(hit->surface, hit->u, hit->v, hit->front)] : Rgb{};
            all += 1.0 / rays * found;
            squares += 1.0 / rays * (found * found);
        }
        const Rgb variance = squares - all * all;
        const Rgb d = place.irradiance - all - scene.sunlight(Intersector::no_surface, place.point, plan.up);
        for (double Rgb::*c : {&Rgb::r, &Rgb::g, &Rgb::b})
            CHECK(std::abs(d.*c) < 6.0 * std::sqrt(variance.*c / rays) + 1e-3);
        sum += 1.0 / static_cast<double>(grid.points.size()) * place.irradiance;
    }
    CHECK(mean(sum) == doctest::Approx(grid.mean));
    // No place well inside the floor is farther from the nearest point than the corner of its square.
    for (int k = 0; k < 200; ++k) {
        const Vec3 floor = scene.surfaces()[0].at(random.number() * 0.6 + 0.2, random.number() * 0.6 + 0.2);
        const Vec3 place = floor + (level - dot(floor, plan.up)) * plan.up;
        if (dot(floor, plan.up) > level - plan.step)
            continue; // its neighbours may lie below the floor
        double nearest = std::numeric_limits<double>::infinity();
        for (const GridPointLight& point : grid.points)
            nearest = std::min(nearest, length(point.point - place));
        CHECK(nearest <= plan.step / std::sqrt(2.0));
    }
}

} // namespace irregular_scene_test

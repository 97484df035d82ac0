#include "viewer/viewer_page.h"

#include "export/mesh/patch_mesh.h"
#include "image/shading/smooth_shading.h"
#include "sampling/random.h"
#include "test_scenes.h"
#include "viewer/corners_of_patches.h"
#include "viewer/typed_array.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <stdexcept>

namespace viewer_page_test {

using namespace multipath;

namespace {

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

/// What stands between the quotation marks behind the first "key": of a text.
std::string text_of(const std::string& json, const std::string& key)
{
    const std::string begin = "\"" + key + "\": \"";
    const std::size_t at = json.find(begin);
    REQUIRE(at != std::string::npos);
    const std::size_t from = at + begin.size();
    return json.substr(from, json.find('"', from) - from);
}

/// A lit room with a triangle in it.
Scene small_scene()
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.material({0.75, 0.5, 0.25}, {0, 0, 0});
    const std::uint32_t lamp = builder.grey(0.5, 10.0);
    builder.room({0, 0, 0}, {2, 1, 1}, {wall, lamp, wall, wall, wall, wall});
    builder.triangle({0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}, {0.5, 0.5, 1}, wall);
    SceneFile file = builder.file();
    file.path = "<room> & \"more\".obj";
    file.materials[0].name = "</script><script>alert(1)</script>";
    return Scene(file, 0.25);
}

ViewerContent small_content(const Scene& scene)
{
    ViewerContent content;
    content.record = {"multipath 1", "command: multipath solve 'a\"<b>.obj'"};
    content.camera = {{0.1, 0.5, 0.5}, {2, 0.4, 0.5}};
    content.render.width = 40;
    content.render.height = 30;
    ViewerQuantity radiosity{"radiosity", "Radiosity", "W/m²", true, {}};
    ViewerQuantity number{"number", "Number", "1", false, {}};
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
        radiosity.values.push_back({1.0 + patch, 2.0, 3.0});
        const double value = patch == 3 ? std::numeric_limits<double>::quiet_NaN() : patch;
        number.values.push_back({value, value, value});
    }
    content.quantities = {radiosity, number};
    return content;
}

/// A floor with a wall standing on it, a triangle, and a lamp far above.
SceneBuilder shapes()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 3}, {2, 0, 0}, grey);
    builder.rectangle({1, 0, 0}, {0, 2, 0}, {0, 0, 3}, grey);
    builder.rectangle({1, 0, 0}, {0, 0, 3}, {0, 2, 0}, grey);
    builder.triangle({10, 0, 0}, {10, 0, 2}, {12, 0, 0}, grey);
    return builder.rectangle({0, 50, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 1.0));
}

} // namespace

TEST_CASE("a page is complete in itself: its scripts and styles are in it, and nothing is loaded")
{
    const Scene scene = small_scene();
    const std::string page = viewer_page(scene, small_content(scene));
    CHECK(page.compare(0, 15, "<!DOCTYPE html>") == 0);
    CHECK(count(page, "src=") == 0);
    CHECK(count(page, "<link rel=\"stylesheet\"") == 0);
    CHECK(count(page, "://") == 0);
    CHECK(count(page, "<!-- ") == 0);
    for (const char* part : {"\nbody {", "\nclass Room {", "\nclass Viewer {"})
        CHECK(count(page, part) == 1);
}

TEST_CASE("the page knows every tone curve of pictures")
{
    const Scene scene = small_scene();
    const std::string script = viewer_page(scene, small_content(scene));
    const std::size_t numbers = script.find("tone_numbers = {");
    REQUIRE(numbers != std::string::npos);
    for (const NamedToneOperator& named : tone_operators) {
        CAPTURE(named.name);
        CHECK(script.substr(numbers, script.find('}', numbers) - numbers).find(" " + std::string(named.name) + ":") !=
              std::string::npos);
    }
}

TEST_CASE("names in a scene stay text in the page")
{
    const Scene scene = small_scene();
    const std::string page = viewer_page(scene, small_content(scene));
    CHECK(count(page, "<title>&lt;room&gt; &amp; &quot;more&quot;.obj - multipath</title>") == 1);
    CHECK(count(page, "<meta name=\"multipath\" content=\"command: multipath solve 'a&quot;&lt;b&gt;.obj'\">") == 1);
    CHECK(count(page, "alert(1)</script>") == 0);
    CHECK(count(page, "\\u003c/script>\\u003cscript>alert(1)\\u003c/script>") == 1);
}

TEST_CASE("the page holds the surfaces and how they are cut, and the values of the patches")
{
    const Scene scene = small_scene();
    const std::string page = viewer_page(scene, small_content(scene));
    const std::size_t begin = page.find(room_data_begin);
    REQUIRE(begin != std::string::npos);
    const std::string json = page.substr(begin, page.find(room_data_end, begin) - begin);

    const std::string triangles = base64_decoded(text_of(json, "triangles"));
    const std::vector<float> geometry = float32_array(text_of(json, "geometry"));
    const std::vector<std::uint32_t> grids = uint32_array(text_of(json, "grids"));
    const std::vector<std::uint32_t> cells = uint32_array(text_of(json, "cells"));
    REQUIRE(triangles.size() == 7);
    REQUIRE(geometry.size() == 9 * 7);
    REQUIRE(grids.size() == 3 * 7);
    REQUIRE(cells.size() == 3 * scene.patch_count());
    for (std::uint32_t s = 0; s < 7; ++s) {
        const Surface& surface = scene.surfaces()[s];
        CHECK(triangles[s] == (s == 6 ? 1 : 0));
        CHECK(geometry[9 * s + 1] == doctest::Approx(surface.origin.y)); // to the 24 bits of a float
        CHECK(geometry[9 * s + 3] == doctest::Approx(surface.edge_u.x));
        CHECK(geometry[9 * s + 8] == doctest::Approx(surface.edge_v.z));
        CHECK(grids[3 * s + 2] == scene.first_patch(s));
    }
    // The corners of all patches follow from their cells.
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
        const std::uint32_t s = scene.surface_of(patch);
        const auto size = static_cast<std::int32_t>(cells[3 * patch + 2]);
        const auto share = [&](std::size_t k, double step) {
            return (cells[3 * patch + k] + step * size) / grids[3 * s + k];
        };
        const Surface& cell = scene.patch(patch).shape;
        const Surface& surface = scene.surfaces()[s];
        CHECK(length(surface.at(share(0, 0), share(1, 0)) - cell.at(0, 0)) < 1e-9);
        CHECK(length(surface.at(share(0, 1), share(1, 0)) - cell.at(1, 0)) < 1e-9);
        CHECK(length(surface.at(share(0, 0), share(1, 1)) - cell.at(0, 1)) < 1e-9);
    }
    CHECK(uint32_array(text_of(json, "materials")) == scene.file().material);

    const std::vector<float> radiosity = float32_array(text_of(json, "values"));
    REQUIRE(radiosity.size() == 3 * scene.patch_count());
    CHECK(radiosity[3 * 5] == 6.0f);
    const std::vector<float> numbers = float32_array(text_of(json.substr(json.find("\"key\": \"number\"")), "values"));
    REQUIRE(numbers.size() == scene.patch_count());
    CHECK(std::isnan(numbers[3]));
    CHECK(numbers[4] == 4.0f);
}

TEST_CASE("far from the origin, the page holds surfaces and lines relative to a point in the room")
{
    SceneFile file = small_scene().file();
    const Vec3 shift = {500000.25, -120, 4649776};
    for (Surface& surface : file.surfaces)
        surface.origin = surface.origin + shift;
    const Scene scene(file, 0.25);
    ViewerContent content = small_content(scene);
    content.camera = {shift + content.camera.eye, shift + content.camera.target};
    TracedLine line;
    line.points = {shift, shift + Vec3{0.25, 0.5, 1}};
    line.joins = {true};
    line.crossings = {{{}, shift, {}}};
    content.chapters.emplace_back().lines = {line};
    const std::string page = viewer_page(scene, content);
    const Vec3 origin = mesh_origin(scene);
    CHECK(length(origin - scene.own_bounds().centre()) < 2.0);
    CHECK(count(page, "\"origin\": [500002, -120, 4649776]") == 1);
    const std::vector<float> geometry = float32_array(text_of(page.substr(page.find(room_data_begin)), "geometry"));
    for (std::size_t s = 0; s < file.surfaces.size(); ++s) {
        const Vec3 place = {geometry[9 * s], geometry[9 * s + 1], geometry[9 * s + 2]};
        CHECK(length(origin + place - file.surfaces[s].origin) < 1e-7); // floats up to 2
    }
    CHECK(count(page, "\"points\": [-1.75, 0, 0, -1.5, 0.5, 1], \"joins\": [1], \"crossings\": [-1.75, 0, 0]") == 1);
}

TEST_CASE("a legend reaches to the 99th percentile, and says where there is more")
{
    const Scene scene = small_scene();
    REQUIRE(scene.patch_count() > 100); // one is less than a hundredth
    ViewerContent content = small_content(scene);
    std::vector<Rgb>& values = content.quantities[1].values;
    const auto last_number = [&] {
        const std::string page = viewer_page(scene, content);
        const std::size_t end = page.find("]", page.find("\"numbers\": [")) - 1; // at the last quotation mark
        const std::size_t begin = page.rfind('"', end - 1) + 1;
        return page.substr(begin, end - begin);
    };
    values.assign(values.size(), {2, 2, 2});
    CHECK(last_number() == "2.0");
    values[5] = {1000, 1000, 1000};
    CHECK(last_number() == "2.0+");
    for (std::size_t patch = 0; patch < values.size(); patch += 20)
        values[patch] = {4, 4, 4};
    values[5] = {2, 2, 2};
    CHECK(last_number() == "4");
    values.assign(values.size(), {std::nan(""), 0, 0});
    CHECK(last_number().find('+') == std::string::npos);
}

TEST_CASE("values at the corners of patches are those of smooth shading")
{
    for (const bool two_sided : {false, true}) {
        const Scene scene = shapes().scene(0.5, two_sided);
        std::vector<Rgb> values;
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            const double x = bits_to_unit(random_bits(1, patch));
            values.push_back({1.0 + x, 2.0 * x, patch + 1.0});
        }
        const CornerValues corners = corner_values(scene, values, 1);
        const std::vector<Rgb> found = corners_of_patches(scene, corners);
        const SmoothShading shading(scene, values, 1);
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
            for (std::size_t k = 0; k < scene.corners(patch).count; ++k)
                CHECK(found[4 * patch + k] == shading.at_corners(patch)[k]);
        // The floor has other values on the two sides of the wall: five or six points of its grid lie below it.
        CHECK(corners.own_places.size() >= 5);
        CHECK(corners.values.size() < 2 * scene.patch_count());
    }
}

TEST_CASE("a told line becomes a chain of points with the power along it")
{
    TracedLine line;
    line.points = {{0, 0, 0}, {1, 0, 0}, {1.0 / 3.0, 2, 3e-9}};
    line.joins = {false, true};
    line.crossings = {{{}, {1, 0, 0}, {}}};
    line.transfers = {{1, 7, 9, {0.5, 0.5, 0.5}, {1, 2, 3}, {1.5, 2.5, 4}, {}},
                      {1, 9, Segment::outside, {}, {4, 4, 4}, {4, 4, 4}, {}}};
    const Scene scene = small_scene();
    ViewerContent content = small_content(scene);
    StageTrace& chapter = content.chapters.emplace_back();
    chapter.context = {"All", "\"two\"."};
    chapter.lines = {line};
    CHECK(count(viewer_page(scene, content),
                "\"trace\": [\n    {\"note\": \"All \\\"two\\\".\", \"lines\": [\n    {"
                "\"points\": [0, 0, 0, 1, 0, 0, 0.333333, 2, 3e-09], \"joins\": [0, 1], \"crossings\": [1, 0, 0], "
                "\"transfers\": [\n    {\"from\": 7, \"to\": 9, \"forecast\": [0.5, 0.5, 0.5], \"held\": [1, 2, 3], "
                "\"gain\": [18, 20, 16]}, \n    {\"from\": 9, \"to\": null, \"forecast\": [0, 0, 0], "
                "\"held\": [4, 4, 4], \"gain\": [0, 0, 0]}]}]}]\n}\n") == 1);
}

} // namespace viewer_page_test

namespace packed_values_test {

using namespace multipath;

TEST_CASE("light of any brightness fits into 16 bits, to 11 binary digits of each channel")
{
    for (const double brightness : {1e-20, 1.0, 65504.0, 1e12}) {
        std::vector<Rgb> colours = {{brightness, 0.0, 0.5 * brightness}, {}};
        for (std::uint64_t n = 0; n < 1000; ++n) {
            const auto random = [&](std::uint64_t k) { return brightness * bits_to_unit(random_bits(n, k)); };
            colours.push_back({random(0), random(1), random(2)});
        }
        const PackedLight light = packed_light(colours);
        const std::vector<double> numbers = float16_array(light.halves);
        REQUIRE(numbers.size() == 3 * colours.size());
        CHECK(numbers[0] == largest_half);
        for (std::size_t n = 0; n < colours.size(); ++n) {
            const Rgb back = light.unit * Rgb{numbers[3 * n], numbers[3 * n + 1], numbers[3 * n + 2]};
            for (const auto& [a, b] : {std::pair{back.r, colours[n].r}, {back.g, colours[n].g}, {back.b, colours[n].b}})
                CHECK(std::abs(a - b) <= b / 2048 + 1e-9 * light.unit);
        }
    }
    CHECK(packed_light({{}, {}}).unit == 1.0);
}

} // namespace packed_values_test

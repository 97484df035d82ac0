#include "viewer/viewer_page.h"

#include "test_scenes.h"
#include "viewer/typed_array.h"

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
    ViewerQuantity radiosity{"radiosity", "Radiosity", "W/m²", ViewerColours::light, {}};
    ViewerQuantity number{"number", "Number", "1", ViewerColours::scale, {}};
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
        radiosity.values.push_back({1.0 + patch, 2.0, 3.0});
        const double value = patch == 3 ? std::numeric_limits<double>::quiet_NaN() : patch;
        number.values.push_back({value, value, value});
    }
    content.quantities = {radiosity, number};
    content.lines = 1000;
    content.stages = {{256, radiosity.values}};
    return content;
}

} // namespace

TEST_CASE("a page is complete in itself: its scripts and styles are in it, and nothing is loaded")
{
    const Scene scene = small_scene();
    const std::string page = viewer_page(scene, small_content(scene));
    CHECK(page.compare(0, std::string(viewer_page_begin).size(), viewer_page_begin) == 0);
    CHECK(count(page, "src=") == 0);
    CHECK(count(page, "<link rel=\"stylesheet\"") == 0);
    CHECK(count(page, "://") == 0);
    CHECK(count(page, "<!-- ") == 0);
    for (const char* name : {"style.css", "vector.js", "viewer.js"})
        CHECK(count(page, std::string(page_file(name))) == 1);
    CHECK_THROWS_AS(page_file("nothing.js"), std::logic_error);
}

TEST_CASE("the page knows every tone curve of pictures")
{
    const std::string script(page_file("viewer.js"));
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
    const std::vector<std::uint32_t> cells = uint32_array(text_of(json, "cells"));
    REQUIRE(triangles.size() == 7);
    REQUIRE(geometry.size() == 9 * 7);
    REQUIRE(cells.size() == 2 * 7);
    std::uint32_t first = 0;
    for (std::uint32_t s = 0; s < 7; ++s) {
        const Surface& surface = scene.surfaces()[s];
        CHECK(triangles[s] == (s == 6 ? 1 : 0));
        CHECK(geometry[9 * s + 1] == doctest::Approx(surface.origin.y)); // to the 24 bits of a float
        CHECK(geometry[9 * s + 3] == doctest::Approx(surface.edge_u.x));
        CHECK(geometry[9 * s + 8] == doctest::Approx(surface.edge_v.z));
        // From the cells follow the numbers of the patches.
        CHECK(scene.first_patch(s) == first);
        first += cells[2 * s] * cells[2 * s + 1];
    }
    CHECK(first == scene.patch_count());
    CHECK(uint32_array(text_of(json, "materials")) == scene.file().material);

    const std::vector<float> radiosity = float32_array(text_of(json, "values"));
    REQUIRE(radiosity.size() == 3 * scene.patch_count());
    CHECK(radiosity[3 * 5] == 6.0f);
    const std::vector<float> numbers = float32_array(text_of(json, "means"));
    REQUIRE(numbers.size() == scene.patch_count());
    CHECK(std::isnan(numbers[3]));
    CHECK(numbers[4] == 4.0f);
    CHECK(uint32_array(text_of(json, "light")).size() == scene.patch_count()); // of the stage
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
    values.assign(values.size(), {std::nan(""), 0, 0});
    CHECK(last_number().find('+') == std::string::npos);
}

} // namespace viewer_page_test

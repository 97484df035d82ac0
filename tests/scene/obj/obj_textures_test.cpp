#include "scene/obj/obj_textures.h"

#include "base/text_format.h"
#include "scene/input_problem.h"
#include "scene/obj/obj_reader.h"
#include "scene/scene.h"
#include "scene/scratch_folder.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <doctest/doctest.h>
#include <filesystem>
#include <utility>
#include <vector>

namespace obj_textures_test {

using namespace multipath;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// White and black, 2 x 1.
const std::string halves = "P3 2 1 255\n255 255 255 0 0 0\n";
const std::string square = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

struct Files
{
    ScratchFolder folder;

    SceneFile read(const std::string& obj, const std::string& mtl, const ObjChanges& changes = {}) const
    {
        folder.write("room.mtl", mtl);
        return read_obj(folder.write("room.obj", "mtllib room.mtl\nusemtl m\n" + obj), changes);
    }
};

bool any_contains(const std::vector<std::string>& texts, const std::string& part)
{
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

} // namespace

TEST_CASE("a patch reflects the mean of its part of the texture times Kd, a material that of its surfaces")
{
    Files files;
    files.folder.write("a.ppm", halves);
    const SceneFile file = files.read(square + "f 1/1 2/2 3/3 4/4\n", "newmtl m\nKe 1\nKd 0.5 0.4 0.2\nmap_Kd a.ppm\n");
    REQUIRE(file.surfaces.size() == 1);
    CHECK(file.materials[0].reflectance.r == doctest::Approx(0.25));
    CHECK(file.materials[0].reflectance.b == doctest::Approx(0.1));
    const Scene scene(file, 0.5);
    REQUIRE(scene.patch_count() == 8);
    for (std::uint32_t i = 0; i < 8; ++i)
        CHECK(scene.reflectance(i).g == doctest::Approx(scene.patch(i).shape.centre().x < 1.0 ? 0.4 : 0.0));
    CHECK(scene.average_reflectance().r == doctest::Approx(0.25));
    CHECK(scene.reflectance_at(0, 0.25, 0.5).r == doctest::Approx(0.5));
    const Scene fine = scene.refined(std::vector<std::uint8_t>(32, 1));
    CHECK(fine.reflectance(0).r == doctest::Approx(0.5));
    CHECK(fine.hash() != scene.hash());
    // Turned over, the same points of the face show the same.
    const Scene back(flipped(file), 0.5);
    for (std::uint32_t i = 0; i < 8; ++i)
        CHECK(back.reflectance(i).g == doctest::Approx(back.patch(i).shape.centre().x < 1.0 ? 0.4 : 0.0));
}

// A texture that repeats looks the same whole images away, as far as there are places on a map.
TEST_CASE("texture coordinates of any size show their part of the texture, or of its opacity")
{
    Files files;
    files.folder.write("a.ppm", halves);
    for (const int offset : {0, 70000, 4649776, -999999999}) {
        CAPTURE(offset);
        std::string obj = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n";
        for (const auto& [s, t] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            obj += "vt " + std::to_string(offset + s) + " " + std::to_string(offset + t) + "\n";
        obj += "f 1/1 2/2 3/3 4/4\n";
        const Scene scene(files.read(obj, "newmtl m\nKe 1\nmap_Kd a.ppm\n"), 0.5);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            CHECK(scene.reflectance(i).g == doctest::Approx(scene.patch(i).shape.centre().x < 1.0 ? 1.0 : 0.0));
        const SceneFile cut = files.read(obj, "newmtl m\nKe 1\nKd 0.5\nmap_D a.ppm\n");
        REQUIRE(cut.surfaces.size() == 1);
        CHECK(cut.surfaces[0].shape == Shape::parallelogram);
        CHECK(cut.surfaces[0].area() == doctest::Approx(1.0));
        CHECK(cut.surfaces[0].centre().x == doctest::Approx(0.5));
    }
}

TEST_CASE("triangles are joined where their textures are, too, and quads are cut where theirs is not straight")
{
    Files files;
    files.folder.write("a.ppm", halves);
    const std::string mtl = "newmtl m\nKe 1\nKd 1\nmap_Kd a.ppm\n";
    CHECK(files.read(square + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n", mtl).surfaces.size() == 1);
    CHECK(files.read(square + "f 1/1 2/2 3/3\nf 1/2 3/3 4/4\n", mtl).surfaces.size() == 2);
    CHECK(files.read(square + "vt 3 3\nf 1/1 2/2 3/5 4/4\n", mtl).surfaces.size() == 2);
    CHECK(files.read(square + "vt 3 3\nf 1/1 2/2 3/5 4/4\n", "newmtl m\nKe 1\nKd 1\n").surfaces.size() == 1);
    const SceneFile joined = files.read(square + "f 3/3 1/1 2/2\nf 4/4 1/1 3/3\n", mtl);
    const Scene scene(joined, 0.5);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        CHECK(scene.reflectance(i).g == doctest::Approx(scene.patch(i).shape.centre().x < 1.0 ? 1.0 : 0.0));
}

TEST_CASE("scale, offset, clamp, blanks, case, folders of other machines, and names like options are understood")
{
    Files files;
    files.folder.write("My Wood.PPM", halves);
    const auto mean_of_left = [&](const std::string& map) {
        const SceneFile file = files.read(square + "f 1/1 2/2 3/3 4/4\n", "newmtl m\nKe 1\nKd 1\n" + map + "\n");
        CHECK(file.textures.size() == 1);         // found
        return Scene(file, 1.0).reflectance(0).g; // s from 0 to 0.5
    };
    CHECK(mean_of_left("map_Kd my wood.ppm") == doctest::Approx(1.0));
    CHECK(mean_of_left("map_kd my wood.ppm") == doctest::Approx(1.0));
    CHECK(mean_of_left("map_Kd \"my wood.ppm\"") == doctest::Approx(1.0));
    CHECK(mean_of_left("map_Kd C:\\Users\\me\\Textures\\My Wood.ppm") == doctest::Approx(1.0));
    CHECK(mean_of_left("map_Kd my wood.ppm # of oak") == doctest::Approx(1.0));
    CHECK(mean_of_left("map_Kd -s 2 2 1 my wood.ppm") == doctest::Approx(0.5));
    CHECK(mean_of_left("map_Kd -o 0.5 0 my wood.ppm") == doctest::Approx(0.0));
    CHECK(mean_of_left("map_Kd -s 2 -o 0.5 0 0 -blendu on -mm -0.5 1 -bm 0.3 my wood.ppm") == doctest::Approx(0.5));
    CHECK(mean_of_left("map_Kd -o 1 -clamp on my wood.ppm") == doctest::Approx(0.0));
    CHECK(mean_of_left("map_Kd -o 1 -clamp off my wood.ppm") == doctest::Approx(1.0));
}

TEST_CASE("what is not read is told with its weight, and Kd stands alone")
{
    Files files;
    files.folder.write("bad.png", "\x89PNG\r\n\x1a\nrubbish");
    files.folder.write("a.ppm", halves);
    const std::string two =
        square + "f 1/1 2/2 3/3 4/4\nusemtl n\nv 0 0 1\nv 2 0 1\nv 2 3 1\nv 0 3 1\nf 5/1 6/2 7/3 8/4\n";
    const SceneFile file = files.read(two, "newmtl m\nKe 1\nKd 0.3\nmap_Kd none.jpg\nnewmtl n\nKd 0\nmap_Kd a.ppm\n");
    CHECK(any_contains(file.warnings, "1 texture not read"));
    CHECK(any_contains(file.warnings, "(25 % of the area)"));
    CHECK(any_contains(file.warnings, "`m` (none.jpg: not found)"));
    CHECK(any_contains(file.warnings, "0 beside a texture, which counts alone: Kd of `n`"));
    CHECK(file.materials[0].reflectance == Rgb{0.3, 0.3, 0.3});
    CHECK(file.materials[1].reflectance.r == doctest::Approx(0.5));
    const SceneFile damaged = files.read(square + "f 1 2 3 4\n", "newmtl m\nKe 1\nKd 0.3\nmap_Kd bad.png\n");
    CHECK(any_contains(damaged.warnings, "`m` (bad.png: "));
    // Without texture points the mean of all stands in.
    const SceneFile flat = files.read(square + "f 1 2 3 4\n", "newmtl m\nKe 1\nKd 0.8\nmap_Kd a.ppm\n");
    CHECK(Scene(flat, 0.5).reflectance(0).g == doctest::Approx(0.4));
}

TEST_CASE("options of a texture that have no effect are told")
{
    Files files;
    files.folder.write("a.ppm", halves);
    const auto told = [&](const std::string& options) {
        const SceneFile file =
            files.read(square + "f 1/1 2/2 3/3 4/4\n", "newmtl m\nKe 1\nmap_Kd " + options + " a.ppm\n");
        CHECK(file.materials[0].reflectance.r == doctest::Approx(0.5));
        for (const std::string& warning : file.warnings)
            if (const std::size_t colon = warning.find("ignored: "); colon != std::string::npos)
                return warning.substr(colon + 9);
        return std::string();
    };
    CHECK(told("-mm 0.1 0.5") == "`map_Kd -mm`");
    CHECK(told("-s 1 1 1 -o 0 0 0 -clamp off") == "");
    CHECK(told("-imfchan r -cc on -t 0.1") == "`map_Kd -imfchan`, `map_Kd -cc`, `map_Kd -t`");
}

TEST_CASE("a refusal names textures that are not read")
{
    Files files;
    const std::string cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                             "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";
    const auto problem = [&](const std::string& mtl) { return problem_of([&] { files.read(cube, mtl); }); };
    const std::string names = "textures that are not read: `m` (my%20wood.png: not found)";
    CHECK(contains(problem("newmtl m\nKd 0.5\nmap_Ke my%20wood.png\n"), names));
    CHECK_FALSE(contains(problem("newmtl m\nKd 0.5\n"), "textures"));
}

// Of sRGB 0.5 the nearest of 256 levels is 128, whose linear light is 0.2159 (IEC 61966-2-1).
TEST_CASE("colours of vertices multiply Kd where a material has no texture")
{
    Files files;
    files.folder.write("a.ppm", halves);
    const std::string corners =
        "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 1 0 0\n"
        "v 1 0 1 1 1 1\nv 2 0 1 1 1 1\nv 2 1 1 0 0 0.5\nv 1 1 1 0 0 0.5\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
    const std::string faces = "f 1/1 2/2 3/3 4/4\nf 5/1 6/2 7/3 8/4\n";
    const auto reflectances = [](const SceneFile& file) {
        const Scene scene(file, 2.0);
        return std::vector<Rgb>{scene.reflectance(0), scene.reflectance(1)};
    };
    const SceneFile file = files.read(corners + faces, "newmtl m\nKe 1\nKd 0.5\n");
    CHECK(any_contains(file.warnings, "the colours of vertices, decoded from sRGB, multiply Kd; a surface"));
    const std::vector<Rgb> both = reflectances(file);
    CHECK(both[0] == Rgb{0.5, 0, 0});
    // Half a step of sRGB at linear light 0.5 is 0.0025.
    CHECK(both[1].r == doctest::Approx(0.5 * 0.5).epsilon(0.01));
    CHECK(both[1].b == doctest::Approx(0.5 * (1.0 + 0.214) / 2).epsilon(0.01));
    CHECK(file.materials[0].reflectance.r == doctest::Approx(0.5 * (both[0].r + both[1].r)));
    CHECK(reflectances(flipped(file))[1] == both[1]);

    // White changes nothing.
    const SceneFile red = files.read(corners + "f 1 2 3 4\n", "newmtl m\nKe 1\nKd 0.5\n");
    CHECK(red.materials[0].reflectance == Rgb{0.5, 0, 0});
    const SceneFile white =
        files.read("v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n", "newmtl m\nKe 1\nKd 0.5\n");
    CHECK(white.materials[0].reflectance == Rgb{0.5, 0.5, 0.5});
    CHECK(white.warnings.empty());

    // A texture takes precedence; a missing Kd or material counts as 1.
    CHECK(reflectances(files.read(corners + faces, "newmtl m\nKe 1\nKd 0.5\nmap_Kd a.ppm\n"))[0].g ==
          doctest::Approx(0.25));
    CHECK(reflectances(files.read(corners + faces, "newmtl m\nKe 1\n"))[0] == Rgb{1, 0, 0});
    ObjChanges sky;
    sky.lit_from_outside = true;
    const SceneFile unknown = files.read(corners + "v 0 0 2\nv 1 0 2\nv 0 1 2\n" + faces + "f -3 -2 -1\n", "", sky);
    CHECK(unknown.unknown_materials.empty());
    CHECK(unknown.textures.size() == 1);
    SceneFile lit = unknown;
    lit.sun = Sun{{0, 0, 1}, {1, 1, 1}};
    const Scene scene(lit, 2.0);
    CHECK(scene.reflectance(0) == Rgb{1, 0, 0});
    CHECK(scene.reflectance(2).r == doctest::Approx(0.5).epsilon(0.01)); // no colours: grey
}

TEST_CASE("triangles are joined only if their vertices give them the same colour")
{
    Files files;
    const auto surfaces = [&](const std::string& colour) {
        const SceneFile file =
            files.read("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nv 0 1 0 " + colour + "\nf 1 2 3\nf 1 3 4\n",
                       "newmtl m\nKe 1\nKd 0.5\n");
        return file.surfaces.size();
    };
    CHECK(surfaces("1 0 0") == 1);
    CHECK(surfaces("0 1 0") == 2);
}

TEST_CASE("map_Ke times Ke is the mean of a lamp")
{
    Files files;
    files.folder.write("a.ppm", halves);
    const std::string face = square + "f 1/1 2/2 3/3 4/4\n";
    CHECK(files.read(face, "newmtl m\nKd 0\nKe 6 4 2\nmap_Ke a.ppm\n").materials[0].emittance.r ==
          doctest::Approx(3.0));
    for (const char* keyword : {"map_Ke", "map_ke"})
        CHECK(files.read(face, std::string("newmtl m\nKd 0\n") + keyword + " a.ppm\n").materials[0].emittance.r ==
              doctest::Approx(0.5));
    const SceneFile dark = files.read(face, "newmtl m\nKd 0\nKe 0 0 0\nmap_Ke a.ppm\n");
    CHECK(dark.materials[0].emittance.r == doctest::Approx(0.5));
    CHECK(any_contains(dark.warnings, "0 beside a texture, which counts alone: Ke of `m`"));
    ObjChanges lamp;
    lamp.lamps = {{"m", {7, 7, 7}}};
    CHECK(files.read(face, "newmtl m\nKd 0\nKe 1\nmap_Ke a.ppm\n", lamp).materials[0].emittance.r == 7.0);
    lamp = {};
    lamp.reflectance_limit = 0.5;
    const SceneFile limited = files.read(face, "newmtl m\nKe 1\nmap_Kd a.ppm\n", lamp);
    CHECK(Scene(limited, 1.0).reflectance(0).r == doctest::Approx(0.5));
}

// Every face lies within one pixel of each map, so its colour is that of the pixel. The faces of two materials differ
// in area; the points of their corners are a thousandth apart.
TEST_CASE("a material has the mean over its area of each of its maps, with the scale and offset of that map")
{
    const Bytes kd_pixels = {90, 60, 0, 200, 130, 70, 30, 250, 0, 160, 80, 40, 20, 10, 50, 220, 110, 140};
    const Bytes ke_pixels = {0, 55, 250, 0, 35, 120, 0, 210, 65, 0, 75, 180, 0, 45, 95, 0, 240, 150};
    Files files;
    files.folder.write("kd.ppm", "P6 3 2 255\n" + std::string(kd_pixels.begin(), kd_pixels.end()));
    files.folder.write("ke.ppm", "P6 2 3 255\n" + std::string(ke_pixels.begin(), ke_pixels.end()));
    const auto pixel = [](const Bytes& pixels, int width, double s, double t) {
        const int height = 6 / width;
        const int column = static_cast<int>(std::floor(width * (s - std::floor(s))));
        const int row = height - 1 - static_cast<int>(std::floor(height * (t - std::floor(t))));
        return linear_colour(pixels.data() + 3 * (row * width + column));
    };
    std::string obj;
    std::array<Rgb, 2> reflected, emitted; // by material: area times colour
    std::array<double, 2> areas = {};
    for (int k = 0; k < 9; ++k) {
        const std::size_t m = k % 3 == 1 ? 1 : 0;
        const double width = 0.3 + 0.37 * (k * k % 5);
        const double height = 1.9 - 0.23 * k;
        const bool triangle = k % 2 == 1;
        const double s = -1.37 + 0.473 * k;
        const double t = 2.21 - 0.719 * k;
        obj += m == 0 ? "usemtl m\n" : "usemtl n\n";
        for (const auto& [x, z] : {std::pair{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}})
            obj += format("v %.17g %d %.17g\nvt %.17g %.17g\n", x, k, z, s + 1e-3 * x, t + 1e-3 * z);
        obj += triangle ? "f -4/-4 -3/-3 -2/-2\n" : "f -4/-4 -3/-3 -2/-2 -1/-1\n";
        const double area = (triangle ? 0.5 : 1.0) * width * height;
        areas[m] += area;
        reflected[m] +=
            area * (m == 0 ? pixel(kd_pixels, 3, 0.6 * s + 0.17, 1.7 * t - 0.4) : pixel(kd_pixels, 3, s, t));
        emitted[m] += area * (m == 0 ? pixel(ke_pixels, 2, s, 0.8 * t) : pixel(ke_pixels, 2, 1.3 * s, t + 0.29));
    }
    const SceneFile file = files.read(obj, "newmtl m\nKd 0.9 0.8 0.6\nmap_Kd -s 0.6 1.7 -o 0.17 -0.4 kd.ppm\n"
                                           "Ke 3 5 7\nmap_Ke -s 1 0.8 ke.ppm\n"
                                           "newmtl n\nKd 0.5 0.7 1\nmap_Kd kd.ppm\n"
                                           "Ke 2 4 6\nmap_Ke -s 1.3 1 -o 0 0.29 ke.ppm\n");
    for (const std::size_t m : {0u, 1u}) {
        const Rgb kd = m == 0 ? Rgb{0.9, 0.8, 0.6} : Rgb{0.5, 0.7, 1.0};
        const Rgb ke = m == 0 ? Rgb{3, 5, 7} : Rgb{2, 4, 6};
        const Rgb expected = kd * (1.0 / areas[m] * reflected[m]);
        const Rgb light = ke * (1.0 / areas[m] * emitted[m]);
        for (double Rgb::*c : {&Rgb::r, &Rgb::g, &Rgb::b}) {
            CHECK(file.materials[m].reflectance.*c == doctest::Approx(expected.*c));
            CHECK(file.materials[m].emittance.*c == doctest::Approx(light.*c));
        }
    }
}

// White, as far as Kd is concerned, are also faces of the material without colours. A fifth of sRGB is 51 of 255.
TEST_CASE("a material has the mean over its area of the colours of its vertices")
{
    const Files files;
    const std::array<std::array<int, 3>, 4> fifths = {{{5, 0, 2}, {1, 0, 4}, {5, 5, 5}, {3, 0, 1}}};
    std::string obj = "v 0 9 0\nv 1 9 0\nv 0 9 1\nusemtl lamp\nf -3 -2 -1\nusemtl m\n";
    Rgb sum;
    double areas = 0.0;
    for (std::size_t k = 0; k < fifths.size(); ++k) {
        const double width = 0.4 + 1.1 * static_cast<double>(k);
        std::string colour;
        std::array<std::uint8_t, 3> bytes{};
        for (std::size_t c = 0; c < 3; ++c) {
            colour += format(" %g", fifths[k][c] / 5.0);
            bytes[c] = static_cast<std::uint8_t>(51 * fifths[k][c]);
        }
        for (const char* z : {"0", "1.5"})
            for (const double x : {0.0, width})
                obj += format("v %g %zu %s", x, k, z) + (k == 2 ? "" : colour) + "\n";
        obj += k % 2 == 0 ? "f -4 -3 -1 -2\n" : "f -4 -3 -1\n";
        const double area = (k % 2 == 0 ? 1.5 : 0.75) * width;
        sum += area * linear_colour(bytes.data());
        areas += area;
    }
    const SceneFile file = files.read(obj, "newmtl lamp\nKd 0\nKe 1\nnewmtl m\nKd 0.9 0.7 0.4\n");
    const Rgb expected = Rgb{0.9, 0.7, 0.4} * (1.0 / areas * sum);
    for (double Rgb::*c : {&Rgb::r, &Rgb::g, &Rgb::b})
        CHECK(file.materials[1].reflectance.*c == doctest::Approx(expected.*c));
}

TEST_CASE("texture points that do not exist, count back, or are no numbers do no harm")
{
    Files files;
    files.folder.write("a.ppm", halves);
    const std::string mtl = "newmtl m\nKe 1\nKd 1\nmap_Kd a.ppm\n";
    const auto reflectance = [&](const std::string& obj) { return Scene(files.read(obj, mtl), 1.0).reflectance(0).g; };
    CHECK(reflectance(square + "f 1/-4 2/-3 3/-2 4/-1\n") == doctest::Approx(1.0));
    const Scene halved(files.read(square + "f 1/1 2/2 3/3 4/99\n", mtl), 1.0); // two triangles, one with all its points
    CHECK(halved.reflectance(halved.patch_count() - 1).g == doctest::Approx(0.5));
    CHECK(reflectance(square + "f 1/0 2/0 3/0 4/0\n") == doctest::Approx(0.5));
    CHECK(reflectance("vt x y\nvt nan 1e999\n" + square + "f 1/1 2/2 3/1 4/2\n") >= 0.0);
    CHECK(reflectance(square + "f 1// 2// 3// 4//\n") == doctest::Approx(0.5));
}

} // namespace obj_textures_test

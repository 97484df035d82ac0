#include "scene/obj/cutouts.h"

#include "scene/input_problem.h"
#include "scene/obj/obj_reader.h"
#include "scene/scene.h"
#include "scene/scratch_folder.h"

#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <string>
#include <vector>

namespace cutouts_test {

using namespace multipath;

namespace {

struct Files
{
    ScratchFolder folder;

    SceneFile read(const std::string& obj, const std::string& mtl, const ObjChanges& changes = {}) const
    {
        folder.write("room.mtl", mtl);
        return read_obj(folder.write("room.obj", "mtllib room.mtl\nusemtl m\n" + obj), changes);
    }
};

const std::string square = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const std::string quad = "f 1/1 2/2 3/3 4/4\n";

/// A face elsewhere, so that the scene is not empty if the others are transparent.
const std::string elsewhere = "usemtl n\nv 100 0 0\nv 101 0 0\nv 100 1 0\nf -3 -2 -1\n";

/// Rows from the top; `#` is opaque.
std::string pgm(const std::vector<std::string>& rows)
{
    std::string text = "P2 " + std::to_string(rows[0].size()) + " " + std::to_string(rows.size()) + " 255\n";
    for (const std::string& row : rows)
        for (const char c : row)
            text += c == '#' ? "128 " : "127 ";
    return text;
}

double area(const SceneFile& file)
{
    double sum = 0.0;
    for (const Surface& surface : file.surfaces)
        sum += surface.area();
    return sum;
}

/// The surfaces in the plane z = 0 that contain a point.
std::vector<std::size_t> surfaces_at(const SceneFile& file, double x, double y)
{
    std::vector<std::size_t> found;
    for (std::size_t s = 0; s < file.surfaces.size(); ++s) {
        const Surface& p = file.surfaces[s];
        const double determinant = p.edge_u.x * p.edge_v.y - p.edge_u.y * p.edge_v.x;
        const double u = ((x - p.origin.x) * p.edge_v.y - (y - p.origin.y) * p.edge_v.x) / determinant;
        const double v = (p.edge_u.x * (y - p.origin.y) - p.edge_u.y * (x - p.origin.x)) / determinant;
        if (u >= 0.0 && v >= 0.0 && (p.shape == Shape::triangle ? u + v <= 1.0 : u <= 1.0 && v <= 1.0))
            found.push_back(s);
    }
    return found;
}

const std::vector<std::string> leaf = {"..#....", ".####..", "#.###.#", "..##...", "..#...."};

} // namespace

// The area is that of the opaque pixels, and a point belongs to one surface if its pixel is opaque, else to none.
// Random points are not on borders of pixels.
TEST_CASE("of a face those parts remain whose pixels are opaque, however the texture lies")
{
    std::mt19937 random(1);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    Files files;
    files.folder.write("mask.pgm", pgm(leaf));
    for (int trial = 0; trial < 40; ++trial) {
        CAPTURE(trial);
        const bool triangle = trial % 2 == 0;
        const bool clamps = trial % 5 == 0;
        // A texture point is o + u a + v b at (u, v) of the face.
        const TexturePoint o = {number(-2, 2), number(-2, 2)};
        const TexturePoint a = {number(-2, 2), number(-2, 2)};
        const TexturePoint b = {number(-2, 2), number(-2, 2)};
        const auto at = [&](double u, double v) {
            return TexturePoint{o.s + u * a.s + v * b.s, o.t + u * a.t + v * b.t};
        };
        std::string obj = "v 0 0 0\nv 2 0.5 0\nv 2.25 2.5 0\nv 0.25 2 0\n";
        for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
            char line[80];
            std::snprintf(line, sizeof line, "vt %.17g %.17g\n", at(u, v).s, at(u, v).t);
            obj += line;
        }
        const SceneFile file = files.read(obj + (triangle ? "f 1/1 2/2 4/4\n" : quad) + elsewhere,
                                          std::string("newmtl m\nKe 1\nKd 0.5\nmap_d ") + (clamps ? "-clamp on " : "") +
                                              "-o 0.125 0 mask.pgm\nnewmtl n\nKe 1\nKd 0.5\n");
        double wrong = 0.0;
        for (int k = 0; k < 300; ++k) {
            double u = number(0, 1);
            double v = number(0, 1);
            if (triangle && u + v > 1.0) {
                u = 1.0 - u;
                v = 1.0 - v;
            }
            const auto pixel = [&](double s, std::size_t n) {
                const double inside = clamps ? std::min(std::max(s, 0.0), 0.9999) : s - std::floor(s);
                return static_cast<std::size_t>(inside * static_cast<double>(n));
            };
            const std::size_t column = pixel(at(u, v).s + 0.125, leaf[0].size());
            const std::size_t row = leaf.size() - 1 - pixel(at(u, v).t, leaf.size());
            const std::size_t expected = leaf[row][column] == '#' ? 1 : 0;
            wrong += surfaces_at(file, 2 * u + 0.25 * v, 0.5 * u + 2 * v).size() == expected ? 0 : 1;
        }
        CHECK(wrong == 0);
        for (const Surface& surface : file.surfaces)
            CHECK(surface.normal().z == doctest::Approx(1.0));
    }
}

TEST_CASE("areas are those of the opaque pixels, and textures stay where they are")
{
    Files files;
    files.folder.write("mask.pgm", pgm(leaf));
    files.folder.write("colours.ppm", "P3 2 2 255\n255 0 0 0 255 0\n0 0 255 255 255 255\n");
    const SceneFile file = files.read(square + quad, "newmtl m\nKe 1\nKd 0.5\nmap_Kd colours.ppm\nmap_d mask.pgm\n");
    CHECK(area(file) == doctest::Approx(2.0 * 13.0 / 35.0).epsilon(1e-12));
    const Scene scene(file, 0.01);
    for (std::uint32_t i = 0; i < scene.patch_count(); i += 7) {
        const Vec3 centre = scene.patch(i).shape.centre();
        if (std::abs(centre.x - 1.0) < 0.02 || std::abs(centre.y - 0.5) < 0.02)
            continue;
        const bool right = centre.x > 1.0, low = centre.y < 0.5;
        CHECK(scene.reflectance(i).r == doctest::Approx(right == low ? 0.5 : 0.0));
        CHECK(scene.reflectance(i).g == doctest::Approx(right ? 0.5 : 0.0));
        CHECK(scene.reflectance(i).b == doctest::Approx(low ? 0.5 : 0.0));
    }
    CHECK(contains(file.warnings.at(0), "transparent parts of `m` (mask.pgm) are cut out"));
}

TEST_CASE("the opacity is that of map_Kd if there is no map_d, and below one half is transparent")
{
    Files files;
    // 2 x 1 pixels, blue, green, red, opacity: one half and just below
    const std::string tga =
        std::string("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x20\x28", 18) + "\x80\x80\x80\x80\x80\x80\x80\x7f";
    files.folder.write("a.tga", tga);
    const SceneFile file = files.read(square + quad, "newmtl m\nKe 1\nKd 0.5\nmap_Kd a.tga\n");
    CHECK(area(file) == doctest::Approx(1.0));
    CHECK(surfaces_at(file, 0.5, 0.5).size() == 1);
    files.folder.write("left_gone.pgm", pgm({".#"}));
    const SceneFile other = files.read(square + quad, "newmtl m\nKe 1\nKd 0.5\nmap_Kd a.tga\nmap_d left_gone.pgm\n");
    CHECK(surfaces_at(other, 1.5, 0.5).size() == 1);
    CHECK(surfaces_at(other, 0.5, 0.5).empty());
}

TEST_CASE("the brightness of a map_d counts, whichever its colour")
{
    Files files;
    files.folder.write("grey.pgm", pgm({"#.", ".#"}));
    const std::string mtl = "newmtl m\nKe 1\nKd 0.5\nmap_d ";
    const SceneFile grey = files.read(square + quad, mtl + "grey.pgm\n");
    for (std::size_t first = 0; first < 3; ++first) {
        CAPTURE(first);
        std::string image = "P3 2 2 255\n";
        // The channels add up to 384 where it is opaque, else to 383.
        for (const std::vector<int>& colour :
             {std::vector{30, 150, 204}, {255, 100, 28}, {240, 80, 63}, {110, 20, 254}})
            for (std::size_t c = 0; c < 3; ++c)
                image += std::to_string(colour[(first + c) % 3]) + " ";
        files.folder.write("coloured.ppm", image);
        CHECK(files.read(square + quad, mtl + "coloured.ppm\n").surfaces == grey.surfaces);
    }
}

TEST_CASE("opaque faces stay as they are, transparent ones are left out, and those without coordinates stay")
{
    Files files;
    files.folder.write("half.pgm", pgm({"#."}));
    files.folder.write("none.pgm", pgm({"."}));
    const std::string mtl = "newmtl m\nKe 1\nKd 0.5\nmap_d half.pgm\n";
    const std::string points = square + "vt 0.5 0\nvt 0.5 1\n";
    const SceneFile opaque = files.read(points + "f 1/1 2/5 3/6 4/4\n", mtl);
    const SceneFile plain = files.read(points + "f 1/1 2/5 3/6 4/4\n", "newmtl m\nKe 1\nKd 0.5\n");
    CHECK(opaque.surfaces == plain.surfaces);
    CHECK(opaque.warnings.empty());
    const SceneFile both = files.read(points + "f 1/1 2/5 3/6 4/4\nf 1/5 2/2 3/3 4/6\n", mtl);
    CHECK(both.surfaces == plain.surfaces);
    CHECK(contains(both.warnings.at(0), "are cut out: 0 surfaces instead of 1"));
    const SceneFile bare = files.read(square + "f 1 2 3 4\n", mtl);
    CHECK(bare.surfaces == plain.surfaces);
    CHECK(contains(bare.warnings.at(0), "stay opaque for lack of texture coordinates: 1 surface"));
    CHECK(contains(problem_of([&] { files.read(square + quad, "newmtl m\nKe 1\nKd 0.5\nmap_d none.pgm\n"); }),
                   "every face is transparent"));
}

TEST_CASE("lamps, groups and lines of the file belong to the parts of a face")
{
    Files files;
    files.folder.write("mask.pgm", pgm(leaf));
    const SceneFile file = files.read("o tree\ng twig\n" + square + quad, "newmtl m\nKd 0.5\nmap_d mask.pgm\n",
                                      {{{"tree", {3, 3, 3}}}, {}});
    REQUIRE(file.surfaces.size() > 5);
    for (std::size_t s = 0; s < file.surfaces.size(); ++s) {
        CHECK(file.materials[file.material[s]].emittance == Rgb{3, 3, 3});
        CHECK(file.is_named(s, "twig"));
        CHECK(file.line[s] == 13);
    }
}

// Of 512 x 512 random pixels about 60,000 rectangles would remain. A pixel of 2 x 2 is opaque if two or more of its
// four are, which has the probability 11/16; the share of 256 x 256 of them has a standard deviation of 0.0018.
TEST_CASE("a mask that would make too many surfaces is made coarser, and that is told")
{
    Files files;
    std::mt19937 random(2);
    std::vector<std::string> noise(512, std::string(512, '.'));
    for (std::string& row : noise)
        for (char& c : row)
            c = random() % 2 == 0 ? '#' : '.';
    files.folder.write("noise.pgm", pgm(noise));
    const SceneFile file = files.read(square + quad, "newmtl m\nKe 1\nKd 0.5\nmap_d noise.pgm\n");
    CHECK(file.surfaces.size() <= 32768);
    CHECK(area(file) == doctest::Approx(2.0 * 11.0 / 16.0).epsilon(4 * 0.0018));
    CHECK(contains(file.warnings.at(0), "by a coarser mask of 256 x 256 pixels"));
    // The transparent border of a clamped image goes on around it, on three quarters of the face.
    for (std::size_t k = 0; k < noise.size(); ++k)
        noise[k] = k < 16 || k >= 496 ? std::string(512, '.')
                                      : std::string(16, '.') + noise[k].substr(16, 480) + std::string(16, '.');
    files.folder.write("noise.pgm", pgm(noise));
    const SceneFile clamped =
        files.read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt -0.5 0\nvt 1.5 0\nvt 1.5 2\nvt -0.5 2\n" + quad,
                   "newmtl m\nKe 1\nKd 0.5\nmap_d -clamp on noise.pgm\n");
    const double inner = 480.0 / 512.0;
    CHECK(area(clamped) == doctest::Approx(2.0 / 4.0 * inner * inner * 11.0 / 16.0).epsilon(4 * 0.0018));
    CHECK(contains(clamped.warnings.at(0), "by a coarser mask of 256 x 256"));
    // A million repetitions are too many to visit.
    files.folder.write("mask.pgm", pgm(leaf));
    const SceneFile wide =
        files.read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 1e6 0\nvt 1e6 1e6\nvt 0 1e6\n" + quad + elsewhere,
                   "newmtl m\nKe 1\nKd 0.5\nmap_d mask.pgm\nnewmtl n\nKe 1\nKd 0.5\n");
    CHECK(wide.surfaces.size() == 1);
    CHECK(contains(wide.warnings.at(0), "0 surfaces instead of 1, by a coarser mask of 1 x 1"));
}

} // namespace cutouts_test

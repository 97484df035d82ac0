// Forty small files with the traps of the format, each with what must come of it.

#include "scene/input_problem.h"
#include "scene/obj/mesh_pieces.h"
#include "scene/obj/obj_reader.h"
#include "scene/obj/parallelogram_merge.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace obj_fixtures_test {

using namespace multipath;

namespace {

std::string fixture(const std::string& name)
{
    return "tests/fixtures/obj/" + name + ".obj";
}

Rgb emitted_power(const SceneFile& scene)
{
    Rgb power;
    for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
        power += scene.surfaces[i].area() * scene.materials[scene.material[i]].emittance;
    return power;
}

double total_area(const SceneFile& scene)
{
    double area = 0.0;
    for (const Surface& surface : scene.surfaces)
        area += surface.area();
    return area;
}

/// Of the mesh alone: most fixtures have no light, so that read_obj must refuse them.
double area_without_light(const ObjMesh& mesh)
{
    const SceneScale scale = scale_of(mesh);
    LargeVector<Piece> pieces = cut_into_pieces(mesh, scale).pieces;
    merge_triangles(pieces, mesh, scale);
    double area = 0.0;
    for (const Piece& piece : pieces) {
        const Vec3 origin = mesh.at(piece.corners[0]);
        const Vec3 u = mesh.at(piece.corners[1]) - origin;
        const Vec3 v = mesh.at(piece.end_of_v()) - origin;
        area += (piece.is_triangle() ? 0.5 : 1.0) * length(cross(u, v));
    }
    return area;
}

struct Loads
{
    std::string name;
    double area;
    double power; ///< of each channel; 0: no light
    std::size_t surfaces;
};

struct Fails
{
    std::string name;
    std::string message; ///< a part of it, from the line number on
};

// Two triangles of a unit square with one corner lifted by 1, cut along the diagonal from the first corner to the
// third.
const double bent_quad = 2.0 * std::sqrt(2.0) / 2.0;
// A round polygon of 3000 corners on the unit circle; the file has six decimals, so 1e-6 is what to expect.
const double big_polygon = 1500.0 * std::sin(2.0 * std::acos(-1.0) / 3000.0);

const std::vector<Loads> loads = {
    {"01_plain", 1, 5, 1},
    {"02_neg", 1, 5, 1},
    {"03_neg_interleaved", 2, 10, 2},
    {"08_crlf", 1, 5, 1},
    {"09_cr_only", 1, 5, 1},
    {"10_bom", 1, 5, 1},
    {"11_backslash", 1, 5, 1},
    {"13_mtl_space", 1, 5, 1},
    {"14_concave", 10, 0, 3},
    {"15_concave_first_reflex", 4, 0, 2},
    {"18_sci", 1, 0, 1},
    {"20_two_vertex_face", 0.5, 0, 1},
    {"21_dup_vertex_face", 0.5, 0, 1},
    {"22_trailing_no_newline", 1, 0, 1},
    {"23_tabs_comment", 1, 0, 1},
    {"24_vcolor", 0.5, 0, 1},
    {"25_w", 2, 0, 1},
    {"26_usemtl_space", 1, 5, 1},
    {"27_usemtl_trailing_ws", 1, 5, 1},
    {"28_face_before_vertex", 0.5, 0, 1},
    {"33_big_polygon", big_polygon, 0, 2998},
    {"34_nonplanar", bent_quad, 0, 2},
    {"35_mtl_case", 1, 5, 1},
    {"36_mtl_backslash_path", 1, 5, 1},
    {"37_ke_single", 1, 3, 1},
    {"39_mtl_quoted", 1, 5, 1},
    {"40_fo", 1, 5, 1},
};

const std::vector<Fails> failures = {
    {"04_neg_out_of_range", ":5: vertex `-9` counts back past the first vertex, 4 are defined"},
    {"05_index_zero", ":5: vertex number 0, expected a number from 1"},
    {"06_index_too_big", ":5: vertex 99 does not exist, the file has 4"},
    {"07_index_overflow", ":5: vertex number `99999999999999999999` is too large"},
    {"12_missing_mtl",
     ": no emitter, expected a face whose material has Ke above 0 (1e-30 or more); no such material file: `nope.mtl`"},
    {"16_nan", ":1: vertex: `nan` is not a finite number"},
    {"17_inf1e400", ":1: vertex: `1e400` is not a finite number"},
    {"19_commas", ":1: vertex: `0,0` is not a finite number, expected a decimal point"},
    {"29_truncated", ":5: the file ends in the middle of a face"},
    {"30_v_missing_coord", ":1: vertex: a number is missing"},
    {"31_empty", ":1: the file is empty"},
    {"32_binary", ":1: control character, expected text in UTF-8"},
    {"38_garbage_num", ":2: vertex: `x` is not a finite number"},
};

} // namespace

TEST_CASE("good files give their area, whatever their syntax")
{
    for (const Loads& expected : loads) {
        CAPTURE(expected.name);
        const ObjMesh mesh = parse_obj(fixture(expected.name));
        CHECK(area_without_light(mesh) == doctest::Approx(expected.area).epsilon(1e-6));
        CHECK(cut_into_pieces(mesh, scale_of(mesh)).pieces.size() == expected.surfaces);
    }
}

TEST_CASE("good files with a lamp give its power, and those without are told so")
{
    for (const Loads& expected : loads) {
        CAPTURE(expected.name);
        if (expected.power == 0.0) {
            CHECK(contains(problem_of([&] { read_obj(fixture(expected.name)); }), "no emitter"));
            continue;
        }
        const SceneFile scene = read_obj(fixture(expected.name));
        CHECK(total_area(scene) == doctest::Approx(expected.area).epsilon(1e-15));
        CHECK(emitted_power(scene) == Rgb{expected.power, expected.power, expected.power});
        CHECK(scene.surfaces.size() == expected.surfaces);
    }
}

TEST_CASE("bad files are refused with the line and the reason")
{
    for (const Fails& expected : failures) {
        const std::string problem = problem_of([&] { read_obj(fixture(expected.name)); });
        CAPTURE(problem);
        CHECK(contains(problem, fixture(expected.name) + expected.message));
    }
}

TEST_CASE("every fixture is in one of the two lists")
{
    CHECK(loads.size() + failures.size() == 40);
}

TEST_CASE("flaws of the fixtures are counted or warned of")
{
    CHECK(contains(parse_obj(fixture("20_two_vertex_face")).warnings.at(0),
                   "a face of fewer than three vertices is dropped (2 in the file)"));
    const ObjMesh repeated_corner = parse_obj(fixture("21_dup_vertex_face"));
    CHECK(contains(cut_into_pieces(repeated_corner, scale_of(repeated_corner)).warnings.at(0),
                   "a face without an area is dropped (1 in the file)"));
    const ObjMesh bent = parse_obj(fixture("34_nonplanar"));
    const std::vector<std::string> warnings = cut_into_pieces(bent, scale_of(bent)).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(contains(warnings[0], "34_nonplanar.obj:5: polygon is not planar"));
    CHECK(contains(parse_obj(fixture("25_w")).warnings.at(0), "25_w.obj:2: the weight of a vertex"));
}

} // namespace obj_fixtures_test

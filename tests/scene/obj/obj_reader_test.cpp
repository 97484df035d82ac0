#include "scene/obj/obj_reader.h"

#include "scene/input_problem.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace obj_reader_test {

using namespace multipath;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string above = "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
/// A closed unit cube, seen from inside.
const std::string cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                         "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";

using Remedies = std::vector<std::pair<Remedy, std::string>>; ///< each with its value

/// Files of one scene: room.obj and room.mtl.
struct SceneText
{
    std::string obj;
    std::string mtl;

    SceneFile read(const ObjChanges& changes = {}) const
    {
        folder.write("room.mtl", mtl);
        return read_obj(folder.write("room.obj", obj), changes);
    }
    std::string problem() const
    {
        return problem_of([&] { read(); });
    }
    /// Those that the error of the scene advises.
    Remedies remedies(const ObjChanges& changes = {}) const
    {
        Remedies result;
        try {
            read(changes);
        } catch (const InputError& error) {
            for (const Advice& advice : error.advice)
                result.emplace_back(advice.remedy, advice.value);
        }
        return result;
    }

    ScratchFolder folder = {};
};

const Remedies daylight = {{Remedy::sky, "10"}, {Remedy::sun, "150,40,20"}};

bool any_contains(const std::vector<std::string>& lines, const std::string& part)
{
    for (const std::string& line : lines)
        if (contains(line, part))
            return true;
    return false;
}

} // namespace

TEST_CASE("a quad becomes a parallelogram with the corner and the edges of the file")
{
    const SceneFile scene = SceneText{"mtllib room.mtl\n" + square + "o lamp\nusemtl m\nf 2 3 4 1\n",
                                      "newmtl m\nKd 0.25 0.5 0.75\nKe 1 2 3\n"}
                                .read();
    REQUIRE(scene.surfaces.size() == 1);
    CHECK(scene.surfaces[0].shape == Shape::parallelogram);
    CHECK(scene.surfaces[0].origin == Vec3{1, 0, 0});
    CHECK(scene.surfaces[0].edge_u == Vec3{0, 1, 0});
    CHECK(scene.surfaces[0].edge_v == Vec3{-1, 0, 0});
    CHECK(scene.surfaces[0].normal() == Vec3{0, 0, 1});
    CHECK(scene.groups == std::vector<std::string>{"lamp"});
    CHECK(scene.line == std::vector<std::uint32_t>{8});
    CHECK(scene.materials[scene.material[0]].reflectance == Rgb{0.25, 0.5, 0.75});
    CHECK(scene.materials[scene.material[0]].emittance == Rgb{1, 2, 3});
    CHECK(contains(scene.materials[scene.material[0]].source, "room.mtl:1"));
    REQUIRE(scene.material_files.size() == 1);
    CHECK(contains(scene.material_files[0], "room.mtl"));
    CHECK(scene.warnings.empty());
    CHECK(scene.counts == "1 material, 1 emitter, 1 face -> 1 surface");
}

TEST_CASE("what was dropped is told, and triangles are joined before surfaces are counted")
{
    const SceneText text{"mtllib room.mtl\n" + square +
                             "usemtl lamp\nf 1 2 3\nf 1 3 4\nusemtl paint\nf 1 2\nf 1 1 2\nf 1 3 2\n",
                         "newmtl lamp\nKd 0\nKe 1\nnewmtl spare\nKd 0.5\n"};
    CHECK(text.read().counts == "2 materials, 1 emitter, 4 faces -> 2 surfaces");
    CHECK(any_contains(text.read().warnings, ":10: a face of fewer than three vertices is dropped (1 in the file)"));
    CHECK(any_contains(text.read().warnings, ":11: a face without an area is dropped (1 in the file)"));
}

TEST_CASE("an unknown material is grey, with one warning for its name")
{
    const SceneFile scene =
        SceneText{"mtllib room.mtl\n" + square +
                      "usemtl lamp\nf 1 2 3 4\nusemtl wood\nf 1 2 3\nusemtl lamp\nusemtl wood\nf 2 3 4\n",
                  "newmtl lamp\nKd 0\nKe 1\n"}
            .read();
    CHECK(scene.materials[scene.material[1]].name == "wood");
    CHECK(scene.materials[scene.material[1]].reflectance == Rgb{0.5, 0.5, 0.5});
    REQUIRE(scene.warnings.size() == 1);
    CHECK(contains(scene.warnings[0], "room.obj:9: material `wood` is not defined, grey"));
    for (const char* use : {"usemtl wood\n", ""}) { // an object of the material becomes a lamp
        ObjChanges changes;
        changes.lamps = {{"top", {1, 1, 1}}};
        const SceneFile lit = SceneText{use + square + "f 1 2 3 4\no top\nf 1 2 3\n", ""}.read(changes);
        CHECK(lit.warnings.size() == 1);
        CHECK(lit.unknown_materials.size() == (*use ? 1 : 0));
    }
}

TEST_CASE("a scene without light says why")
{
    const std::string paint = "newmtl paint\nKd 0.5\n";
    const std::string faces = "mtllib room.mtl\n" + square + "usemtl paint\nf 1 2 3 4\n";
    CHECK(contains(SceneText{square + "f 1 2 3\n", ""}.problem(), "no material file is named"));
    CHECK(contains(SceneText{faces + "usemtl light\nf 1 2 3\n", paint}.problem(), "used but not defined: `light`"));
    CHECK(contains(SceneText{faces, paint + "Ke 1e-323\n"}.problem(), "has Ke above 0 (1e-30 or more)"));
    CHECK(contains(SceneText{faces, paint + "newmtl sun\nKe 9\n"}.problem(), "emitting but used by no face: `sun`"));
    std::string suns;
    for (int i = 1; i <= 7; ++i)
        suns += "newmtl sun" + std::to_string(i) + "\nKe 9\n";
    CHECK(contains(SceneText{faces, paint + suns}.problem(), "`sun1`, `sun2`, `sun3`, `sun4`, `sun5` and 2 more"));
}

TEST_CASE("a scene too small to compute with is refused")
{
    const std::string faces = "mtllib room.mtl\nv 0 0 0\nv 1e-10 0 0\nv 0 1e-10 0\nusemtl lamp\nf 1 2 3\n";
    CHECK(contains(SceneText{faces, "newmtl lamp\nKe 1\n"}.problem(), "lie within 1e-9 of each other"));
}

TEST_CASE("ambient light is no emission")
{
    const SceneText text{"mtllib room.mtl\n" + square + "usemtl lamp\nf 1 2 3 4\n",
                         "newmtl lamp\nKa 20 10 5\nKd 0.5\n"};
    CHECK(contains(text.problem(), "has Ke above 0"));
}

// A surface that is only dropped faces emits nothing.
TEST_CASE("a lamp without area is no emitter")
{
    const SceneText text{"mtllib room.mtl\n" + square + "usemtl lamp\nf 1 2 2\nusemtl wall\nf 1 2 3 4\n",
                         "newmtl lamp\nKd 0\nKe 1\nnewmtl wall\nKd 0.5\n"};
    CHECK(contains(text.problem(), "no emitter"));
}

// Two squares of one material, one of them the object `panel`.
const SceneText two_squares{"mtllib room.mtl\no floor\n" + square +
                                "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nusemtl paint\nf 1 2 3 4\no panel\nf 5 6 7 8\n",
                            "newmtl paint\nKd 0.5\nnewmtl spare\nKd 0.1\n"};

TEST_CASE("a material becomes a lamp, or the faces of an object alone")
{
    const SceneFile all = two_squares.read({{{"paint", {1, 2, 3}}}, {}});
    CHECK(all.materials[all.material[0]].emittance == Rgb{1, 2, 3});
    CHECK(all.materials[all.material[1]].emittance == Rgb{1, 2, 3});
    const SceneFile panel = two_squares.read({{{"panel", {4, 4, 4}}}, {}});
    REQUIRE(panel.surfaces.size() == 2);
    CHECK(panel.materials[panel.material[0]].emittance == Rgb{});
    CHECK(panel.materials[panel.material[1]].emittance == Rgb{4, 4, 4});
    CHECK(panel.materials[panel.material[1]].reflectance == panel.materials[panel.material[0]].reflectance);
    CHECK(panel.materials[panel.material[1]].name == "paint of panel");
    CHECK(panel.unused_materials.size() == 1); // `spare` alone
}

TEST_CASE("what is ignored is left out, and a name that the file does not have is told")
{
    const SceneFile rest = two_squares.read({{{"panel", {1, 1, 1}}}, {"floor"}});
    REQUIRE(rest.surfaces.size() == 1);
    CHECK(rest.surfaces[0].origin.z == 1.0);
    const auto problem = [](const ObjChanges& changes) { return problem_of([&] { two_squares.read(changes); }); };
    CHECK(contains(problem({{{"pannel", {1, 1, 1}}}, {}}), "room.obj: no material or object is called `pannel`"));
    CHECK(contains(problem({{{"pannel", {1, 1, 1}}}, {}}), "`paint`, `floor`, `panel`"));
    CHECK(contains(problem({{}, {"spare"}}), "room.obj: no material or object is called `spare`"));
    CHECK(contains(problem({{}, {"paint"}}), "no face is left"));
}

TEST_CASE("the error of a file without lamps names one by its name, or else the sky, or in a room one by its area")
{
    const std::string materials = "newmtl paint\nKd 0.5\nnewmtl cloth\nKd 0.5\n";
    const auto panel_of = [&](const std::string& names) {
        return SceneText{"mtllib room.mtl\n" + square + above + "usemtl paint\nf 1 2 3 4\n" + names +
                             "\nusemtl cloth\nf 5 8 7 6\n",
                         materials};
    };
    CHECK(panel_of("o Desk Lamp's shade").remedies() == Remedies{{Remedy::lamp, "Desk Lamp's shade=10"}});
    CHECK(contains(panel_of("o LIGHT").problem(), "to make a lamp of material or object `LIGHT` (1 m^2, so 10 W)"));
    CHECK(panel_of("o desk").remedies() == Remedies{{Remedy::lamp, "paint=10"}}); // two squares face each other
    // Lamps come before windows, and one of two names is enough.
    const std::string both = "o window\nf 1 2 3\no lamp\nf 1 2 3";
    CHECK(contains(panel_of(both).problem(), "object `lamp` (1.5 m^2, so 15 W)"));
    CHECK(contains(two_squares.problem(), "to light it by sky and sun"));
    CHECK(contains(SceneText{square + "f 1 2 3 4\n", ""}.problem(), "to light it by sky and sun"));

    ObjChanges outside;
    outside.lit_from_outside = true;
    CHECK(two_squares.read(outside).surfaces.size() == 2);

    // Nothing of the sky gets into a closed room.
    CHECK(SceneText{cube, ""}.remedies() == Remedies{{Remedy::lamp, "default=10"}});
    const SceneText of_two{
        "usemtl floor\n" + cube.substr(0, cube.find("f 8")) + "usemtl wall\n" + cube.substr(cube.find("f 8")), ""};
    CHECK(of_two.remedies() == Remedies{{Remedy::lamp, "wall=10"}});
    const SceneText nameless{square + "f 1 2 3 4\n", ""};
    CHECK(nameless.read({{{"default", {1, 1, 1}}}, {}}).materials[0].emittance == Rgb{1, 1, 1});
}

TEST_CASE("a material that reflects all light of a colour is told")
{
    const SceneFile scene =
        SceneText{"mtllib room.mtl\nusemtl white\n" + cube, "newmtl white\nKd 0.5 1 0.5\nKe 1\n"}.read();
    CHECK(any_contains(scene.warnings, "room.mtl:1: Kd = 1"));
}

TEST_CASE("reflectances above 1 are refused or lowered, and the error's advice mends all that is wrong")
{
    const std::string start = "mtllib room.mtl\nusemtl white\n";
    const SceneText lit{start + square + "f 1 2 3 4\n", "newmtl white\nKe 1\nKd 0.2 1.5 0.95\nnewmtl other\nKd 2\n"};
    CHECK(contains(lit.problem(), "room.mtl:3: Kd of material `white` is above 1"));
    CHECK(lit.remedies() == Remedies{{Remedy::reflectance_limit, "0.9"}});
    ObjChanges lowered;
    lowered.reflectance_limit = 0.9;
    const SceneFile scene = lit.read(lowered);
    CHECK(scene.materials[0].reflectance == Rgb{0.2, 0.9, 0.9});
    CHECK(any_contains(scene.warnings, "reflectance lowered to the limit of 0.9: `white`"));

    const SceneText dark_cube{start + cube, "newmtl white\nKd 1\n"};
    CHECK(contains(dark_cube.problem(), "no emitter"));
    CHECK(dark_cube.remedies() == Remedies{{Remedy::reflectance_limit, "0.9"}, {Remedy::lamp, "white=10"}});
    lowered.lamps.push_back({"white", {10, 10, 10}});
    CHECK(dark_cube.read(lowered).materials[0].emittance == Rgb{10, 10, 10});
    const SceneText unused{start + square + "f 1 2 3 4\n", "newmtl white\nKe 1\nKd 0.2\nnewmtl other\nKd 2\n"};
    CHECK(unused.read().materials[0].reflectance == Rgb{0.2, 0.2, 0.2});
}

TEST_CASE("the advice of an error names only what has faces that are left")
{
    const std::string two =
        square + above +
        "o lamp\nusemtl a\nf 1 1 1\no --shade lamp\nusemtl b\nf 1 2 3 4\no rest\nusemtl c\nf 5 8 7 6\n";
    const SceneText scene{"mtllib room.mtl\n" + two, "newmtl a\nKd 0.5\nnewmtl b\nKd 0.5\nnewmtl c\nKd 0.5\n"};
    CHECK(scene.remedies() == Remedies{{Remedy::lamp, "--shade lamp=10"}});
    ObjChanges changes;
    changes.ignored = {"--shade lamp"};
    CHECK(scene.remedies(changes) == daylight);
    changes.lamps = {{"b", {1, 1, 1}}};
    CHECK(contains(problem_of([&] { scene.read(changes); }), "room.obj: no material or object is called `b`"));
    const SceneText white{"mtllib room.mtl\n" + two, "newmtl a\nKd 0.5\nnewmtl b\nKd 1\nnewmtl c\nKd 0.5\n"};
    CHECK(white.remedies() == // it might trap light
          Remedies{{Remedy::reflectance_limit, "0.9"}, {Remedy::lamp, "--shade lamp=10"}});
}

TEST_CASE("a missing material file is told, and grey stands in for its materials")
{
    const std::string faces = square + "usemtl paint\nf 1 2 3 4\n";
    CHECK(contains(SceneText{"mtllib none.mtl\n" + faces, ""}.problem(), "no such material file: `none.mtl`"));
    const SceneText lit{"mtllib none.mtl room.mtl\n" + faces + "usemtl lamp\nf 1 2 3\n", "newmtl lamp\nKe 1\nKd 0\n"};
    const SceneFile scene = lit.read();
    CHECK(any_contains(scene.warnings, "room.obj:1: material file `none.mtl` not found"));
    CHECK(scene.unknown_materials == std::vector<std::string>{"paint"});
}

TEST_CASE("a transparent material is told")
{
    const SceneText scene{"mtllib room.mtl\n" + square + "usemtl glass\nf 1 2 3 4\n",
                          "newmtl glass\nKd 0.1\nKe 1\nd 0.3\n"};
    CHECK(any_contains(scene.read().warnings, "room.mtl:1: transparent by `d`"));
}

TEST_CASE("a material without Kd reflects nothing, with a warning")
{
    const SceneFile scene =
        SceneText{"mtllib room.mtl\n" + square + "usemtl lamp\nf 1 2 3 4\n", "newmtl lamp\nKe 1\n"}.read();
    CHECK(scene.materials[0].reflectance == Rgb{});
    CHECK(any_contains(scene.warnings, "room.mtl:1: no Kd"));
}

TEST_CASE("materials whose names differ after a number sign are different, and a comment after a name changes nothing")
{
    const auto reflectances = [](const std::string& first, const std::string& second, const std::string& mtl) {
        const SceneFile scene =
            SceneText{"mtllib room.mtl # the room\n" + square + above + "usemtl " + first + "\nf 1 2 3 4\nusemtl " +
                          second + "\nf 5 6 7 8\nusemtl lamp # on\nf 8 7 6 5\n",
                      mtl + "newmtl lamp # 60 W\nKd 0\nKe 1\n"}
                .read();
        std::string text;
        for (std::size_t s = 0; s < 2; ++s)
            text += scene.materials[scene.material[s]].name + " " +
                    std::to_string(scene.materials[scene.material[s]].reflectance.r).substr(0, 3) +
                    (s == 0 ? ", " : "");
        return text;
    };
    const std::string paints = "newmtl Paint # 2\nKd 0.1\nnewmtl Paint # 3\nKd 0.9\n";
    CHECK(reflectances("Paint # 2", "Paint # 3", paints) == "Paint # 2 0.1, Paint # 3 0.9");
    CHECK(reflectances("Paint # 2", "Paint", paints) == "Paint # 2 0.1, Paint # 2 0.1");
    CHECK(reflectances("Paint # 2", "Paint # 3", "newmtl Paint # 2\nKd 0.1\n") == "Paint # 2 0.1, Paint # 2 0.1");
    CHECK(reflectances("wood # floor", "wood # table", "newmtl wood\nKd 0.1\n") == "wood 0.1, wood 0.1");
    CHECK(reflectances("wood", "old # table", "newmtl wood # oak\nKd 0.1\nnewmtl old\nKd 0.9\n") ==
          "wood # oak 0.1, old 0.9");
    CHECK(reflectances("wood # oak", "wood", "newmtl wood # oak\nKd 0.1\n") == "wood # oak 0.1, wood # oak 0.1");
    CHECK(reflectances("a # b", "a # b", "") == "a 0.5, a 0.5");
}

TEST_CASE("objects and the groups that divide them can both be named")
{
    const std::string faces = square + above + "o table\ng top\nf 1 2 3 4\ng leg\nf 5 6 7 8\no chair\nf 8 7 6 5\n";
    const auto lamps = [&](const char* name) {
        const SceneFile scene = SceneText{faces, ""}.read({{{name, {1, 1, 1}}}, {}});
        std::string lit;
        for (const std::uint32_t material : scene.material)
            lit += scene.materials[material].emittance.r > 0.0 ? '1' : '0';
        return lit;
    };
    CHECK(lamps("table") == "110");
    CHECK(lamps("top") == "100");
    CHECK(lamps("leg") == "010");
    CHECK(lamps("chair") == "001");
    ObjChanges changes = {{{"top", {1, 1, 1}}}, {"chair"}};
    CHECK(SceneText{faces, ""}.read(changes).surfaces.size() == 2);
    const SceneFile scene = SceneText{faces, ""}.read(changes);
    CHECK(scene.is_named(0, "table"));
    CHECK(scene.is_named(1, "leg"));
    CHECK_FALSE(scene.is_named(1, "top"));
}

TEST_CASE("groups come in order of appearance, and the same name is the same group")
{
    const SceneFile scene =
        SceneText{"mtllib room.mtl\nusemtl m\n" + square + "f 1 2 3\no a\nf 1 2 3\ng b c\nf 1 2 3\ng a\nf 1 2 3\n",
                  "newmtl m\nKd 0\nKe 1\n"}
            .read();
    CHECK(scene.groups == std::vector<std::string>{"", "a", "b c"});
    CHECK(scene.group == std::vector<std::uint32_t>{0, 1, 2, 1});
}

} // namespace obj_reader_test

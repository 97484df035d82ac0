#include "scene/obj/obj_mesh.h"

#include "scene/input_problem.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace obj_mesh_test {

using namespace multipath;

namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";

ObjMesh parse(const std::string& text)
{
    const ScratchFolder folder;
    return parse_obj(folder.write("a.obj", text));
}

std::string problem(const std::string& text)
{
    return problem_of([&] { parse(text); });
}

} // namespace

TEST_CASE("corners may have texture coordinates and normals in any notation")
{
    for (const char* face : {"f 1 2 3", "f 1/7 2/8 3/9", "f 1//7 2//8 3//9", "f 1/1/1 2/2/2 3/3/3", "f 1 -2 3/-1",
                             "f\t1\t2 \t3\t", "f 1 2 3#comment", "f 1 2 \\\n3", "f \\\r\n 1 2 3 \\ \r\n"}) {
        CAPTURE(face);
        const LargeVector<ObjCorner> corners = parse(triangle + face + "\n").corners;
        REQUIRE(corners.size() == 3);
        for (std::uint32_t k = 0; k < 3; ++k)
            CHECK(corners[k].vertex == k);
    }
}

TEST_CASE("a corner that is not a number is refused")
{
    for (const char* face : {"f 1 2 3x", "f 1 2 x", "f 1 2 1.5", "f 1 2 /3", "f 1 2 -", "f 1 2 --1", "f 1 2 3|4"}) {
        CAPTURE(face);
        CHECK(contains(problem(triangle + face + "\n"), "a.obj:4: `"));
    }
}

TEST_CASE("a file that ends within a face is refused, one that only lacks the last line feed is not")
{
    CHECK(parse(triangle + "f 1 2 3").faces.size() == 1);
    for (const char* end : {"f 1 2", "f 1 2 ", "f 1 2 3/", "f 1//1 2//2 3//", "f", "f 1 2 3 \\", "f 1 2 \\\n"}) {
        CAPTURE(end);
        CHECK(contains(problem(triangle + "f 1 2 3\n" + end), "a.obj:5: "));
    }
}

TEST_CASE("free-form surfaces are refused and unknown statements warned of")
{
    CHECK(contains(problem(triangle + "surf 0 1 0 1 1 2 3\n"), "a.obj:4: `surf` is not supported"));
    const ObjMesh mesh = parse(triangle + "s 1\nvt 0 0\nvn 0 0 1\nl 1 2\nface 1 2 3\nf 1 2 3\nface 1 2 3\n");
    REQUIRE(mesh.warnings.size() == 1);
    CHECK(contains(mesh.warnings[0], "a.obj:8: unknown statements ignored: `face`"));
}

TEST_CASE("a name keeps its blanks, its number sign and its backslash, but no comment")
{
    const ObjMesh mesh = parse(triangle + "usemtl Material #25\nf 1 2 3\nusemtl old wood # from the shop\nf 1 2 3\n" +
                               "usemtl C:\\\nf 1 2 3\nusemtl\nf 1 2 3\n");
    REQUIRE(mesh.materials.size() == 4);
    CHECK(mesh.materials[0].name == "Material #25");
    CHECK(mesh.materials[1].name == "old wood # from the shop"); // until the MTL files are read
    CHECK(mesh.materials[2].name == "C:\\");
    CHECK(mesh.materials[3].name == "");
    CHECK(mesh.faces.size() == 4);
}

TEST_CASE("a face has the names of its object and of the group that divides it")
{
    const ObjMesh mesh =
        parse(triangle + "o a # first\ng b\nf 1 2 3\ng c # 1\nf 1 2 3\no d\nf 1 2 3\ng #2\no e\nf 1 2 3\n" +
              "o f\ng f\nf 1 2 3\n");
    const auto names = [&](std::size_t face) {
        const ObjGroup& group = mesh.groups[mesh.faces[face].group];
        return group.name + " of " + group.other;
    };
    CHECK(names(0) == "b of a");
    CHECK(names(1) == "c of a");
    CHECK(names(2) == "d of "); // a group ends with its object
    CHECK(names(3) == "e of ");
    CHECK(names(4) == "f of ");
}

TEST_CASE("numbers after coordinates, texture coordinates and texture points without meaning are told")
{
    const auto warning = [](const std::string& text) {
        const ObjMesh mesh = parse(text);
        REQUIRE(mesh.warnings.size() <= 1);
        return mesh.warnings.empty() ? "" : mesh.warnings[0].substr(mesh.warnings[0].find("a.obj"));
    };
    const std::string after = ": the numbers after the coordinates of a vertex are ignored";
    CHECK(warning(triangle + "v 0 0 1 0.5 0.5 0\nf 1 2 4\n") == "");
    CHECK(contains(warning(triangle + "v 0 0 1 200 10 0\nf 1 2 4\n"), "a.obj:4" + after));
    CHECK(contains(warning(triangle + "v 0 0 1 1 1\nv 0 0 1 1 1 0 1\nf 1 2 4\n"), "a.obj:4" + after));
    CHECK(contains(warning(triangle + "v 0 0 1 -0.1 0 0\nf 1 2 4\n"), "(1 in the file)"));
    const std::string coordinate = ": a texture coordinate is not a number up to 1e9";
    CHECK(warning(triangle + "vt 0.5\nvt 1 1 0\nf 1/1 2/2 3/1\n") == "");
    CHECK(contains(warning(triangle + "vt 0 0\nvt 1.#IND 0\nvt x 0\nf 1 2 3\n"), "a.obj:5" + coordinate));
    CHECK(contains(warning(triangle + "vt 0 2e9\nf 1 2 3\n"), "a.obj:4" + coordinate));
    const std::string missing = ": a face refers to a texture point that does not exist";
    for (const char* point : {"2", "99", "0", "-2", "4294967295", "99999999999"}) {
        CAPTURE(point);
        CHECK(
            contains(warning(triangle + "vt 0 0\nf 1/1 2/1 3/1\nf 1/1 2/" + point + "/1 3/1\n"), "a.obj:6" + missing));
    }
    CHECK(warning(triangle + "f 1/1 2/1 3/-1\nvt 0 0\n") != ""); // none is defined before the line
    CHECK(warning(triangle + "f 1/1 2/1 3/1\nf 1//1 2//1 3\nvt 0 0\n") == "");
}

TEST_CASE("a vertex that is not finite is refused, however a program wrote it")
{
    for (const char* word : {"1.#INF", "-1.#IND", "1.#QNAN0", "nan", "-inf"}) {
        CAPTURE(word);
        CHECK(contains(problem("v 0 0 " + std::string(word) + "\nf 1 1 1\n"), "is not a finite number"));
    }
}

TEST_CASE("a backslash in a comment continues nothing")
{
    CHECK(parse(triangle + "# folder C:\\\nf 1 2 3\nf 1 2 3 # \\\nf 1 2 3\n").faces.size() == 3);
}

TEST_CASE("coordinates too large to compute with are refused")
{
    CHECK(contains(problem("v 1e10 0 0\n"), "a.obj:1: coordinate beyond 1e9"));
    CHECK(contains(problem("v 0 0 0 x\n"), "a.obj:1: vertex: `x` is not a finite number"));
}

TEST_CASE("a file without faces is refused")
{
    CHECK(contains(problem("hello world\n"), "no faces found"));
    CHECK(contains(problem(triangle + "f 1 2\n"), "no faces found"));
}

} // namespace obj_mesh_test

#include "scene/input_problem.h"
#include "scene/obj/mtl_reader.h"
#include "scene/scratch_folder.h"

#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace mtl_reader_test {

using namespace multipath;

namespace {

MaterialLibrary read(const std::string& text)
{
    const ScratchFolder folder;
    MaterialLibrary library;
    read_mtl(folder.write("a.mtl", text), library);
    return library;
}

std::string problem(const std::string& text)
{
    return problem_of([&] { read(text); });
}

} // namespace

TEST_CASE("colours are three numbers, or one for grey")
{
    const MaterialLibrary library = read("newmtl old wood  \t\r\n\tKd 0.1 .2 3e-1 # brown\r\nKe 4\nnewmtl b\nKd 1\n");
    REQUIRE(library.materials.size() == 2);
    CHECK(library.materials[0].material.name == "old wood");
    CHECK(library.materials[0].material.reflectance == Rgb{0.1, 0.2, 0.3});
    CHECK(library.materials[0].material.emittance == Rgb{4, 4, 4});
    CHECK(library.materials[1].material.reflectance == Rgb{1, 1, 1});
    CHECK(library.materials[1].material.emittance == Rgb{});
    CHECK(library.warnings.empty());
}

TEST_CASE("values that no material can have are refused with the name of the material")
{
    CHECK(contains(read("newmtl red\nKd 1.01 0 0\n").materials[0].flaw, "a.mtl:2: Kd of material `red` is above 1"));
    CHECK(read("newmtl red\nKd 1.01 0 0\nKd 1\n").materials[0].flaw.empty());
    CHECK(contains(problem("newmtl red\nKd 0 0 -0.1\n"), "a.mtl:2: Kd of material `red` is negative"));
    CHECK(contains(problem("newmtl red\nKe 0 -1 0\n"), "a.mtl:2: Ke of material `red` is negative"));
    CHECK(contains(problem("newmtl red\nKe inf\n"), "a.mtl:2: Ke of material `red`: `inf` is not a finite number"));
    CHECK(contains(problem("newmtl red\nKd nan 0 0\n"), "a.mtl:2: Kd of material `red`: `nan`"));
    CHECK(contains(problem("newmtl red\nKe 1e300\n"), "a.mtl:2: Ke of material `red` is above 1e30"));
    CHECK(contains(problem("newmtl red\nKe 0 0 1.1e30\n"), "is above 1e30"));
    CHECK(problem("newmtl red\nKe 1e30\n").empty());
}

TEST_CASE("an emission too small to compute with counts as none")
{
    const MaterialLibrary library = read("newmtl a\nKe 1e-323 2 0\nnewmtl b\nKe 1e-30\nnewmtl c\nKe 5e-324\nKe 3\n");
    CHECK(library.materials[0].material.emittance == Rgb{0, 2, 0});
    CHECK(library.materials[1].material.emittance == Rgb{1e-30, 1e-30, 1e-30});
    CHECK(library.materials[2].material.emittance == Rgb{3, 3, 3});
}

TEST_CASE("colours in other notations are refused")
{
    CHECK(contains(problem("newmtl a\nKd spectral red.rfl\n"),
                   "a.mtl:2: Kd of material `a`: `spectral` is not a finite number"));
    CHECK(contains(problem("newmtl a\nKe xyz 1 1 1\n"), "Ke of material `a`: `xyz`"));
    CHECK(contains(problem("newmtl a\nKd 0.5 0.5\n"), "has 2 numbers, expected one or three"));
    CHECK(contains(problem("newmtl a\nKd\n"), "has 0 numbers, expected one or three"));
    CHECK(contains(problem("newmtl a\nKd 1 1 1 1\n"), "has 4 numbers, expected one or three"));
    CHECK(contains(problem("Kd 1 1 1\n"), "a.mtl:1: Kd before the first `newmtl`"));
}

TEST_CASE("of two values or definitions the last counts, and a warning names both lines")
{
    const MaterialLibrary values = read("newmtl a\nKd 0.5\nKd 0.25\n");
    CHECK(values.materials[0].material.reflectance == Rgb{0.25, 0.25, 0.25});
    REQUIRE(values.warnings.size() == 1);
    CHECK(contains(values.warnings[0], "a.mtl:3: Kd of material `a` is given again (first in line 2)"));

    const MaterialLibrary definitions = read("newmtl a\nKd 0.5\nKe 1\nnewmtl b\nnewmtl a\nKd 0.25\n");
    REQUIRE(definitions.materials.size() == 2);
    CHECK(definitions.materials[0].material.reflectance == Rgb{0.25, 0.25, 0.25});
    CHECK(definitions.materials[0].material.emittance == Rgb{});
    REQUIRE(definitions.warnings.size() == 1);
    CHECK(contains(definitions.warnings[0], "a.mtl:5: material `a` is defined again (first at "));
    CHECK(contains(definitions.warnings[0], "a.mtl:1), the last"));
}

TEST_CASE("ignored statements are named once")
{
    const MaterialLibrary library = read("newmtl a\nKd 0.5\nNs 1\nillum 2\nKs 1 1 1\nnewmtl b\nNs 2\nmap_Kd x.png\n");
    REQUIRE(library.warnings.size() == 1);
    CHECK(contains(library.warnings[0], "a.mtl:3: ignored, since only Kd and Ke count: "));
    CHECK(contains(library.warnings[0], ": `Ns`, `illum`, `Ks`"));
}

TEST_CASE("emission comes from Ke, not from Ka")
{
    const MaterialLibrary library = read("newmtl a\nKa 1 2 3\nKe 4 5 6\n");
    CHECK(library.materials[0].material.emittance == Rgb{4, 5, 6});
    CHECK(contains(library.warnings.at(0), "a.mtl:2: ignored, since only Kd and Ke count: `Ka`"));
}

TEST_CASE("opacity is d, or unknown")
{
    const auto opacity = [](const std::string& lines) { return read("newmtl a\n" + lines).materials[0].opacity; };
    CHECK(opacity("Kd 1\n") == 1.0);
    CHECK(opacity("d 0.25\n") == 0.25);
    CHECK(opacity("d 0.25 # of glass\n") == 0.25);
    CHECK(opacity("Tr 0.75\n") == 1.0); // exporters disagree whether it is that or the transparency
    CHECK(opacity("d 0.25\nTr 0.5\n") == 0.25);
    CHECK(opacity("d\n") == 1.0);
    CHECK(read("newmtl a\nd 0.5\nnewmtl b\nKd 1\n").materials[1].opacity == 1.0);
}

namespace {

/// What each of the found files holds; the files hold their own names.
std::vector<std::string> found_in(const ScratchFolder& folder, const std::string& names)
{
    std::vector<std::string> texts;
    const std::string obj = folder.path("room.obj");
    for (const std::string& path : find_mtl_files(names, {obj, 3}).found) {
        std::ifstream file(path);
        std::getline(file, texts.emplace_back());
    }
    return texts;
}

} // namespace

TEST_CASE("names of material files may be several, quoted, with blanks, backslashes or the wrong case")
{
    using Names = std::vector<std::string>;
    const ScratchFolder folder;
    for (const char* name : {"a.mtl", "b.mtl", "a b.mtl", "c d e.mtl", "Sub/F.mtl", "x.MTL", "X.mtl"})
        folder.write(name, name);

    CHECK(found_in(folder, "a.mtl") == Names{"a.mtl"});
    CHECK(found_in(folder, "a.mtl b.mtl") == Names{"a.mtl", "b.mtl"});
    CHECK(found_in(folder, "a b.mtl") == Names{"a b.mtl"});
    CHECK(found_in(folder, "c d e.mtl a.mtl") == Names{"c d e.mtl", "a.mtl"});
    CHECK(found_in(folder, "\"a b.mtl\" 'b.mtl' a.mtl") == Names{"a b.mtl", "b.mtl", "a.mtl"});
    CHECK(found_in(folder, ".\\SUB\\f.MTL") == Names{"Sub/F.mtl"});
    CHECK(found_in(folder, "Sub/../b.mtl") == Names{"b.mtl"});
    CHECK(found_in(folder, "X.mtl") == Names{"X.mtl"});
    CHECK(found_in(folder, "x.mtl") == Names{"X.mtl"}); // of the two, the first by name
    CHECK(found_in(folder, folder.path("a.mtl")) == Names{"a.mtl"});
}

TEST_CASE("material files that do not exist are named, each up to the end of its name")
{
    using Names = std::vector<std::string>;
    const ScratchFolder folder;
    folder.write("a.mtl", "");
    folder.write("folder.mtl/b.mtl", "");
    const std::string obj = folder.path("room.obj");
    const auto missing = [&](const std::string& names) { return find_mtl_files(names, {obj, 3}).missing; };
    CHECK(missing("a.mtl none.mtl") == Names{"none.mtl"});
    CHECK(missing("none.mtl a.mtl") == Names{"none.mtl"});
    CHECK(missing("my room.MTL a.mtl other one.mtl") == Names{"my room.MTL", "other one.mtl"});
    CHECK(missing("'my room' a.mtl") == Names{"my room"});
    CHECK(missing("my room") == Names{"my room"});
    CHECK(missing("'my room.mtl' \"other\" third") == Names{"my room.mtl", "other", "third"});
    CHECK(missing("folder.mtl") == Names{"folder.mtl"});
    CHECK(missing("\"") == Names{"\""});
    const auto problem = [&](const std::string& names) { return problem_of([&] { find_mtl_files(names, {obj, 3}); }); };
    CHECK(contains(problem(""), "room.obj:3: `mtllib` without a name"));
    std::string many;
    for (int i = 0; i < 100; ++i)
        many += "a.mtl ";
    CHECK(contains(problem(many), "more than 32 names"));
}

} // namespace mtl_reader_test

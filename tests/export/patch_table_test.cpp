#include "export/patch_table.h"

#include "export/csv_text.h"
#include "scene/input_problem.h"
#include "scene/scratch_folder.h"
#include "test_scenes.h"

#include <doctest/doctest.h>

#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace patch_table_test {

using namespace multipath;

namespace {

/// Two rectangles of awkward size and place, of materials whose names need quotes.
Scene awkward_scene()
{
    SceneBuilder builder;
    const std::uint32_t floor = builder.material({0.1, 0.2, 0.3}, {4, 5, 6});
    const std::uint32_t wall = builder.material({0.7, 0.7, 0.7}, {});
    SceneFile file = builder.rectangle({1.0 / 3.0, 0, -1e-3}, {0, 0, 2.0 / 7.0}, {0.1, 0, 0}, floor)
                         .rectangle({0, -1.0 / 9.0, 0}, {1, 0, 0}, {0, 0, 1.0 / 3.0}, wall)
                         .file();
    file.materials[floor].name = "red, \"shiny\"";
    file.materials[wall].name = "\"";
    return Scene(file, 0.1);
}

/// Doubles of every size, tiny, huge and zero among them.
std::vector<Rgb> awkward_values(std::size_t count, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    const auto value = [&] {
        double x = 0.0;
        do {
            const std::uint64_t bits = random() >> 1; // not negative
            std::memcpy(&x, &bits, sizeof x);
        } while (!(x <= std::numeric_limits<double>::max()));
        return x;
    };
    std::vector<Rgb> values(count);
    for (Rgb& v : values)
        v = {value(), value(), value()};
    values[0] = {0.0, std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()};
    return values;
}

PatchTable read_text(const std::string& text)
{
    const ScratchFolder folder;
    return read_patch_table(folder.write("a.csv", text));
}

/// Equal doubles are the same bits here: the table writes no negative zero and no NaN.
void check_round_trip(const std::vector<Rgb>& standard_error)
{
    const Scene scene = awkward_scene();
    const std::vector<Rgb> radiosity = awkward_values(scene.patch_count(), 1);
    const PatchTable table =
        read_text(patch_table(scene, radiosity, standard_error, {"multipath", "scene: 0123456789abcdef"}));
    CHECK(table.comments == std::vector<std::string>{"multipath", "scene: 0123456789abcdef"});
    CHECK(comment_value(table.comments, "scene") == "0123456789abcdef");
    CHECK(table.radiosity == radiosity);
    CHECK(table.standard_error == standard_error);
    REQUIRE(table.areas.size() == scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        CHECK(table.areas[i] == scene.area(i));
}

const std::string header = "patch,surface,material,x,y,z,area,radiosity_r,radiosity_g,radiosity_b";

/// The message about a table of these rows, behind its path.
std::string problem(const std::string& text)
{
    const ScratchFolder folder;
    const std::string path = folder.write("a.csv", text);
    const std::string message = problem_of([&] { read_patch_table(path); });
    return message.substr(0, path.size()) == path ? message.substr(path.size()) : message;
}

} // namespace

TEST_CASE("the table has the promised columns and numbers that read back exactly")
{
    SceneBuilder builder;
    const std::uint32_t material = builder.material({0.1, 0.2, 0.3}, {4, 5, 6});
    SceneFile file = builder.rectangle({0, 0, 0}, {0, 0, 2}, {1, 0, 0}, material).file();
    file.materials[0].name = "red, \"shiny\"";
    const Scene scene(file, 1.0);
    const double awkward = 1.0 / 3.0;
    std::istringstream table(patch_table(scene, {{awkward, 2, 3}, {4, 5, 6}}, {}, {"one", "two"}));
    std::string row;
    std::getline(table, row);
    CHECK(row == "# one");
    std::getline(table, row);
    CHECK(row == "# two");
    std::getline(table, row);
    CHECK(row == "patch,surface,material,x,y,z,nx,ny,nz,area,reflectance_r,reflectance_g,reflectance_b,emittance_r,"
                 "emittance_g,emittance_b,radiosity_r,radiosity_g,radiosity_b");
    std::getline(table, row);
    CHECK(row == "0,0,\"red, \"\"shiny\"\"\",0.5,0,0.5,0,1,0,1,0.10000000000000001,0.20000000000000001,"
                 "0.29999999999999999,4,5,6,0.33333333333333331,2,3");
    std::getline(table, row);
    CHECK(row.substr(0, 4) == "1,0,");
    CHECK(!std::getline(table, row));
}

TEST_CASE("every patch has its own reflectance and emittance, also the back of a lamp of its colour")
{
    SceneBuilder builder;
    const std::uint32_t lamp = builder.material({0.1, 0.2, 0.3}, {4, 5, 6});
    const std::uint32_t dim = builder.material({0.1, 0.2, 0.3}, {4, 5, 3});
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {1, 0, 0}, lamp).rectangle({1, 0, 0}, {0, 0, 2}, {1, 0, 0}, dim);
    const Scene scene(builder.file(), 1.0, true);
    const ScratchFolder folder;
    const CsvTable table = read_csv(
        folder.write("a.csv", patch_table(scene, std::vector<Rgb>(scene.patch_count(), Rgb{1, 2, 3}), {}, {})));
    REQUIRE(table.rows.size() == scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const auto colour = [&](const std::string& name) {
            const auto channel = [&](const char* c) {
                return table.number(table.rows[i], table.column((name + c).c_str()));
            };
            return Rgb{channel("_r"), channel("_g"), channel("_b")};
        };
        CHECK(colour("reflectance") == scene.reflectance(i));
        CHECK(colour("emittance") == scene.emittance(i));
    }
}

TEST_CASE("patches of one side with different areas have their own")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {1, 0, 0}, builder.grey(0.5, 1.0));
    const Scene scene = Scene(builder.file(), 1.0).refined({0, 1, 1, 1, 1});
    std::istringstream table(patch_table(scene, std::vector<Rgb>(5), {}, {}));
    std::string row;
    std::getline(table, row);
    for (const char* const columns :
         {",0.5,0,0.5,0,1,0,1,0.5,", ",0.25,0,1.25,0,1,0,0.25,0.5,"}) { // to the reflectance
        std::getline(table, row);
        CHECK(row.find(columns) != std::string::npos);
    }
}

TEST_CASE("standard errors, where there are any, are the last columns")
{
    SceneBuilder builder;
    const Scene scene = builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, builder.grey(0.5, 1.0)).scene(1.0);
    std::istringstream table(patch_table(scene, {{1, 2, 3}}, {{0.5, 0.25, 0.125}}, {}));
    std::string row;
    std::getline(table, row);
    CHECK(row.substr(row.size() - 36) == ",radiosity_b,error_r,error_g,error_b");
    std::getline(table, row);
    CHECK(row.substr(row.size() - 21) == ",1,2,3,0.5,0.25,0.125");
}

TEST_CASE("a table is read back to the same doubles and comments")
{
    check_round_trip({});
    check_round_trip(awkward_values(awkward_scene().patch_count(), 2));
}

TEST_CASE("columns are found by their names, in any order, and others are ignored")
{
    const PatchTable table = read_text("radiosity_b,area,note,patch,radiosity_r,radiosity_g,z,y,x,material,surface\n"
                                       "3,0.5,?,0,1,2,6,5,4,lamp,4294967295\n");
    CHECK(table.radiosity == std::vector<Rgb>{{1, 2, 3}});
    CHECK(table.areas == std::vector<double>{0.5});
    CHECK(table.standard_error.empty());
    CHECK(table.comments.empty());
}

TEST_CASE("what is no table of patches is refused with its line")
{
    CHECK(problem("n,x0,x1\n0,0,0\n") == ":1: no column `patch`, expected a column of that name");
    CHECK(problem("# c\n" + header + ",error_g\n") == ":2: no column `error_r`, expected a column of that name");
    CHECK(problem("# c\n" + header + "\n") == ":2: no rows after the header, expected one per patch");
    CHECK(problem(header + "\n0,0,a,0,0,0,1,1,1,1\n2,0,a,0,0,0,1,1,1,1\n") ==
          ":3: patch is `2`, expected 1, since patches are numbered from 0");
    CHECK(problem(header + "\n0.0,0,a,0,0,0,1,1,1,1\n") ==
          ":2: patch is `0.0`, expected 0, since patches are numbered from 0");
    CHECK(problem(header + "\n0,0,a,0,0,0,0,1,1,1\n") == ":1: all areas are 0, expected a patch with an area");
    CHECK(problem(header + "\n0,0,a,0,0,0,-1,1,1,1\n") == ":2: area is `-1`, expected 0 or more");
    CHECK(problem(header + "\n0,0,a,0,0,0,?,1,1,1\n") == ":2: area: `?` is not a finite number");
    CHECK(problem(header + "\n0,0,a,0,0,0,1,1,inf,1\n") == ":2: radiosity_g: `inf` is not a finite number");
    CHECK(problem(header + ",error_r,error_g,error_b\n0,0,a,0,0,0,1,1,1,1,0,-1e-9,0\n") ==
          ":2: error_g is `-1e-9`, expected 0 or more");
    CHECK(problem(header + "\n0,0,a,0,0,0,1,1,1\n") == ":2: row has 9 fields, expected 10 as in the header");
}

} // namespace patch_table_test

#include "export/patch_table.h"

#include "test_scenes.h"

#include <doctest/doctest.h>
#include <sstream>

namespace patch_table_test {

using namespace multipath;

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

} // namespace patch_table_test

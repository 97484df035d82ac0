// What the bundled scenes promise in their comments: sizes, soundness, the paper's figures, exact solutions.

#include "radiosity/paper/direct_light.h"
#include "radiosity/paper/line_budget.h"
#include "radiosity/run/solve.h"
#include "scene/obj/obj_reader.h"
#include "scene/tessellation.h"
#include "seeded_runs.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bundled_scenes_test {

using namespace multipath;

namespace {

SceneFile bundled(const std::string& name)
{
    return read_obj("scenes/" + name + ".obj");
}

Scene bundled_scene(const std::string& name)
{
    SceneFile file = bundled(name);
    const double patch_size = default_patch_size(file.surfaces);
    return Scene(std::move(file), patch_size);
}

/// Every surface is one patch: a size larger than any bundled scene.
Scene uncut_scene(const std::string& name)
{
    return Scene(bundled(name), 100.0);
}

double box_area(double a, double b, double c)
{
    return 2.0 * (a * b + b * c + c * a);
}

SolveOptions options_of(std::uint64_t lines)
{
    SolveOptions options = random_lines(SolveOptions().method, lines, 1);
    options.ratio = 0.5;
    options.threads = 2;
    return options;
}

/// The walls of a room make one solid (seen from inside), everything else is one solid, or a few, per group.
std::string solid_of(const std::string& group)
{
    const bool is_wall = group.size() > 5 && group.compare(group.size() - 5, 5, "_wall") == 0;
    const bool is_band = group.compare(0, 5, "north") == 0 || group.compare(0, 5, "south") == 0;
    const bool is_attic = group == "slope" || group == "window_reveal" || group == "roof_reveal";
    return is_wall || is_band || is_attic || group == "floor" || group == "ceiling" ? "room" : group;
}

/// By Gauss: both are integrals over the surface, and of a closed one the first is zero.
struct Solid
{
    Vec3 area_vector;    ///< [m^2]
    double volume = 0.0; ///< [m^3] positive when the faces look outwards
};

std::map<std::string, Solid> solids_of(const SceneFile& file)
{
    std::map<std::string, Solid> solids;
    for (std::size_t s = 0; s < file.surfaces.size(); ++s) {
        Solid& solid = solids[solid_of(file.groups[file.group[s]])];
        const Surface& surface = file.surfaces[s];
        const Vec3 area_vector = surface.area() * surface.normal();
        solid.area_vector = solid.area_vector + area_vector;
        solid.volume += dot(surface.centre(), area_vector) / 3.0;
    }
    return solids;
}

BudgetFigures figures_of(const Scene& scene)
{
    const DirectLight direct = measure_direct_light(scene, 1u << 20, 2);
    return {intersections_per_line(scene), mean(scene.average_reflectance()), direct.secondary_reflectance,
            direct.lit_fraction};
}

/// |a - b| up to the tolerance; doctest's Approx is relative.
bool within(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

} // namespace

// Areas from the measures of the boxes, powers from area times Ke. The corners of turned cubes have four digits
// (5CUBES: 2 x 0.00005 in an edge of 0.72), which is 1e-4 of the area at most.
TEST_CASE("the bundled scenes have the faces, area and power that their measures give, and raise no warning")
{
    struct Expected
    {
        std::string name;
        std::size_t surfaces;
        double area;
        double power;
        std::uint32_t default_patches; // 0: not said
    };
    const double chair = box_area(0.4, 0.03, 0.4) + box_area(0.4, 0.4, 0.03) + 4 * box_area(0.03, 0.42, 0.03);
    const double table = box_area(1.4, 0.04, 0.8) + 4 * box_area(0.05, 0.7, 0.05);
    const double lamp = box_area(1, 0.02, 1) + 2 * box_area(1.04, 0.2, 0.02) + 2 * box_area(0.02, 0.2, 1) +
                        4 * box_area(0.01, 0.23, 0.01);
    const double chairs = box_area(7.25, 3.05, 7.25) + table + 4 * chair + 6 * 0.2 * 0.2 + lamp;
    const double five = 6 * 9 + 5 * 6 * 0.72 * 0.72 + box_area(0.6, 0.03, 0.6);
    const double cornell = box_area(0.55, 0.55, 0.56) - 0.55 * 0.55 + box_area(0.165, 0.33, 0.165) +
                           box_area(0.165, 0.165, 0.165) + box_area(0.13, 0.01, 0.1);
    const std::vector<Expected> all = {
        {"5cubes", 42, five, 0.36 * 25, 3198},
        {"4chairs", 240, chairs, 100, 3760},
        {"4chairs-up", 240, chairs, 100, 3760},
        {"cornell", 23, cornell, 0.013 * 245 / 3, 3360},
        {"cube", 6, 6, 3.5, 3750},
        {"furnace", 6, 6, 6, 3750},
        {"sphere", 2 * 24 + 10 * 48, 12.388, 10.580, 0},
        {"squares", 2, 2, 1, 3200},
    };
    for (const Expected& expected : all) {
        CAPTURE(expected.name);
        const Scene scene = bundled_scene(expected.name);
        CHECK(scene.file().warnings.empty());
        CHECK(scene.surfaces().size() == expected.surfaces);
        CHECK(scene.total_area() == doctest::Approx(expected.area).epsilon(1e-4));
        CHECK(mean(scene.source_power()) == doctest::Approx(expected.power).epsilon(1e-4));
        if (expected.default_patches > 0)
            CHECK(scene.patch_count() == expected.default_patches);
    }
}

// The area vectors of a closed surface add up to nothing; rounding in the coordinates cancels, as corners are shared.
TEST_CASE("every solid of the bundled scenes is closed and looks outwards, every room inwards")
{
    for (const char* name : {"5cubes", "4chairs", "4chairs-up", "cornell", "cube", "furnace", "sphere", "studio"}) {
        CAPTURE(name);
        for (const auto& named : solids_of(bundled(name))) {
            const std::string& solid_name = named.first;
            const Solid& solid = named.second;
            CAPTURE(solid_name);
            const bool is_open =
                solid_name == "room" && (std::string(name) == "cornell" || std::string(name) == "studio");
            CHECK((length(solid.area_vector) < 1e-12) == !is_open);
            CHECK((solid.volume < 0.0) == (solid_name == "room"));
        }
    }
    CHECK(bundled("squares").surfaces[0].normal().y == -1.0);
    CHECK(bundled("squares").surfaces[1].normal().y == 1.0);
}

// Where solids cut through each other or a gap opens, some of the lines meet backs or leave the scene.
TEST_CASE("no power escapes from the closed bundled scenes or gets behind a surface")
{
    for (const char* name : {"5cubes", "4chairs", "4chairs-up", "cube", "furnace", "sphere"}) {
        CAPTURE(name);
        const PowerBalance balance = solve(uncut_scene(name), options_of(1u << 17), silent).balance;
        CHECK(balance.escaped == Rgb{});
        CHECK(balance.behind == Rgb{});
    }
}

TEST_CASE("the front of the bundled Cornell box lets 30 % of the light out")
{
    const Scene scene = bundled_scene("cornell");
    const PowerBalance balance = solve(scene, options_of(1u << 17), silent).balance;
    CHECK(within(mean(balance.escaped) / mean(balance.emitted), 0.30, 0.01)); // said with two digits
    CHECK(balance.behind == Rgb{});
}

// The paper, its Figures 6 to 9. The tolerances are what its rounded figures allow; f counts whole patches, so that it
// belongs to this patch size.
TEST_CASE("4CHAIRS gives the paper's figures, lit downwards and upwards" * doctest::test_suite("statistics"))
{
    const Scene down = bundled_scene("4chairs");
    const Scene up = bundled_scene("4chairs-up");
    for (const Scene* scene : {&down, &up}) {
        CHECK(scene->patch_size() == 0.25);
        CHECK(within(mean(scene->average_reflectance()), 0.577, 0.001));
        CHECK(within(intersections_per_line(*scene), 2.10, 0.05));
    }
    const BudgetFigures downwards = figures_of(down);
    CHECK(within(downwards.lit_fraction, 0.670, 0.005));
    CHECK(within(downwards.secondary_reflectance, 0.650, 0.005));
    CHECK(within(optimal_ratio(downwards).value(), 0.85, 0.01));
    CHECK(within(optimal_ratio(extended_figures(downwards)).value(), 1.06, 0.015));

    const BudgetFigures upwards = figures_of(up);
    CHECK(within(upwards.lit_fraction, 0.073, 0.001));
    CHECK(within(upwards.secondary_reflectance, 0.700, 0.005));
    CHECK(within(optimal_ratio(upwards).value(), 0.41, 0.01));
    CHECK(within(optimal_ratio(extended_figures(upwards)).value(), 1.06, 0.015));
}

TEST_CASE("4chairs and 4chairs-up differ in nothing but the side of the panel that shines")
{
    const SceneFile down = bundled("4chairs");
    const SceneFile up = bundled("4chairs-up");
    REQUIRE(down.surfaces.size() == up.surfaces.size());
    std::vector<Vec3> shining;
    for (std::size_t s = 0; s < down.surfaces.size(); ++s) {
        const Surface& a = down.surfaces[s];
        const Surface& b = up.surfaces[s];
        CHECK((a.origin == b.origin && a.edge_u == b.edge_u && a.edge_v == b.edge_v));
        const Material& material_down = down.materials[down.material[s]];
        const Material& material_up = up.materials[up.material[s]];
        CHECK(material_down.reflectance == material_up.reflectance);
        if (!(material_down.emittance == material_up.emittance))
            shining.push_back(mean(material_down.emittance) * a.normal() - mean(material_up.emittance) * b.normal());
    }
    REQUIRE(shining.size() == 2);
    for (const Vec3 power_per_area : shining) // 100 W/m^2 down in one file, up in the other
        CHECK(power_per_area == Vec3{0.0, -100.0, 0.0});
}

// Whether the six-digit numbers of the comment solve the system of equations is checked first.
TEST_CASE("the bundled cube has the radiosities that its comment tells")
{
    const std::array<double, 6> exact = {0.426826, 2.764501, 0.926181, 1.594759, 0.808116, 1.021674};
    const Scene scene = uncut_scene("cube");
    const std::vector<Estimate> found = radiosities(scene, options_of(1u << 14), 24, {0, 1, 2, 3, 4, 5});
    for (std::uint32_t i = 0; i < 6; ++i) {
        CAPTURE(i);
        double incident = 0.0;
        for (std::uint32_t j = 0; j < 6; ++j)
            incident += i == j ? 0.0 : (i / 2 == j / 2 ? 0.199825 : 0.200044) * exact[j];
        CHECK(within(exact[i], scene.emittance(i).g + scene.reflectance(i).g * incident, 5e-6));
        CHECK(found[i].agrees_with(exact[i]));
    }
}

TEST_CASE("the bundled furnace has radiosity 2 in all colours")
{
    const Scene scene = uncut_scene("furnace");
    const std::vector<Estimate> found = all_over_seeds(scene, options_of(1u << 14), 24, [](const Solution& s) {
        return std::vector<double>{s.radiosity[0].r, s.radiosity[0].g, s.radiosity[0].b};
    });
    for (const Estimate& channel : found)
        CHECK(channel.agrees_with(2.0));
}

// The facets deviate from the law of the sphere by up to 0.3 %, as the comment of the scene says.
TEST_CASE("the bands of the bundled sphere have the radiosities that its comment tells")
{
    const std::array<double, 4> exact = {1.61134, 2.53711, 1.07422, 1.89519};
    const Scene scene = uncut_scene("sphere");
    const std::vector<Estimate> found = all_over_seeds(scene, options_of(1u << 16), 8, [&](const Solution& s) {
        std::vector<double> power(exact.size());
        std::vector<double> area(exact.size());
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const std::uint32_t band = scene.file().group[scene.surface_of(i)];
            power[band] += scene.area(i) * s.radiosity[i].g;
            area[band] += scene.area(i);
        }
        for (std::size_t band = 0; band < exact.size(); ++band)
            power[band] /= area[band];
        return power;
    });
    for (std::size_t band = 0; band < exact.size(); ++band) {
        CAPTURE(band);
        CHECK(within(found[band].mean, exact[band], 0.003 * exact[band] + 4.0 * found[band].standard_error));
    }
}

TEST_CASE("the bundled squares lose the power that their comment tells")
{
    CHECK(over_seeds(uncut_scene("squares"), options_of(1u << 14), 24, [](const Solution& s) {
              return s.balance.escaped.g;
          }).agrees_with(0.922414));
}

} // namespace bundled_scenes_test

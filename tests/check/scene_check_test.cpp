#include "check/scene_check.h"

#include "check/scene_report.h"
#include "radiosity/paper/line_budget.h"
#include "sampling/sequence.h"
#include "scene/tessellation.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>

namespace scene_check_test {

using namespace multipath;

namespace {

std::vector<Finding> findings_of(const Scene& scene)
{
    return findings_of(scene, report_on(scene, 20000, 2));
}

/// The finding of this kind; empty kind when there is none.
Finding find(const std::vector<Finding>& findings, const std::string& kind)
{
    const auto found = std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.kind == kind; });
    return found == findings.end() ? Finding{} : *found;
}

bool mentions(const Finding& finding, const std::string& words)
{
    return finding.message.find(words) != std::string::npos;
}

bool advises(const Finding& finding, Remedy remedy)
{
    return std::any_of(finding.advice.begin(), finding.advice.end(),
                       [&](const Advice& advice) { return advice.remedy == remedy; });
}

struct Materials
{
    SceneBuilder builder;
    std::uint32_t wall = builder.grey(0.6, 0.0);
    std::uint32_t lamp = builder.grey(0.0, 10.0);
};

} // namespace

TEST_CASE("a sound scene has no findings")
{
    Materials m;
    m.builder.room({0, 0, 0}, {2, 2, 2}, {m.wall, m.lamp, m.wall, m.wall, m.wall, m.wall});
    m.builder.box({0.5, 0.1, 0.5}, {1, 0.7, 1}, m.wall);
    CHECK(findings_of(m.builder.scene(0.5)).empty());
}

// The box covers a quarter of the floor; what the covered floor sends up meets the box's top from inside.
TEST_CASE("a box without a bottom on a floor is found, with the faces that are met from behind")
{
    Materials m;
    m.builder.room({0, 0, 0}, {2, 2, 2}, {m.lamp, m.wall, m.wall, m.wall, m.wall, m.wall});
    m.builder.box({0.5, 0, 0.5}, {1.5, 1, 1.5}, m.wall);
    SceneFile file = m.builder.file();
    file.surfaces.erase(file.surfaces.begin() + 6); // the bottom
    file.material.erase(file.material.begin() + 6);
    file.line.erase(file.line.begin() + 6);
    file.group.pop_back();
    const Finding finding = find(findings_of(Scene(file, 0.5)), "behind");
    CHECK(finding.makes_wrong_result);
    const Rgb lost = report_on(Scene(file, 0.5), 20000, 1).balance.behind;
    CHECK(lost.g == doctest::Approx(0.25 * 40.0).epsilon(0.03)); // a quarter of what the floor emits
    CHECK(mentions(finding, "needs its bottom"));
    CHECK(mentions(finding, "(line 8)")); // the top
    CHECK(find(findings_of(Scene(file, 0.5, true)), "behind").kind.empty());
}

TEST_CASE("an emitter that faces away from everything is found")
{
    Materials m;
    m.builder.room({0, 0, 0}, {2, 2, 2}, {m.wall, m.lamp, m.wall, m.wall, m.wall, m.wall});
    m.builder.rectangle({0, 2.5, 0}, {0, 0, 1}, {1, 0, 0}, m.lamp); // above the ceiling, looks up
    const Finding finding = find(findings_of(m.builder.scene(0.5)), "emitter");
    CHECK(finding.makes_wrong_result);
    CHECK(finding.place == "memory:7");
    CHECK(mentions(finding, "emitters that light nothing"));
}

// Many or few, they are one finding; below half a percent of the power it is a remark.
TEST_CASE("emitters that light nothing are one finding, wrong if they have a share of the power")
{
    for (const double size : {0.4, 0.02}) {
        Materials m;
        m.builder.room({0, 0, 0}, {2, 2, 2}, {m.wall, m.lamp, m.wall, m.wall, m.wall, m.wall});
        for (const double x : {0.2, 0.8, 1.4})
            m.builder.rectangle({x, 2.5, 0}, {0, 0, size}, {size, 0, 0}, m.lamp);
        const std::vector<Finding> findings =
            findings_of(m.builder.scene(0.5), report_on(m.builder.scene(0.5), 200000, 2));
        const Finding finding = find(findings, "emitter");
        CHECK(std::count_if(findings.begin(), findings.end(), [](const Finding& f) { return f.kind == "emitter"; }) ==
              1);
        CHECK(mentions(finding, "emitters that light nothing"));
        CHECK(mentions(finding, "(line 9)"));
        CHECK(finding.place == "memory:7");
        CHECK(finding.power_share == doctest::Approx(3 * size * size / (4.0 + 3 * size * size)));
        CHECK(finding.makes_wrong_result == (size > 0.1));
    }
}

TEST_CASE("wrong findings come first, then the heaviest")
{
    Materials m;
    m.builder.room({0, 0, 0}, {2, 2, 2}, {m.wall, m.lamp, m.wall, m.wall, m.wall, m.wall});
    m.builder.rectangle({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, m.wall);   // light from below is lost behind it
    m.builder.rectangle({0, 2.5, 0}, {0, 0, 1}, {1, 0, 0}, m.lamp); // above the ceiling
    const std::vector<Finding> findings = findings_of(m.builder.scene(0.5));
    CHECK(findings.size() >= 3);
    for (std::size_t k = 1; k < findings.size(); ++k) {
        CHECK((findings[k - 1].makes_wrong_result || !findings[k].makes_wrong_result));
        if (findings[k - 1].makes_wrong_result == findings[k].makes_wrong_result)
            CHECK(findings[k - 1].power_share >= findings[k].power_share);
    }
}

TEST_CASE("in a room whose faces and lamp look outward, turning all is advised, beside a lit lamp it is not")
{
    Materials m;
    m.builder.box({0, 0, 0}, {2, 2, 2}, m.wall);
    m.builder.rectangle({0.5, 1.9, 0.5}, {0, 0, 1}, {1, 0, 0}, m.lamp); // looks up, as a lamp in a mirrored room
    const Scene outward = m.builder.scene(0.5);
    CHECK(advises(find(findings_of(outward), "behind"), Remedy::two_sided));
    CHECK(advises(find(findings_of(outward), "emitter"), Remedy::flip));
    const Scene turned(flipped(m.builder.file()), 0.5);
    CHECK(find(findings_of(turned), "emitter").kind.empty());

    Materials lit;
    lit.builder.room({0, 0, 0}, {2, 2, 2}, {lit.wall, lit.lamp, lit.wall, lit.wall, lit.wall, lit.wall});
    lit.builder.rectangle({0, 2.5, 0}, {0, 0, 1}, {1, 0, 0}, lit.lamp); // above the ceiling, looks up
    const Finding finding = find(findings_of(lit.builder.scene(0.5)), "emitter");
    CHECK(!finding.kind.empty());
    CHECK_FALSE(advises(finding, Remedy::flip));
}

TEST_CASE("copies of a face are a remark, unless they emit")
{
    for (const bool emits : {false, true}) {
        Materials m;
        m.builder.room({0, 0, 0}, {2, 2, 2}, {m.wall, m.lamp, m.wall, m.wall, m.wall, m.wall});
        if (emits)
            m.builder.rectangle({0, 2, 0}, {2, 0, 0}, {0, 0, 2}, m.lamp);
        else
            m.builder.rectangle({0, 0, 2}, {2, 0, 0}, {0, 0, -2}, m.wall); // from another corner
        const std::vector<Finding> findings = findings_of(m.builder.scene(0.5));
        CHECK(find(findings, "copy").kind.empty() == emits);
        CHECK(find(findings, "duplicate").makes_wrong_result == emits);
    }
}

TEST_CASE("a leak is wrong, an open side or a tiny gap is a remark")
{
    for (const double gap : {0.001, 0.05, 1.0}) {
        Materials m;
        m.builder.room({0, 0, 0}, {2, 2, 2}, {m.wall, m.lamp, m.wall, m.wall, m.wall, m.wall});
        SceneFile file = m.builder.file();
        file.surfaces[0].edge_u = {0, 0, 2.0 - gap}; // the floor ends before the wall
        const std::vector<Finding> findings = findings_of(Scene(file, 0.5));
        CHECK(find(findings, gap < 0.1 ? "leak" : "open").kind != "");
        CHECK(find(findings, "leak").makes_wrong_result == (gap == 0.05));
    }
}

TEST_CASE("doubled faces, bright materials and strange scales are named")
{
    SceneBuilder builder;
    const std::uint32_t white = builder.grey(0.97, 0.0);
    const std::uint32_t lamp = builder.grey(0.0, 1.0);
    builder.room({0, 0, 0}, {2000, 2000, 2000}, {white, lamp, white, white, white, white});
    builder.rectangle({500, 0, 500}, {0, 0, 500}, {500, 0, 0}, white);
    for (const bool two_sided : {false, true}) {
        CAPTURE(two_sided);
        const std::vector<Finding> findings = findings_of(Scene(builder.file(), 1000, two_sided));
        CHECK(find(findings, "duplicate").makes_wrong_result);
        CHECK(find(findings, "duplicate").place == "memory:7");
        CHECK(find(findings, "duplicate").area_share == doctest::Approx(0.25 / 24.25));
        CHECK(mentions(find(findings, "reflectance"), "97 %"));
        CHECK(find(findings, "reflectance").area_share == doctest::Approx(20.25 / 24.25));
        CHECK(mentions(find(findings, "scale"), "m across"));
        CHECK(findings.front().makes_wrong_result); // wrong results first
        CHECK(!findings.back().makes_wrong_result);
    }
}

TEST_CASE("a material that reflects too much of one colour is as bright as one of another colour")
{
    std::vector<Finding> found;
    for (const Rgb rho : {Rgb{0.98, 0.2, 0.3}, Rgb{0.3, 0.98, 0.2}, Rgb{0.2, 0.3, 0.98}}) {
        Materials m;
        const std::uint32_t neon = m.builder.material("neon", rho, {});
        const std::uint32_t pale = m.builder.material("pale", {0.94, 0.94, 0.94}, {});
        m.builder.room({0, 0, 0}, {2, 1, 3}, {neon, m.lamp, m.wall, pale, m.wall, m.wall});
        found.push_back(find(findings_of(m.builder.scene(1.0)), "reflectance"));
        CHECK(mentions(found.back(), "materials that reflect up to 98 % of the light"));
        CHECK(found.back().message == found.front().message);
        CHECK(found.back().area_share == doctest::Approx(6.0 / 22.0));
    }
}

TEST_CASE("what the reader noticed is passed on")
{
    Materials m;
    const std::uint32_t oak = m.builder.material("oak", {0.5, 0.5, 0.5}, {});
    SceneFile file = m.builder.room({0, 0, 0}, {2, 2, 2}, {oak, m.lamp, m.wall, m.wall, m.wall, m.wall}).file();
    file.warnings = {"room.obj:5: polygon is not planar"};
    file.unused_materials = {"room.mtl:3: gold", "room.mtl:5: tin"};
    file.unknown_materials = {"oak"};
    const std::vector<Finding> findings = findings_of(Scene(file, 1.0));
    CHECK(find(findings, "reader").place == "room.obj:5");
    CHECK(find(findings, "unused-material").place == "room.mtl:3");
    CHECK(mentions(find(findings, "unused-material"), "materials that no face uses: 'gold', 'tin'"));
    CHECK(find(findings, "unknown-material").makes_wrong_result);
    CHECK(find(findings, "unknown-material").area_share == doctest::Approx(1.0 / 6.0));
}

TEST_CASE("hundreds of copies of a face are measured with fewer lines")
{
    Materials m;
    m.builder.room({0, 0, 0}, {2, 2, 2}, {m.wall, m.lamp, m.wall, m.wall, m.wall, m.wall});
    for (int copy = 0; copy < 400; ++copy)
        m.builder.rectangle({0.5, 1, 0.5}, {0, 0, 1}, {1, 0, 0}, m.wall);
    const Scene scene = m.builder.scene(2.0);
    const SceneReport report = report_on(scene, 20000, 2);
    CHECK(report.survey.lines < 10000);
    CHECK(report.intersections_measured == doctest::Approx(report.figures.intersections).epsilon(0.1));
    const std::vector<Finding> findings = findings_of(scene, report);
    CHECK(mentions(find(findings, "copy"), "at least 10000 pairs"));
}

} // namespace scene_check_test

namespace mesh_faults_test {

using namespace multipath;

TEST_CASE("coincident faces are found that look the same way")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey);            // 0: a floor
    builder.rectangle({0.6, 0, 0.6}, {0.3, 0, 0}, {0, 0, 0.3}, grey);    // 1: the bottom of a box on it, looks down
    builder.triangle({0.1, 0, 0.1}, {0.1, 0, 0.4}, {0.4, 0, 0.1}, grey); // 2: a second floor, looks up
    builder.rectangle({1, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey);            // 3: a neighbour that only touches
    builder.rectangle({0.1, 0.1, 0.1}, {0, 0, 0.1}, {0.1, 0, 0}, grey);  // 4: above
    builder.rectangle({0.7, 0, 0.7}, {0, 0, 0.1}, {0.1, 0, 0}, grey);    // 5: a small one on the floor, looks up
    const CoincidentPairs found = find_coincident_faces(builder.scene(1.0), 100);
    CHECK(found.complete);
    CHECK(found.pairs == std::set<std::pair<std::uint32_t, std::uint32_t>>{{0, 2}, {0, 5}});
    CHECK(find_coincident_faces(builder.scene(1.0), 1).pairs.size() == 1);
    CHECK(!find_coincident_faces(builder.scene(1.0), 1).complete);
}

TEST_CASE("a closed room has no open edge, a room without one wall has four")
{
    SceneBuilder closed;
    const std::uint32_t grey = closed.grey(0.5, 1.0);
    closed.room({0, 0, 0}, {1, 2, 3}, grey).box({0.2, 0.2, 0.2}, {0.5, 0.5, 0.5}, grey);
    SurfaceList surfaces = closed.file().surfaces;
    CHECK(surfaces_with_open_edges(surfaces).empty());

    surfaces.erase(surfaces.begin()); // the floor
    CHECK(surfaces_with_open_edges(surfaces) == std::vector<std::uint32_t>{1, 2, 3, 4});
}

// Corners are computed as origin + edge, which rounds.
TEST_CASE("a turned room without one wall has four open edges, wherever it stands")
{
    std::uint64_t item = 0;
    const auto sequence = make_sequence("random", 1);
    for (int room = 0; room < 20; ++room) {
        const Item at = sequence->item(item++);
        const Item turn = sequence->item(item++);
        const double a = 6.0 * turn[0];
        const Vec3 x = {std::cos(a), 0.0, std::sin(a)};
        const Vec3 z = {-std::sin(a), 0.0, std::cos(a)};
        const auto corner = [&](int i, int j, int k) {
            return 10.0 * Vec3{at[0], at[1], at[2]} + (1.0 + turn[1]) * i * x + Vec3{0.0, (1.0 + turn[2]) * j, 0.0} +
                   (1.0 + turn[3]) * k * z;
        };
        SurfaceList surfaces;
        const auto face = [&](Vec3 p, Vec3 q, Vec3 r) { surfaces.push_back({Shape::parallelogram, p, q - p, r - p}); };
        face(corner(0, 0, 0), corner(0, 0, 1), corner(1, 0, 0));
        face(corner(0, 1, 0), corner(1, 1, 0), corner(0, 1, 1));
        face(corner(0, 0, 0), corner(1, 0, 0), corner(0, 1, 0));
        face(corner(1, 0, 1), corner(0, 0, 1), corner(1, 1, 1));
        face(corner(0, 0, 1), corner(0, 0, 0), corner(0, 1, 1));
        CHECK(surfaces_with_open_edges(surfaces) == std::vector<std::uint32_t>{0, 1, 2, 3});
        face(corner(1, 0, 0), corner(1, 0, 1), corner(1, 1, 0));
        CHECK(surfaces_with_open_edges(surfaces).empty());
    }
}

TEST_CASE("triangles are closed by triangles that run along their edges the other way")
{
    const Vec3 p = {0, 0, 0}, q = {1, 0, 0}, r = {0, 1, 0}, s = {0, 0, 1};
    const auto face = [](Vec3 a, Vec3 b, Vec3 c) { return Surface{Shape::triangle, a, b - a, c - a}; };
    CHECK(surfaces_with_open_edges({face(p, r, q), face(p, q, s), face(q, r, s), face(p, s, r)}).empty());
    CHECK(surfaces_with_open_edges({face(p, r, q), face(p, q, s), face(q, r, s), face(p, r, s)}).size() == 4);
}

} // namespace mesh_faults_test

#include "radiosity/scene_lint.h"

#include "test_scenes.h"

#include <algorithm>
#include <doctest/doctest.h>

using namespace multipath;

namespace {

std::vector<Finding> findings_of(const Scene& scene)
{
    return lint(scene, report_on(scene, 20000, 2));
}

/// The finding of this kind; empty kind when there is none.
Finding find(const std::vector<Finding>& findings, const std::string& kind)
{
    const auto found = std::find_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.kind == kind; });
    return found == findings.end() ? Finding{"", false, "", ""} : *found;
}

bool mentions(const Finding& finding, const std::string& words)
{
    return finding.message.find(words) != std::string::npos;
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
    CHECK(mentions(finding, "lights nothing"));
}

TEST_CASE("a small leak is wrong, an open side is a remark")
{
    for (const double gap : {0.01, 1.0}) {
        Materials m;
        m.builder.room({0, 0, 0}, {2, 2, 2}, {m.wall, m.lamp, m.wall, m.wall, m.wall, m.wall});
        SceneFile file = m.builder.file();
        file.surfaces[0].edge_u = {0, 0, 2.0 - gap}; // the floor ends before the wall
        const std::vector<Finding> findings = findings_of(Scene(file, 0.5));
        CHECK(find(findings, gap < 0.1 ? "leak" : "open").kind != "");
        CHECK(find(findings, "leak").makes_wrong_result == (gap < 0.1));
    }
}

TEST_CASE("doubled faces, bright materials and strange scales are named")
{
    SceneBuilder builder;
    const std::uint32_t white = builder.grey(0.97, 0.0);
    const std::uint32_t lamp = builder.grey(0.0, 1.0);
    builder.room({0, 0, 0}, {2000, 2000, 2000}, {white, lamp, white, white, white, white});
    builder.rectangle({500, 0, 500}, {0, 0, 100}, {100, 0, 0}, white);
    const std::vector<Finding> findings = findings_of(builder.scene(1000));
    CHECK(find(findings, "duplicate").makes_wrong_result);
    CHECK(find(findings, "duplicate").place == "memory:7");
    CHECK(mentions(find(findings, "reflectance"), "97 %"));
    CHECK(mentions(find(findings, "scale"), "m across"));
    CHECK(findings.front().makes_wrong_result); // wrong results first
    CHECK(!findings.back().makes_wrong_result);
}

TEST_CASE("what the reader noticed is passed on")
{
    Materials m;
    SceneFile file = m.builder.room({0, 0, 0}, {2, 2, 2}, m.lamp).file();
    file.warnings = {"room.obj:5: polygon is not planar"};
    file.unused_materials = {"room.mtl:3: gold"};
    file.unknown_materials = {"oak"};
    file.dropped_faces = 2;
    const std::vector<Finding> findings = findings_of(Scene(file, 1.0));
    CHECK(find(findings, "reader").place == "room.obj:5");
    CHECK(find(findings, "unused-material").place == "room.mtl:3");
    CHECK(mentions(find(findings, "unused-material"), "'gold'"));
    CHECK(find(findings, "unknown-material").makes_wrong_result);
    CHECK(mentions(find(findings, "zero-area"), "2 faces"));
}

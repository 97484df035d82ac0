#include "scene/partitions.h"

#include "geometry/intersector/surface_sizes.h"
#include "seeded_runs.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <string>
#include <vector>

namespace partitions_test {

using namespace multipath;

namespace {

constexpr double reflectance = 0.6;
constexpr Vec3 room_size = {6, 3, 4};

/// A room with a partition. Its wall at x = 0 is the lamp.
struct Case
{
    std::string name;
    std::function<void(SceneBuilder&, std::uint32_t)> build;
    std::function<double(Vec3)> beyond; ///< positive beyond the partition
    bool two_sided = false;
    bool triangles = false; ///< the room is made of triangles
    double distance = 0.0;  ///< from the origin; the scene is turned, too
};

/// Two sheets that stand back to back.
void sheets(SceneBuilder& builder, Vec3 corner, Vec3 edge_u, Vec3 edge_v, std::uint32_t wall)
{
    builder.rectangle(corner, edge_u, edge_v, wall);
    builder.rectangle(corner, edge_v, edge_u, wall);
}

void sheets_at(SceneBuilder& builder, double x, std::uint32_t wall)
{
    sheets(builder, {x, 0, 0}, {0, 3, 0}, {0, 0, 4}, wall);
}

std::vector<Case> cases()
{
    const auto right_of = [](double x) { return [x](Vec3 p) { return p.x - x; }; };
    std::vector<Case> all = {
        {"two sheets", [](SceneBuilder& b, std::uint32_t wall) { sheets_at(b, 3.1, wall); }, right_of(3.1)},
        {"one sheet with two sides",
         [](SceneBuilder& b, std::uint32_t wall) {
             b.rectangle({3.1, 0, 0}, {0, 3, 0}, {0, 0, 4}, wall);
         },
         right_of(3.1), true},
        {"thick wall",
         [](SceneBuilder& b, std::uint32_t wall) {
             b.box({3.1, 0, 0}, {3.23, 3, 4}, wall);
         },
         right_of(3.17)},
        {"thin box",
         [](SceneBuilder& b, std::uint32_t wall) {
             b.box({3.1, 0, 0}, {3.105, 3, 4}, wall);
         },
         right_of(3.104)},
        {"oblique plan",
         [](SceneBuilder& b, std::uint32_t wall) {
             sheets(b, {2, 0, 0}, {0, 3, 0}, {2, 0, 4}, wall);
         },
         [](Vec3 p) { return p.x - 2.0 - 0.5 * p.z; }},
        {"leaning",
         [](SceneBuilder& b, std::uint32_t wall) {
             sheets(b, {2.5, 0, 0}, {1, 3, 0}, {0, 0, 4}, wall);
         },
         [](Vec3 p) { return p.x - 2.5 - p.y / 3.0; }},
        {"L-shaped",
         [](SceneBuilder& b, std::uint32_t wall) {
             sheets(b, {3.1, 0, 0}, {0, 3, 0}, {0, 0, 1.7}, wall);
             sheets(b, {3.1, 0, 1.7}, {2.9, 0, 0}, {0, 3, 0}, wall);
         },
         [](Vec3 p) { return std::min(p.x - 3.1, 1.7 - p.z); }},
        {"of triangles",
         [](SceneBuilder& b, std::uint32_t wall) {
             const Vec3 y = {0, 0.5, 0}, z = {0, 0, 0.5};
             for (int i = 0; i < 6; ++i)
                 for (int j = 0; j < 8; ++j) {
                     const Vec3 p = Vec3{3.1, 0, 0} + i * y + j * z;
                     b.triangle(p, p + y, p + z, wall).triangle(p + y + z, p + z, p + y, wall);
                     b.triangle(p, p + z, p + y, wall).triangle(p + y + z, p + y, p + z, wall);
                 }
         },
         right_of(3.1)},
        {"through floor and ceiling",
         [](SceneBuilder& b, std::uint32_t wall) {
             sheets(b, {3.1, -0.5, 0}, {0, 4, 0}, {0, 0, 4}, wall);
         },
         right_of(3.1)},
        {"a ten-millionth above the floor",
         [](SceneBuilder& b, std::uint32_t wall) {
             sheets(b, {3.1, 1e-7, 0}, {0, 3 - 1e-7, 0}, {0, 0, 4}, wall);
         },
         right_of(3.1)},
        {"near the wall", [](SceneBuilder& b, std::uint32_t wall) { sheets_at(b, 5.9, wall); }, right_of(5.9)},
        {"several rooms",
         [](SceneBuilder& b, std::uint32_t wall) {
             sheets_at(b, 2.2, wall);
             sheets_at(b, 3.9, wall);
             sheets(b, {2.2, 0, 2.1}, {3.8, 0, 0}, {0, 3, 0}, wall);
         },
         right_of(2.2)},
    };
    for (std::size_t k = 0, count = all.size(); k < count; ++k) {
        Case triangles = all[k];
        triangles.triangles = true;
        triangles.name += ", room of triangles";
        all.push_back(triangles);
        Case turned = all[k];
        turned.distance = 1e4;
        turned.name += ", turned, far from the origin";
        all.push_back(turned);
    }
    return all;
}

/// Rotation about two axes.
Vec3 turned(Vec3 p)
{
    const double a = 0.6, b = 0.8; // cosine and sine
    const Vec3 q = {a * p.x - b * p.z, p.y, b * p.x + a * p.z};
    return {q.x, a * q.y - b * q.z, b * q.y + a * q.z};
}

/// The inverse rotation.
Vec3 turned_back(Vec3 p)
{
    const double a = 0.6, b = 0.8;
    const Vec3 q = {p.x, a * p.y + b * p.z, -b * p.y + a * p.z};
    return {a * q.x + b * q.z, q.y, -b * q.x + a * q.z};
}

Vec3 offset(const Case& c)
{
    return {c.distance, 2.0 * c.distance, -c.distance};
}

SceneFile file_of(const Case& c)
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(reflectance, 0.0);
    const std::uint32_t lamp = builder.grey(reflectance, 1.0);
    SceneBuilder room = builder;
    room.room({0, 0, 0}, room_size, {wall, wall, lamp, wall, wall, wall});
    const SceneFile walls = room.file();
    for (std::size_t s = 0; s < walls.surfaces.size(); ++s) {
        const Surface& side = walls.surfaces[s];
        if (c.triangles)
            builder.triangle(side.at(0, 0), side.at(1, 0), side.at(1, 1), walls.material[s])
                .triangle(side.at(0, 0), side.at(1, 1), side.at(0, 1), walls.material[s]);
        else
            builder.surface(side, walls.material[s]);
    }
    c.build(builder, wall);
    SceneFile file = builder.file();
    if (c.distance > 0.0)
        for (Surface& s : file.surfaces)
            s = {s.shape, turned(s.origin) + offset(c), turned(s.edge_u), turned(s.edge_v)};
    return file;
}

/// The place before the scene was turned.
Vec3 modelled(const Case& c, Vec3 p)
{
    return c.distance > 0.0 ? turned_back(p - offset(c)) : p;
}

double beyond(const Case& c, const Surface& patch)
{
    return c.beyond(modelled(c, patch.centre() + 1e-4 * patch.normal()));
}

double area_of(const SceneFile& file)
{
    double sum = 0.0;
    for (const Surface& s : file.surfaces)
        sum += s.area();
    return sum;
}

struct Power
{
    double lit = 0.0;
    double dark = 0.0;
};

/// [W] Reflected power on both sides of the partition.
Power reflected(const Case& c, const Scene& scene, const std::vector<Rgb>& radiosity)
{
    Power power;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        (beyond(c, scene.patch(i).shape) > 0.0 ? power.dark : power.lit) +=
            scene.area(i) * (radiosity[i] - scene.emittance(i)).g;
    return power;
}

Power reflected(const Case& c, const Scene& scene, Method method)
{
    SolveOptions options;
    options.method = method;
    options.lines = 64 * scene.patch_count();
    return reflected(c, scene, solve(scene, options, silent).radiosity);
}

} // namespace

TEST_CASE("behind a partition on floors that run on below it, it is dark")
{
    for (const Case& c : cases()) {
        CAPTURE(c.name);
        SceneFile file = file_of(c);
        const Scene whole(file, 0.5, c.two_sided);
        const PartitionCuts cuts = cut_at_partitions(file, c.two_sided);
        CHECK(cuts.surfaces >= 3);
        CHECK(cuts.pieces > cuts.surfaces);
        SceneFile again = file;
        CHECK(cut_at_partitions(again, c.two_sided).surfaces == 0);
        CHECK(area_of(file) == doctest::Approx(area_of(whole.file())).epsilon(1e-12));

        const Scene cut(file, 0.5, c.two_sided);
        const Power before = reflected(c, whole, Method::local);
        const Power after = reflected(c, cut, Method::local);
        CHECK(before.dark > 1e-3 * before.lit);
        const bool open = c.name.find("ten-millionth") != std::string::npos; // a ray at the corner passes
        CHECK(after.dark <= (open ? 1e-4 : 0.0) * after.lit);
    }
}

TEST_CASE("surfaces are cut along the same lines, however many pieces of the partition lie on them")
{
    for (const Case& c : cases()) {
        CAPTURE(c.name);
        SceneFile few = file_of(c);
        SceneFile many = few;
        const std::size_t count = few.surfaces.size();
        for (std::size_t s = c.triangles ? 12 : 6; s < count; ++s) // parts of its edges again
            for (const double from : {0.3, 0.6}) {
                const Surface part = few.surfaces[s];
                many.surfaces.push_back({part.shape, part.at(from, 0.0), 0.2 * part.edge_u, 0.3 * part.edge_v});
                many.surfaces.push_back({part.shape, part.at(0.0, from), 0.3 * part.edge_u, 0.2 * part.edge_v});
            }
        many.material.resize(many.surfaces.size(), 0);
        many.group.resize(many.surfaces.size(), 0);
        many.line.resize(many.surfaces.size(), 0);
        CHECK(cut_at_partitions(few, c.two_sided).surfaces >= 3);
        cut_at_partitions(many, c.two_sided);
        SurfaceList found;
        for (std::size_t s = 0; s < many.surfaces.size(); ++s)
            if (many.line[s] != 0)
                found.push_back(many.surfaces[s]);
        REQUIRE(found.size() == few.surfaces.size());
        const double rounding = 1e-5 * bounds_of(few.surfaces).diagonal();
        for (const Surface& piece : few.surfaces)
            CHECK(std::any_of(found.begin(), found.end(), [&](const Surface& other) {
                return length(piece.centre() - other.centre()) < rounding &&
                       std::abs(piece.area() - other.area()) < 10.0 * rounding;
            }));
    }
}

// Line reuse fills in pairs of patches that no line has joined, a few of them behind the partition: 1e-3 is left for
// it. In a closed room of one reflectance rho every reflection returns the share rho of the power, so the reflected
// power is P rho / (1 - rho), whatever the partition does.
TEST_CASE("the lit side of a partition keeps all the power")
{
    for (const Case& c : cases()) {
        if (c.name.find("through") == 0) // line reuse gives its ends outside of the room some light, which escapes
            continue;
        CAPTURE(c.name);
        SceneFile file = file_of(c);
        cut_at_partitions(file, c.two_sided);
        const Scene scene(file, 0.5, c.two_sided);
        const double power = scene.lamp_power().g;
        const Power found = reflected(c, scene, Method::reuse);
        CHECK(found.lit == doctest::Approx(power * reflectance / (1.0 - reflectance)).epsilon(1e-3));
    }
}

// The pieces must show the same part of the texture as before: at any point of a piece, its frame gives the place that
// the frame of the uncut surface gives.
TEST_CASE("pieces keep their material, names, line and texture")
{
    for (const Case& c : cases()) {
        CAPTURE(c.name);
        SceneFile file = file_of(c);
        for (std::uint32_t s = 0; s < file.surfaces.size(); ++s) {
            file.texture_frames.push_back({{0.1, 0.2}, {2.0 + s, 0.5}, {-0.25, 3.0}, true});
            file.group[s] = s % 3;
        }
        const SceneFile before = file;
        cut_at_partitions(file, c.two_sided);
        for (const std::size_t size :
             {file.material.size(), file.group.size(), file.line.size(), file.texture_frames.size()})
            REQUIRE(size == file.surfaces.size());
        CHECK(std::is_sorted(file.line.begin(), file.line.end()));
        for (std::size_t k = 0; k < file.surfaces.size(); ++k) {
            const std::size_t s = file.line[k] - 1;
            const Surface& piece = file.surfaces[k];
            const Surface& whole = before.surfaces[s];
            CHECK(file.material[k] == before.material[s]);
            CHECK(file.group[k] == before.group[s]);
            CHECK(length(piece.normal() - whole.normal()) < 1e-9);
            // (u, v) of the piece's centre on the whole surface, by Cramer's rule
            const Vec3 way = piece.centre() - whole.origin;
            const Vec3 n = cross(whole.edge_u, whole.edge_v);
            const double u = dot(cross(way, whole.edge_v), n) / dot(n, n);
            const double v = dot(cross(whole.edge_u, way), n) / dot(n, n);
            const double third = piece.shape == Shape::triangle ? 1.0 / 3.0 : 0.5;
            const TexturePoint here = file.texture_frames[k].at(third, third);
            const TexturePoint there = before.texture_frames[s].at(u, v);
            CHECK(here.s == doctest::Approx(there.s).epsilon(1e-8));
            CHECK(here.t == doctest::Approx(there.t).epsilon(1e-8));
        }
    }
}

namespace {

bool is_cut(const std::function<void(SceneBuilder&, std::uint32_t)>& furnish)
{
    const Case c = {"", furnish, {}};
    SceneFile file = file_of(c);
    return cut_at_partitions(file, false).surfaces > 0;
}

} // namespace

TEST_CASE("what stands on the floor and lets light pass round it does not cut it")
{
    CHECK(!is_cut([](SceneBuilder&, std::uint32_t) {}));
    CHECK(!is_cut([](SceneBuilder& b, std::uint32_t wall) { b.box({2, 0, 1}, {3, 1, 2}, wall); }));      // a cube
    CHECK(!is_cut([](SceneBuilder& b, std::uint32_t wall) { b.box({2, 0, 1}, {2.1, 1, 1.1}, wall); }));  // a leg
    CHECK(!is_cut([](SceneBuilder& b, std::uint32_t wall) { b.box({0, 0, 0}, {0.01, 0.1, 4}, wall); })); // skirting
    CHECK(!is_cut([](SceneBuilder& b, std::uint32_t wall) { b.box({2, 0, 1}, {5, 0.005, 3}, wall); }));  // a carpet
    CHECK(!is_cut([](SceneBuilder& b, std::uint32_t wall) { b.rectangle({2, 0, 1}, {0, 0, 1}, {1, 0, 0}, wall); }));
    CHECK(is_cut([](SceneBuilder& b, std::uint32_t wall) { b.box({2, 0, 1}, {2.1, 2, 3}, wall); })); // a screen
}

TEST_CASE("the four sides of a room that a sheet divides are cut in two")
{
    for (const double x : {1.0, 1.25}) {
        SceneBuilder builder;
        const std::uint32_t wall = builder.grey(reflectance, 0.0);
        builder.room({0, 0, 0}, {2, 2, 2}, wall);
        sheets(builder, {x, 0, 0}, {0, 2, 0}, {0, 0, 2}, wall);
        SceneFile file = builder.file();
        const PartitionCuts cuts = cut_at_partitions(file, false);
        CHECK(cuts.surfaces == 4);
        CHECK(cuts.pieces == 8);
        CHECK(cuts.complete);
    }
}

// Whatever part of the floor a closet takes, in a corner or in the middle, no patch reaches from it into the room.
TEST_CASE("below the walls of a sealed closet floor and ceiling are cut, however small it is in the room")
{
    constexpr double thick = 0.1;
    constexpr double closet = 3.0;
    for (const double size : {6.0, 12.0, 20.0})
        for (const double from : {0.0, 0.5 * (size - closet)}) {
            CAPTURE(size);
            CAPTURE(from);
            const double to = from + closet;
            SceneBuilder builder;
            const std::uint32_t wall = builder.grey(reflectance, 1.0);
            builder.room({0, 0, 0}, {size, 2.5, size}, wall);
            builder.box({from, 0, to - thick}, {to, 2.5, to}, wall);
            builder.box({to - thick, 0, from}, {to, 2.5, to - thick}, wall);
            if (from > 0.0) {
                builder.box({from, 0, from}, {to - thick, 2.5, from + thick}, wall);
                builder.box({from, 0, from + thick}, {from + thick, 2.5, to - thick}, wall);
            }
            SceneFile file = builder.file();
            cut_at_partitions(file, false);
            const Scene scene(file, 2.0);
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                bool inside = false;
                bool outside = false;
                for (const Vec3 corner : corners_of(scene.patch(i).shape)) {
                    const double depth = std::min({from > 0.0 ? corner.x - from : closet, to - corner.x,
                                                   from > 0.0 ? corner.z - from : closet, to - corner.z});
                    inside = inside || depth > thick + 1e-6;
                    outside = outside || depth < -1e-6;
                }
                CHECK_FALSE((inside && outside));
            }
        }
}

// A cap bounds the number of pieces, and that it left some is told.
TEST_CASE("very many partitions do not multiply the surfaces without end")
{
    SceneFile file =
        file_of({"",
                 [](SceneBuilder& b, std::uint32_t wall) {
                     for (int i = 0; i < 400; ++i) {
                         const double x = 0.3 + 0.013 * i, z = 0.3 + 0.013 * ((i * 89) % 240);
                         const double angle = 0.37 * i;
                         sheets(b, {x, 0, z}, {0, 2, 0}, {6 * std::cos(angle), 0, 6 * std::sin(angle)}, wall);
                     }
                 },
                 {}});
    const std::size_t before = file.surfaces.size();
    const double area = area_of(file);
    CHECK(!cut_at_partitions(file, false).complete);
    CHECK(file.surfaces.size() <= before + before / 8 + 1024);
    CHECK(area_of(file) == doctest::Approx(area).epsilon(1e-9));
}

// Two ways to model one flat: a floor that runs on below the wall, and two rooms. `local` on the second is the
// reference.
TEST_CASE("a cut floor is lit like two floors" * doctest::test_suite("statistics"))
{
    const Case c = cases().front();
    SceneFile file = file_of(c);
    cut_at_partitions(file, false);
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(reflectance, 0.0);
    const std::uint32_t lamp = builder.grey(reflectance, 1.0);
    builder.room({0, 0, 0}, {3.1, 3, 4}, {wall, wall, lamp, wall, wall, wall});
    builder.room({3.1, 0, 0}, room_size, wall);
    const auto floor_near_wall = [&](const Scene& scene, Method method) {
        return over_seeds(scene, random_lines(method, 200000, 1), 24, [&](const Solution& solution) {
            double sum = 0.0, area = 0.0;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                const Surface shape = scene.patch(i).shape;
                const Vec3 p = shape.centre();
                if (p.y < 1e-6 && shape.normal().y > 0.5 && p.x < 3.1 && p.x > 2.0) {
                    sum += scene.area(i) * solution.radiosity[i].g;
                    area += scene.area(i);
                }
            }
            return sum / area;
        });
    };
    const auto ours = floor_near_wall(Scene(file, 0.31), Method::reuse);
    const auto reference = floor_near_wall(builder.scene(0.31), Method::local);
    CHECK(std::abs(ours.mean - reference.mean) <= 4.0 * std::hypot(ours.standard_error, reference.standard_error));
}

} // namespace partitions_test

#pragma once

#include "base/text_format.h"
#include "scene/obj/obj_reader.h"
#include "scene/scratch_folder.h"
#include "test_scenes.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <sstream>
#include <string>
#include <vector>

namespace multipath {

/// A wall beside two walls, all cut into pieces of up to 1: 4 patches on the one side of the corner, 2 + 3 on the
/// other; and a triangle on top that is cut by its longest edge. A lamp far away.
inline SceneBuilder walls_that_do_not_match()
{
    SceneBuilder builder;
    const std::uint32_t paint = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, paint);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1.5, 0, 0}, paint);
    builder.rectangle({1.5, 0, 0}, {0, 0, 1}, {2.5, 0, 0}, builder.material({0.8, 0.1, 0.2}, {}));
    builder.triangle({0, 3, 0}, {4, 3, 0}, {2, 3, 5}, paint);
    builder.triangle({4, 3, 0}, {6, 3, 1}, {3.1, 3, 2.25}, paint);
    return builder.rectangle({0, 50, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 1.0));
}

/// A scene that is made larger and then moved.
struct Placement
{
    double scale = 1.0;
    Vec3 shift;

    SceneFile moved(SceneFile file) const
    {
        for (Surface& surface : file.surfaces)
            surface = {surface.shape, scale * surface.origin + shift, scale * surface.edge_u, scale * surface.edge_v};
        return file;
    }
    Vec3 back(Vec3 p) const { return (1.0 / scale) * (p - shift); }
};

/// In the coordinates of maps, in all directions, and very small and large ones.
inline std::vector<Placement> far_and_other_sizes()
{
    return {{1.0, {500000, 120, 4649776}},
            {1.0, {-9e6, 8.0123e6, -1e7}},
            {1.0, {0, 0, 1e9}},
            {1.0, {160, -170, 40}},
            {1e-4, {}},
            {1e-4, {-3.3, 2, 1e3}},
            {1e7, {3e7, 0, -1e7}},
            {1e5, {1e8, -1e8, 3e7}}};
}

/// How far points are from those of the unmoved scene [share of its size], which are given in the same order.
inline double largest_miss(const std::vector<Vec3>& moved, const Placement& placement,
                           const std::vector<Vec3>& expected, const Scene& unmoved)
{
    REQUIRE(moved.size() == expected.size());
    double largest = 0.0;
    for (std::size_t n = 0; n < moved.size(); ++n)
        largest = std::max(largest, length(placement.back(moved[n]) - expected[n]));
    return largest / unmoved.own_bounds().diagonal();
}

/// A face of an OBJ with texture coordinates. Corners run counter-clockwise.
struct TexturedFace
{
    std::vector<Vec3> corners;
    std::vector<TexturePoint> places; ///< of the corners

    /// The texture coordinates of a point in its plane, from the areas of the triangles that the point forms with the
    /// first three corners.
    TexturePoint at(Vec3 p) const
    {
        const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
        const auto weight = [&](std::size_t a, std::size_t b) {
            return dot(cross(corners[a] - p, corners[b] - p), normal) / dot(normal, normal);
        };
        const double w0 = weight(1, 2);
        const double w1 = weight(2, 0);
        const double w2 = weight(0, 1);
        return {w0 * places[0].s + w1 * places[1].s + w2 * places[2].s,
                w0 * places[0].t + w1 * places[1].t + w2 * places[2].t};
    }
};

/// Triangles and parallelograms, upright, slanted, sheared and turned, with texture coordinates that are turned,
/// sheared, mirrored or repeated; then all of them with axes exchanged, mirrored, and moved.
inline std::vector<TexturedFace> textured_faces()
{
    const std::vector<TexturedFace> plain = {
        {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
        {{{0, 0, 0}, {2, 0.5, 0.3}, {2.7, 1.5, 1.4}, {0.7, 1, 1.1}}, {{0.1, 0.9}, {0.3, 0.2}, {2.3, 0.4}, {2.1, 1.1}}},
        {{{0.3, 0, 1}, {1.1, 2, 0.2}, {-0.4, 1.3, 0.7}}, {{0, 0}, {3, 0.5}, {-0.25, 1.75}}},
        {{{1, 1, 1}, {1.2, 1, 2.9}, {4, 1.1, 3}}, {{1, 0}, {0.2, 0.1}, {0.7, 0.9}}},
        {{{0, 2, 0}, {0.1, 2, 1}, {3.1, 2.4, 1.2}, {3, 2.4, 0.2}}, {{5, 5}, {5, 4}, {7, 4}, {7, 5}}}};
    std::vector<TexturedFace> faces;
    for (const int kind : {0, 1, 2, 3, 4, 5})
        for (TexturedFace face : plain) {
            for (Vec3& p : face.corners)
                p = kind == 1   ? Vec3{p.y, p.z, p.x}
                    : kind == 2 ? Vec3{p.y, p.x, p.z} // turns the face over, as its corners stay in order
                    : kind == 3 ? Vec3{-p.x, p.y, p.z}
                    : kind == 4 ? p + Vec3{500000, 120, 4649776}
                                : p;
            for (TexturePoint& place : face.places)
                if (kind == 5) // as where coordinates of maps are taken for those of the texture
                    place = {place.s + 500000, place.t - 649776};
            faces.push_back(face);
        }
    return faces;
}

/// A scene of one such face, as the reader of OBJ files gives it, with a lamp beside it.
inline SceneFile scene_of(const TexturedFace& face)
{
    const ScratchFolder folder;
    folder.write("map.ppm", "P3 2 1 255\n255 255 255 90 60 30\n");
    folder.write("room.mtl", "newmtl paper\nKd 1 1 1\nmap_Kd map.ppm\nnewmtl lamp\nKe 1 1 1\n");
    std::string text = "mtllib room.mtl\n";
    std::string corners = "usemtl paper\nf";
    for (std::size_t k = 0; k < face.corners.size(); ++k) {
        const Vec3 p = face.corners[k];
        text += format("v %.17g %.17g %.17g\nvt %.17g %.17g\n", p.x, p.y, p.z, face.places[k].s, face.places[k].t);
        corners += format(" %zu/%zu", k + 1, k + 1);
    }
    for (const Vec3 corner : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}) {
        const Vec3 p = face.corners[0] + corner + Vec3{0, 0, 5};
        text += format("v %.17g %.17g %.17g\n", p.x, p.y, p.z);
    }
    return read_obj(folder.write("room.obj", text + corners + "\nusemtl lamp\nf -3 -2 -1\n"));
}

/// The positions in an OBJ.
inline std::vector<Vec3> obj_positions(const std::string& text)
{
    std::vector<Vec3> points;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (std::istringstream words(line.compare(0, 2, "v ") == 0 ? line.substr(2) : ""); !words.str().empty()) {
            Vec3 p;
            words >> p.x >> p.y >> p.z;
            points.push_back(p);
        }
    return points;
}

/// Different values on all patches.
inline std::vector<Rgb> some_values(const Scene& scene)
{
    std::vector<Rgb> values;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        values.push_back({0.25 + 0.01 * (i * i % 37), 0.5 + 0.02 * (i * 7 % 11), 0.125 * (1 + i % 5)});
    return values;
}

} // namespace multipath

#include "export/lightmap/lightmap_glb.h"

#include "export/lightmap/square_corners.h"
#include "export/mesh/gltf_file.h"

#include <array>
#include <cstddef>

namespace multipath {

namespace {

/// Corner k of a side in coordinates (u, v) of its surface, counter-clockwise seen from the side.
std::array<double, 2> corner_of(const Scene& scene, const MeshSide& side, std::size_t k)
{
    const SquareCorners& corners = square_corners(scene.surfaces()[side.surface].shape);
    return corners.uv[side.front ? k : corners.count - 1 - k];
}

/// The undivided surfaces as a mesh without light, with one face per side.
PatchMesh undivided_mesh(const Scene& scene)
{
    PatchMesh mesh;
    mesh.origin = mesh_origin(scene);
    const auto add = [&](std::uint32_t s, bool front) {
        const Surface& surface = scene.surfaces()[s];
        MeshFace face;
        face.corner_count = static_cast<std::uint32_t>(square_corners(surface.shape).count);
        const MeshSide side = {s,
                               front,
                               front ? surface.normal() : -surface.normal(),
                               mesh.positions.size(),
                               face.corner_count,
                               mesh.faces.size(),
                               1};
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const auto [u, v] = corner_of(scene, side, k);
            face.corners[k] = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.push_back(single(surface.at(u, v) - mesh.origin));
        }
        mesh.faces.push_back(face);
        mesh.sides.push_back(side);
    };
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s) {
        add(s, true);
        if (scene.two_sided())
            add(s, false);
    }
    return mesh;
}

} // namespace

std::string lightmap_glb(const Scene& scene, const Lightmap& map, const std::string& atlas_png, double scale,
                         const std::vector<GlbCamera>& cameras, const std::vector<std::string>& comments, Vec3 up)
{
    const PatchMesh mesh = undivided_mesh(scene);
    const auto in_atlas = [&](const MeshSide& side, std::size_t vertex) {
        const auto [u, v] = corner_of(scene, side, vertex - side.first_vertex);
        return gltf_texture_coordinates(map.frame(side.surface, side.front).at(u, v));
    };
    const auto in_own_texture = [&](const MeshSide& side, std::size_t vertex) {
        const auto [u, v] = corner_of(scene, side, vertex - side.first_vertex);
        return gltf_texture_coordinates(mesh_texture_frame(scene, side.surface).at(u, v));
    };
    return gltf_bytes(mesh, scene,
                      {material_parts(mesh, scene, [&](std::uint32_t surface) { return scene.is_textured(surface); }),
                       {{"TEXCOORD_0", 2, false, in_atlas}, {"TEXCOORD_1", 2, true, in_own_texture}},
                       {{"lightmap", {"image/png", atlas_png}, false, false}},
                       [](const MaterialPart&) { return 0; },
                       cameras,
                       comments,
                       scale,
                       up,
                       "fewer surfaces"});
}

} // namespace multipath

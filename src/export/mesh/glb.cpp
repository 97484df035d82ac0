#include "export/mesh/glb.h"

#include "export/mesh/gltf_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace multipath {

namespace {

/// Texture coordinates of a point of a surface.
Float3 texture_coordinates(const Scene& scene, std::uint32_t surface, Vec3 point)
{
    const Surface& s = scene.surfaces()[surface];
    const Vec3 p = point - s.origin;
    const Vec3 normal = cross(s.edge_u, s.edge_v);
    const double u = dot(cross(p, s.edge_v), normal) / dot(normal, normal);
    const double v = dot(cross(s.edge_u, p), normal) / dot(normal, normal);
    return gltf_texture_coordinates(mesh_texture_frame(scene, surface).at(u, v));
}

/// Factor from the radiosity of a textured surface without its detail to that with a white texture.
Rgb white_factor(const Material& material)
{
    return by_channel([](double white, double mean) { return mean > 0.0 ? white / mean : 0.0; }, material.texture_scale,
                      material.reflectance);
}

std::vector<GltfAttribute> attributes_of(const PatchMesh& mesh, const Scene& scene, double scale)
{
    const auto shown = [&mesh, &scene, scale](const MeshSide& side, std::size_t vertex) {
        Rgb light = scale * to_rgb(mesh.radiosity[vertex]);
        if (scene.shows_texture(side.surface))
            light = white_factor(scene.surface_material(side.surface)) * light;
        return single(by_channel([](double x) { return std::min(x, 1.0); }, light));
    };
    const auto place = [&mesh, &scene](const MeshSide& side, std::size_t n) {
        return texture_coordinates(scene, side.surface, mesh.origin + to_vec3(mesh.positions[n]));
    };
    std::vector<GltfAttribute> attributes = {
        {"COLOR_0", 3, false, shown},
        {"_RADIOSITY", 3, false, [&mesh](const MeshSide&, std::size_t n) { return mesh.radiosity[n]; }},
        {"TEXCOORD_0", 2, true, place}};
    if (!mesh.error.empty())
        attributes.push_back({"_ERROR", 3, false, [&mesh](const MeshSide&, std::size_t n) { return mesh.error[n]; }});
    return attributes;
}

} // namespace

std::string glb_bytes(const PatchMesh& mesh, const Scene& scene, double scale, const std::vector<GlbCamera>& cameras,
                      const std::vector<std::string>& comments, const std::vector<ImageFile>& images, Vec3 up)
{
    std::vector<GltfTexture> textures;
    for (std::size_t k = 0; k < images.size(); ++k)
        textures.push_back({scene.file().textures[k]->name(), images[k], scene.file().textures[k]->repeats()});
    const auto shown_texture = [&](const MaterialPart& part) {
        return part.textured ? std::optional<std::size_t>(scene.materials()[part.material].texture) : std::nullopt;
    };
    return gltf_bytes(mesh, scene,
                      {material_parts(mesh, scene, [&](std::uint32_t surface) { return scene.shows_texture(surface); }),
                       attributes_of(mesh, scene, scale), textures, shown_texture, cameras, comments, scale, up,
                       "a PLY or OBJ, or larger patches"});
}

} // namespace multipath

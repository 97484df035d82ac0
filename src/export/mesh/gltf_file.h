#pragma once

#include "export/mesh/gltf_nodes.h"
#include "export/mesh/patch_mesh.h"
#include "scene/texture/texture.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// The sides of a mesh that have one material and become one mesh of the file.
struct MaterialPart
{
    std::uint32_t material = 0;
    bool textured = false; ///< has texture coordinates of the material's own texture
    std::vector<MeshSide> sides;
    std::size_t vertex_count = 0;
    std::size_t triangle_count = 0; ///< a quadrilateral counts as two
};

/// The parts of all materials that are seen, in the order of the scene's materials; first those for which
/// `is_textured(surface)` is false.
std::vector<MaterialPart> material_parts(const PatchMesh& mesh, const Scene& scene,
                                         const std::function<bool(std::uint32_t surface)>& is_textured);

/// An attribute of vertices besides their position.
struct GltfAttribute
{
    std::string name;
    std::size_t size = 3;       ///< floats per vertex, the first of value(): 2 or 3
    bool only_textured = false; ///< only textured parts have it
    std::function<Float3(const MeshSide& side, std::size_t vertex)> value;
};

/// Texture coordinates in glTF, which measures from the top.
Float3 gltf_texture_coordinates(TexturePoint place);

struct GltfTexture
{
    std::string name;
    ImageFile image;
    bool repeats = false;
    bool with_mipmaps = true; ///< may be shown by smaller copies, which blend what is side by side
};

/// What a glTF file contains.
struct GltfContent
{
    std::vector<MaterialPart> parts;
    std::vector<GltfAttribute> attributes;
    std::vector<GltfTexture> textures;
    std::function<std::optional<std::size_t>(const MaterialPart&)> shown_texture; ///< index of the texture of a part
    std::vector<GlbCamera> cameras;
    std::vector<std::string> comments;
    double scale = 1.0;  ///< [m^2/W] from radiosity to colour
    Vec3 up;             ///< upward direction of the scene
    std::string instead; ///< what the message expects instead of a file of 4 GB
};

/// Bytes of a binary glTF 2.0 file with the cameras and one unlit mesh per part. Throws InputError for 4 GB or more,
/// the limit of the format.
std::string gltf_bytes(const PatchMesh& mesh, const Scene& scene, const GltfContent& content);

} // namespace multipath

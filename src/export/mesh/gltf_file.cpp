// A GLB file consists of a header, a chunk of JSON that describes the binary data, and a chunk with the binary data
// (glTF 2.0 specification, chapter 4). The binary data are one block per vertex attribute and one block of triangles,
// each sorted by part, and then the images.

#include "export/mesh/gltf_file.h"

#include "base/errors.h"
#include "base/little_endian.h"
#include "export/json.h"
#include "geometry/bounds.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace multipath {

std::vector<MaterialPart> material_parts(const PatchMesh& mesh, const Scene& scene,
                                         const std::function<bool(std::uint32_t surface)>& is_textured)
{
    std::vector<MaterialPart> parts(2 * scene.materials().size());
    for (const MeshSide& side : mesh.sides) {
        const std::uint32_t material = scene.file().material[side.surface];
        const bool textured = is_textured(side.surface);
        MaterialPart& part = parts[2 * material + (textured ? 1 : 0)];
        part.material = material;
        part.textured = textured;
        part.sides.push_back(side);
        part.vertex_count += side.vertex_count;
        for (std::size_t n = side.first_face; n < side.first_face + side.face_count; ++n)
            part.triangle_count += mesh.faces[n].corner_count - 2;
    }
    const auto unseen = [](const MaterialPart& part) { return part.triangle_count == 0; }; // glTF has no empty lists
    parts.erase(std::remove_if(parts.begin(), parts.end(), unseen), parts.end());
    return parts;
}

Float3 gltf_texture_coordinates(TexturePoint place)
{
    return {static_cast<float>(place.s), static_cast<float>(1.0 - place.t), 0.0f};
}

namespace {

// Constants of glTF.
constexpr std::uint64_t gltf_float = 5126;
constexpr std::uint64_t gltf_unsigned = 5125;
constexpr std::uint64_t gltf_vertices = 34962;
constexpr std::uint64_t gltf_triangles = 34963;
constexpr std::uint64_t gltf_linear = 9729; ///< filter without mipmaps
constexpr std::uint64_t gltf_clamp = 33071;
constexpr std::uint64_t gltf_repeat = 10497;

/// The binary chunk: buffer views one after the other, each padded to a multiple of four bytes.
struct GltfChunk
{
    std::string bytes;
    std::vector<JsonObject> views;

    /// Appends what write(bytes) appends as a buffer view, whose description may be extended.
    template <class Write>
    JsonObject& add(const Write& write)
    {
        const std::size_t begin = bytes.size();
        write(bytes);
        const std::size_t length = bytes.size() - begin;
        bytes.append((4 - length % 4) % 4, '\0');
        views.push_back(JsonObject().count("buffer", 0).count("byteOffset", begin).count("byteLength", length));
        return views.back();
    }
};

/// Appends the faces of a part, a quadrilateral as two triangles. Vertices are numbered in the part.
void append_triangles(std::string& bytes, const PatchMesh& mesh, const MaterialPart& part)
{
    std::size_t vertices_before = 0;
    for (const MeshSide& side : part.sides) {
        const auto shift = static_cast<std::uint32_t>(vertices_before - side.first_vertex); // modulo 2^32
        for (std::size_t n = side.first_face; n < side.first_face + side.face_count; ++n)
            for (std::uint32_t k = 1; k + 1 < mesh.faces[n].corner_count; ++k)
                for (const std::uint32_t corner : {0u, k, k + 1})
                    append_little_endian(bytes, mesh.faces[n].corners[corner] + shift);
        vertices_before += side.vertex_count;
    }
}

/// Calls visit(side, vertex) for the vertices of a part, in order.
template <class Visit>
void for_each_vertex(const MaterialPart& part, const Visit& visit)
{
    for (const MeshSide& side : part.sides)
        for (std::size_t n = side.first_vertex; n < side.first_vertex + side.vertex_count; ++n)
            visit(side, n);
}

bool has(const MaterialPart& part, const GltfAttribute& attribute)
{
    return part.textured || !attribute.only_textured;
}

/// The positions and the attributes that any part has.
std::vector<GltfAttribute> used_attributes(const PatchMesh& mesh, const GltfContent& content)
{
    std::vector<GltfAttribute> used = {
        {"POSITION", 3, false, [&mesh](const MeshSide&, std::size_t n) { return mesh.positions[n]; }}};
    for (const GltfAttribute& attribute : content.attributes)
        if (std::any_of(content.parts.begin(), content.parts.end(),
                        [&](const MaterialPart& part) { return has(part, attribute); }))
            used.push_back(attribute);
    return used;
}

/// Appends the blocks of attributes and triangles. View n is that of attribute n, and the next that of the triangles.
void add_numbers(GltfChunk& chunk, const PatchMesh& mesh, const std::vector<MaterialPart>& parts,
                 const std::vector<GltfAttribute>& attributes)
{
    for (const GltfAttribute& attribute : attributes) {
        const auto write = [&](std::string& bytes) {
            for (const MaterialPart& part : parts)
                if (has(part, attribute))
                    for_each_vertex(part, [&](const MeshSide& side, std::size_t vertex) {
                        const Float3 value = attribute.value(side, vertex);
                        for (std::size_t k = 0; k < attribute.size; ++k)
                            append_little_endian(bytes, value[k]);
                    });
        };
        chunk.add(write).count("target", gltf_vertices).count("byteStride", 4 * attribute.size);
    }
    const auto write = [&](std::string& bytes) {
        for (const MaterialPart& part : parts)
            append_triangles(bytes, mesh, part);
    };
    chunk.add(write).count("target", gltf_triangles);
}

/// Adds the range of the positions of a part, which the format requires.
void add_range(JsonObject& json, const PatchMesh& mesh, const MaterialPart& part)
{
    Bounds box;
    for_each_vertex(part, [&](const MeshSide&, std::size_t vertex) { box.include(to_vec3(mesh.positions[vertex])); });
    json.numbers("min", box.low).numbers("max", box.high);
}

/// The accessors of each part, for its attributes and then its triangles, and the meshes, which refer to them.
struct GltfMeshes
{
    GltfMeshes(const PatchMesh& mesh, const Scene& scene, const std::vector<MaterialPart>& parts,
               const std::vector<GltfAttribute>& attributes)
        : bytes_before_(attributes.size() + 1)
    {
        for (const MaterialPart& part : parts) {
            JsonObject numbers;
            for (std::size_t n = 0; n < attributes.size(); ++n)
                if (has(part, attributes[n])) {
                    numbers.count(attributes[n].name,
                                  add_accessor(n, gltf_float, part.vertex_count, attributes[n].size));
                    if (n == 0)
                        add_range(accessors.back(), mesh, part);
                }
            const JsonObject primitive =
                JsonObject()
                    .object("attributes", numbers)
                    .count("indices", add_accessor(attributes.size(), gltf_unsigned, 3 * part.triangle_count, 1))
                    .count("material", meshes.size());
            meshes.push_back(
                JsonObject().text("name", scene.materials()[part.material].name).objects("primitives", {primitive}));
        }
    }

    std::vector<JsonObject> accessors;
    std::vector<JsonObject> meshes;

private:
    /// `size`: numbers of four bytes per element.
    std::size_t add_accessor(std::size_t view, std::uint64_t component, std::size_t count, std::size_t size)
    {
        accessors.push_back(JsonObject()
                                .count("bufferView", view)
                                .count("byteOffset", bytes_before_[view])
                                .count("componentType", component)
                                .count("count", count)
                                .text("type", size == 1   ? "SCALAR"
                                              : size == 2 ? "VEC2"
                                                          : "VEC3"));
        bytes_before_[view] += 4 * size * count;
        return accessors.size() - 1;
    }

    std::vector<std::size_t> bytes_before_; ///< per view: of the parts before
};

/// An unlit material. Programs that do not support this extension show a matt surface instead. `texture`: index of the
/// texture that it shows, if any.
JsonObject unlit_material(const Material& material, std::optional<std::size_t> texture)
{
    JsonObject surface = JsonObject().count("metallicFactor", 0).number("roughnessFactor", 1.0);
    if (texture)
        surface.object("baseColorTexture", JsonObject().count("index", *texture));
    return JsonObject()
        .text("name", material.name)
        .object("pbrMetallicRoughness", surface)
        .boolean("doubleSided", false)
        .object("extensions", JsonObject().object("KHR_materials_unlit", {}))
        .object("extras",
                JsonObject().numbers("reflectance", material.reflectance).numbers("emittance", material.emittance));
}

/// Adds images, samplers and textures; those of one texture have the same index. Image k has view first_view + k.
void add_textures(JsonObject& description, const std::vector<GltfTexture>& textures, std::size_t first_view)
{
    std::vector<JsonObject> images;
    std::vector<JsonObject> samplers;
    std::vector<JsonObject> pairs;
    for (std::size_t k = 0; k < textures.size(); ++k) {
        const std::uint64_t wrap = textures[k].repeats ? gltf_repeat : gltf_clamp;
        images.push_back(JsonObject()
                             .text("name", textures[k].name)
                             .text("mimeType", textures[k].image.type)
                             .count("bufferView", first_view + k));
        samplers.push_back(JsonObject().count("wrapS", wrap).count("wrapT", wrap));
        if (!textures[k].with_mipmaps)
            samplers.back().count("magFilter", gltf_linear).count("minFilter", gltf_linear);
        pairs.push_back(JsonObject().count("source", k).count("sampler", k));
    }
    description.objects("images", images).objects("samplers", samplers).objects("textures", pairs);
}

/// The JSON of the file, without images.
JsonObject description_of(const Scene& scene, const GltfContent& content, const GltfMeshes& meshes,
                          const GltfChunk& chunk)
{
    std::vector<JsonObject> materials;
    std::vector<std::string> names;
    for (const MaterialPart& part : content.parts) {
        materials.push_back(unlit_material(scene.materials()[part.material], content.shown_texture(part)));
        names.push_back(scene.materials()[part.material].name);
    }
    const GlbNodes nodes = glb_nodes(scene, names, content.cameras, content.up);
    JsonObject description;
    description
        .object(
            "asset",
            JsonObject()
                .text("version", "2.0")
                .text("generator", "multipath")
                .object("extras", JsonObject().texts("record", content.comments).number("color_scale", content.scale)))
        .texts("extensionsUsed", {"KHR_materials_unlit"})
        .count("scene", 0)
        .objects("scenes", {JsonObject().numbers("nodes", nodes.roots)})
        .objects("nodes", nodes.nodes)
        .objects("meshes", meshes.meshes)
        .objects("materials", materials)
        .objects("accessors", meshes.accessors)
        .objects("bufferViews", chunk.views)
        .objects("buffers", {JsonObject().count("byteLength", chunk.bytes.size())});
    if (!content.textures.empty()) // lists must not be empty
        add_textures(description, content.textures, chunk.views.size() - content.textures.size());
    if (!nodes.cameras.empty())
        description.objects("cameras", nodes.cameras);
    return description;
}

} // namespace

std::string gltf_bytes(const PatchMesh& mesh, const Scene& scene, const GltfContent& content)
{
    const std::vector<GltfAttribute> attributes = used_attributes(mesh, content);
    GltfChunk chunk;
    add_numbers(chunk, mesh, content.parts, attributes);
    for (const GltfTexture& texture : content.textures)
        chunk.add([&](std::string& bytes) { bytes += texture.image.bytes; });
    std::string& bytes = chunk.bytes;
    const GltfMeshes meshes(mesh, scene, content.parts, attributes);
    std::string json = description_of(scene, content, meshes, chunk).document();
    json.append((4 - json.size() % 4) % 4, ' ');

    const std::size_t size = 28 + json.size() + bytes.size();
    if (size > std::numeric_limits<std::uint32_t>::max())
        throw InputError(scene.path() + ": too much for a GLB, which holds less than 4 GB; expected " +
                         content.instead);
    std::string head = "glTF";
    for (const std::size_t word : {std::size_t{2}, size, json.size()})
        append_little_endian(head, static_cast<std::uint32_t>(word));
    head.append("JSON").append(json);
    append_little_endian(head, static_cast<std::uint32_t>(bytes.size()));
    bytes.insert(0, head.append("BIN\0", 4));
    return std::move(bytes);
}

} // namespace multipath

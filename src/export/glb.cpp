// The file is a header, a chunk of JSON that describes, and a chunk of numbers (glTF 2.0 specification, chapter 4). The
// numbers are one block per attribute and one for the triangles; in every block, material follows material.

#include "export/glb.h"

#include "export/glb_description.h"
#include "export/material_parts.h"
#include "scene/input_error.h"
#include "scene/little_endian.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

namespace multipath {

namespace {

constexpr std::uint32_t magic = 0x46546c67; // "glTF"
constexpr std::uint32_t version = 2;
constexpr std::uint32_t json_chunk = 0x4e4f534a;
constexpr std::uint32_t number_chunk = 0x004e4942;

/// Three floats per vertex, in the order of the parts.
struct Attribute
{
    std::string name;
    std::function<Float3(std::size_t vertex)> value;
};

std::vector<Attribute> attributes_of(const PatchMesh& mesh, double scale)
{
    const auto shown = [&mesh, scale](std::size_t vertex) {
        const Rgb light = scale * to_rgb(mesh.radiosity[vertex]);
        return single(Rgb{std::min(light.r, 1.0), std::min(light.g, 1.0), std::min(light.b, 1.0)});
    };
    std::vector<Attribute> attributes = {{"POSITION", [&mesh](std::size_t n) { return mesh.positions[n]; }},
                                         {"COLOR_0", shown},
                                         {"_RADIOSITY", [&mesh](std::size_t n) { return mesh.radiosity[n]; }}};
    if (!mesh.error.empty())
        attributes.push_back({"_ERROR", [&mesh](std::size_t n) { return mesh.error[n]; }});
    return attributes;
}

double light_step(const PatchMesh& mesh, std::uint32_t a, std::uint32_t b)
{
    return std::abs(mean(to_rgb(mesh.radiosity[a])) - mean(to_rgb(mesh.radiosity[b])));
}

/// A quadrilateral is cut along the diagonal on which the light changes less, so that a slanting shadow's edge has no
/// teeth. `shift` brings the mesh's vertex numbers to the part's.
void append_triangles(std::string& bytes, const PatchMesh& mesh, const MeshFace& face, std::uint32_t shift)
{
    const auto& c = face.corners;
    const auto append = [&](std::size_t i, std::size_t j, std::size_t k) {
        for (const std::size_t corner : {i, j, k})
            append_little_endian(bytes, c[corner] + shift);
    };
    const bool whole = face.corner_count == 3;
    const bool from_first = whole || light_step(mesh, c[0], c[2]) <= light_step(mesh, c[1], c[3]);
    append(0, 1, from_first ? 2 : 3);
    if (!whole)
        append(from_first ? 0 : 1, 2, 3);
}

/// The chunk of numbers, as GlbBlocks says.
void append_numbers(std::string& bytes, const PatchMesh& mesh, const std::vector<MaterialPart>& parts,
                    const std::vector<Attribute>& attributes)
{
    for (const Attribute& attribute : attributes)
        for (const MaterialPart& part : parts)
            for_each_vertex(part, [&](std::size_t vertex) {
                for (const float x : attribute.value(vertex))
                    append_little_endian(bytes, x);
            });
    for (const MaterialPart& part : parts) {
        std::size_t vertices_before = 0;
        for (const MeshSide& side : part.sides) {
            const auto shift = static_cast<std::uint32_t>(vertices_before - side.first_vertex); // modulo 2^32
            for (std::size_t n = side.first_face; n < side.first_face + side.face_count; ++n)
                append_triangles(bytes, mesh, mesh.faces[n], shift);
            vertices_before += side.vertex_count;
        }
    }
}

} // namespace

std::string glb_bytes(const PatchMesh& mesh, const Scene& scene, double scale, const std::vector<std::string>& comments)
{
    const std::vector<MaterialPart> parts = material_parts(mesh, scene);
    const std::vector<Attribute> attributes = attributes_of(mesh, scale);
    GlbFacts facts{{}, scale, comments};
    for (const Attribute& attribute : attributes)
        facts.attributes.push_back(attribute.name);
    const GlbBlocks blocks(parts, attributes.size());
    std::string json = glb_description(mesh, scene, parts, blocks, facts);
    json.append((4 - json.size() % 4) % 4, ' '); // chunks are multiples of four bytes

    const std::size_t length = 28 + json.size() + blocks.total();
    if (length > std::numeric_limits<std::uint32_t>::max())
        throw InputError(scene.path() + ": too many patches for a GLB, which holds less than 4 GB; expected a PLY or "
                                        "OBJ, or a larger --patch-size");
    const auto size = [](std::size_t bytes) { return static_cast<std::uint32_t>(bytes); };
    std::string bytes;
    bytes.reserve(length);
    for (const std::uint32_t word : {magic, version, size(length), size(json.size()), json_chunk})
        append_little_endian(bytes, word);
    bytes += json;
    for (const std::uint32_t word : {size(blocks.total()), number_chunk})
        append_little_endian(bytes, word);
    append_numbers(bytes, mesh, parts, attributes);
    return bytes;
}

} // namespace multipath

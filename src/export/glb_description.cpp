#include "export/glb_description.h"

#include "export/json.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

namespace multipath {

namespace {

constexpr std::size_t vector_size = 12;   ///< [byte] three floats
constexpr std::size_t triangle_size = 12; ///< [byte] three 32-bit numbers

// Numbers that stand for words in glTF.
constexpr std::uint64_t float_component = 5126;
constexpr std::uint64_t unsigned_component = 5125;
constexpr std::uint64_t array_buffer = 34962;
constexpr std::uint64_t element_array_buffer = 34963;

JsonObject view(std::size_t offset, std::size_t length, std::uint64_t target)
{
    JsonObject json;
    json.count("buffer", 0);
    json.count("byteOffset", offset);
    json.count("byteLength", length);
    json.count("target", target);
    return json;
}

std::vector<JsonObject> views(const GlbBlocks& blocks)
{
    std::vector<JsonObject> list;
    for (std::size_t n = 0; n < blocks.attribute_count; ++n) {
        list.push_back(view(n * blocks.attribute_bytes, blocks.attribute_bytes, array_buffer));
        list.back().count("byteStride", vector_size);
    }
    list.push_back(view(blocks.attribute_count * blocks.attribute_bytes, blocks.triangle_bytes, element_array_buffer));
    return list;
}

JsonObject accessor(std::size_t view, std::size_t offset, std::uint64_t component, std::size_t count, const char* type)
{
    JsonObject json;
    json.count("bufferView", view);
    json.count("byteOffset", offset);
    json.count("componentType", component);
    json.count("count", count);
    json.text("type", type);
    return json;
}

/// The format wants the range of positions, and nothing else's.
void add_range(JsonObject& json, const PatchMesh& mesh, const MaterialPart& part)
{
    std::vector<double> low(3, std::numeric_limits<double>::infinity());
    std::vector<double> high(3, -std::numeric_limits<double>::infinity());
    for_each_vertex(part, [&](std::size_t vertex) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min<double>(low[axis], mesh.positions[vertex][axis]);
            high[axis] = std::max<double>(high[axis], mesh.positions[vertex][axis]);
        }
    });
    json.numbers("min", low);
    json.numbers("max", high);
}

/// Part by part: its attributes, then its triangles.
std::vector<JsonObject> accessors(const PatchMesh& mesh, const std::vector<MaterialPart>& parts,
                                  std::size_t attribute_count)
{
    std::vector<JsonObject> list;
    std::size_t vertices_before = 0;
    std::size_t triangles_before = 0;
    for (const MaterialPart& part : parts) {
        for (std::size_t n = 0; n < attribute_count; ++n)
            list.push_back(accessor(n, vector_size * vertices_before, float_component, part.vertex_count, "VEC3"));
        add_range(list[list.size() - attribute_count], mesh, part);
        list.push_back(accessor(attribute_count, triangle_size * triangles_before, unsigned_component,
                                3 * part.triangle_count, "SCALAR"));
        vertices_before += part.vertex_count;
        triangles_before += part.triangle_count;
    }
    return list;
}

std::vector<JsonObject> meshes(const Scene& scene, const std::vector<MaterialPart>& parts,
                               const std::vector<std::string>& attributes)
{
    std::vector<JsonObject> list;
    std::uint64_t next_accessor = 0;
    for (const MaterialPart& part : parts) {
        JsonObject numbers;
        for (const std::string& attribute : attributes)
            numbers.count(attribute, next_accessor++);
        JsonObject primitive;
        primitive.object("attributes", numbers);
        primitive.count("indices", next_accessor++);
        primitive.count("material", list.size());
        JsonObject mesh;
        mesh.text("name", scene.materials()[part.material].name);
        mesh.objects("primitives", {primitive});
        list.push_back(mesh);
    }
    return list;
}

/// What programs that do not know `unlit` show is dull, not shiny.
JsonObject unlit_material(const Material& material)
{
    JsonObject plain;
    plain.count("metallicFactor", 0);
    plain.number("roughnessFactor", 1.0);
    JsonObject unlit;
    unlit.object("KHR_materials_unlit", {});
    JsonObject physics;
    physics.numbers("reflectance", {material.reflectance.r, material.reflectance.g, material.reflectance.b});
    physics.numbers("emittance", {material.emittance.r, material.emittance.g, material.emittance.b});
    JsonObject json;
    json.text("name", material.name);
    json.object("pbrMetallicRoughness", plain);
    json.boolean("doubleSided", false);
    json.object("extensions", unlit);
    json.object("extras", physics);
    return json;
}

JsonObject asset(const GlbFacts& facts)
{
    JsonObject extras;
    extras.texts("record", facts.comments);
    extras.number("color_scale", facts.scale);
    JsonObject json;
    json.text("version", "2.0");
    json.text("generator", "multipath");
    json.object("extras", extras);
    return json;
}

/// 0, 1, ... below count.
std::vector<double> numbers_below(std::size_t count)
{
    std::vector<double> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0.0);
    return numbers;
}

/// One for each mesh.
std::vector<JsonObject> nodes(const Scene& scene, const std::vector<MaterialPart>& parts)
{
    std::vector<JsonObject> list;
    for (const MaterialPart& part : parts) {
        JsonObject json;
        json.text("name", scene.materials()[part.material].name);
        json.count("mesh", list.size());
        list.push_back(json);
    }
    return list;
}

} // namespace

GlbBlocks::GlbBlocks(const std::vector<MaterialPart>& parts, std::size_t attributes) : attribute_count(attributes)
{
    for (const MaterialPart& part : parts) {
        attribute_bytes += vector_size * part.vertex_count;
        triangle_bytes += triangle_size * part.triangle_count;
    }
}

std::string glb_description(const PatchMesh& mesh, const Scene& scene, const std::vector<MaterialPart>& parts,
                            const GlbBlocks& blocks, const GlbFacts& facts)
{
    std::vector<JsonObject> materials;
    for (const MaterialPart& part : parts)
        materials.push_back(unlit_material(scene.materials()[part.material]));
    JsonObject all_nodes;
    all_nodes.numbers("nodes", numbers_below(parts.size()));
    JsonObject buffer;
    buffer.count("byteLength", blocks.total());

    JsonObject json;
    json.object("asset", asset(facts));
    json.texts("extensionsUsed", {"KHR_materials_unlit"});
    json.count("scene", 0);
    json.objects("scenes", {all_nodes});
    json.objects("nodes", nodes(scene, parts));
    json.objects("meshes", meshes(scene, parts, facts.attributes));
    json.objects("materials", materials);
    json.objects("accessors", accessors(mesh, parts, blocks.attribute_count));
    json.objects("bufferViews", views(blocks));
    json.objects("buffers", {buffer});
    return json.document();
}

} // namespace multipath

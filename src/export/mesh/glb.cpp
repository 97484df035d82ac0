// A GLB file consists of a header, a chunk of JSON that describes the binary data, and a chunk with the binary data
// (glTF 2.0 specification, chapter 4). The binary data are one block per vertex attribute and one block of triangles,
// each sorted by material, and then the images.

#include "export/mesh/glb.h"

#include "base/elementary.h"
#include "base/errors.h"
#include "base/little_endian.h"
#include "export/json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace multipath {

namespace {

/// The numbers 0, 1, ... count - 1.
std::vector<double> numbers_below(std::size_t count)
{
    std::vector<double> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0.0);
    return numbers;
}

/// The matrix of a node, column by column.
std::vector<double> node_matrix(const std::array<Vec3, 3>& axes, Vec3 place)
{
    std::vector<double> matrix;
    for (const Vec3 column : {axes[0], axes[1], axes[2], place})
        matrix.insert(matrix.end(), {column.x, column.y, column.z, 0.0});
    matrix.back() = 1.0;
    return matrix;
}

/// Matrix from camera coordinates, in which the camera looks along -z, to scene coordinates relative to `origin`.
std::vector<double> matrix_of(const GlbCamera& camera, Vec3 origin)
{
    const Vec3 back = normalized(camera.eye - camera.target);
    const Vec3 right = normalized(cross(camera.up, back));
    return node_matrix({right, cross(back, right), back}, camera.eye - origin);
}

/// Where a rotation that turns `up` to y takes the axes x, y and z. Exact if `up` is one of them.
std::array<Vec3, 3> turned_upright(Vec3 up)
{
    Vec3 u = normalized(up);
    const double turn =
        u.y < 0.0 ? -1.0 : 1.0; // half a turn about x first: rotations by almost 180 degrees are inexact
    u = {u.x, turn * u.y, turn * u.z};
    const Vec3 axis = {-u.z, 0.0, u.x}; // u x y; its length is the sine of the angle
    const auto turned = [&](Vec3 p) {   // Rodrigues' formula
        return u.y * p + cross(axis, p) + (dot(axis, p) / (1.0 + u.y)) * axis + Vec3{}; // never -0
    };
    return {turned({1.0, 0.0, 0.0}), turned({0.0, turn, 0.0}), turned({0.0, 0.0, turn})};
}

JsonObject glb_camera(const GlbCamera& camera, const Scene& scene)
{
    constexpr double near = 0.002; // share of the scene's diagonal
    return JsonObject()
        .text("type", "perspective")
        .object("perspective", JsonObject()
                                   .number("yfov", camera.field_of_view * pi / 180.0)
                                   .number("znear", near * scene.bounds().diagonal()));
}

} // namespace

GlbNodes glb_nodes(const Scene& scene, const std::vector<std::string>& mesh_names,
                   const std::vector<GlbCamera>& cameras, Vec3 up)
{
    const Vec3 origin = mesh_origin(scene);
    GlbNodes result;
    for (const std::string& name : mesh_names)
        result.nodes.push_back(JsonObject().text("name", name).count("mesh", result.nodes.size()));
    for (const GlbCamera& camera : cameras) {
        result.nodes.push_back(JsonObject()
                                   .text("name", camera.name)
                                   .count("camera", result.cameras.size())
                                   .numbers("matrix", matrix_of(camera, origin)));
        result.cameras.push_back(glb_camera(camera, scene));
    }
    result.roots = numbers_below(result.nodes.size());
    const std::array<Vec3, 3> axes = turned_upright(up);
    if (origin != Vec3{} || axes[1] != Vec3{0.0, 1.0, 0.0}) {
        const Vec3 place = origin.x * axes[0] + origin.y * axes[1] + origin.z * axes[2];
        result.nodes.push_back(JsonObject()
                                   .text("name", "scene")
                                   .numbers("matrix", node_matrix(axes, place))
                                   .numbers("children", result.roots));
        result.roots = {static_cast<double>(result.nodes.size() - 1)};
    }
    return result;
}

namespace {

/// The sides of a mesh that have one material.
struct MaterialPart
{
    std::uint32_t material = 0;
    bool textured = false; ///< the sides show the material's texture
    std::vector<MeshSide> sides;
    std::size_t vertex_count = 0;
    std::size_t triangle_count = 0; ///< a quadrilateral counts as two
};

/// The parts of all materials that are seen, in the order of the scene's materials. A textured material has a separate
/// part for surfaces without texture coordinates.
std::vector<MaterialPart> material_parts(const PatchMesh& mesh, const Scene& scene)
{
    const std::size_t materials = scene.materials().size();
    std::vector<MaterialPart> parts(2 * materials);
    for (const MeshSide& side : mesh.sides) {
        const std::uint32_t material = scene.file().material[side.surface];
        const bool textured = scene.shows_texture(side.surface);
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

/// Calls visit(index) for the vertices of a part, in order.
template <class Visit>
void for_each_vertex(const MaterialPart& part, const Visit& visit)
{
    for (const MeshSide& side : part.sides)
        for (std::size_t n = side.first_vertex; n < side.first_vertex + side.vertex_count; ++n)
            visit(n);
}

constexpr std::size_t vector_size = 12;   ///< [byte] three floats
constexpr std::size_t triangle_size = 12; ///< [byte] three 32-bit indices

// Constants of glTF.
constexpr std::uint64_t float_component = 5126;
constexpr std::uint64_t unsigned_component = 5125;
constexpr std::uint64_t array_buffer = 34962;
constexpr std::uint64_t element_array_buffer = 34963;

/// Sizes [byte] of the blocks of binary data, which follow each other without gaps: one per attribute, with three
/// floats per vertex, then one with three 32-bit indices per triangle. Each block is sorted by part.
struct GlbBlocks
{
    GlbBlocks(const std::vector<MaterialPart>& parts, std::size_t attributes) : attribute_count(attributes)
    {
        for (const MaterialPart& part : parts) {
            attribute_bytes += vector_size * part.vertex_count;
            triangle_bytes += triangle_size * part.triangle_count;
        }
    }

    std::size_t attribute_count = 0;
    std::size_t attribute_bytes = 0; ///< size of the block of one attribute
    std::size_t triangle_bytes = 0;

    std::size_t total() const { return attribute_count * attribute_bytes + triangle_bytes; }
};

constexpr const char* texture_attribute = "TEXCOORD_0";

/// [byte] Size of an image in the file, where each is padded to a multiple of four bytes.
std::size_t padded_size(const ImageFile& image)
{
    return (image.bytes.size() + 3) / 4 * 4;
}

std::size_t size_of(const std::vector<ImageFile>& images)
{
    std::size_t sum = 0;
    for (const ImageFile& image : images)
        sum += padded_size(image);
    return sum;
}

/// What the JSON of a GLB contains besides the mesh.
struct GlbFacts
{
    std::vector<std::string> attributes; ///< names; the first is POSITION
    std::vector<ImageFile> images;
    double scale = 1.0; ///< [m^2/W] from radiosity to colour
    std::vector<GlbCamera> cameras;
    std::vector<std::string> comments;
    Vec3 up;
};

/// A buffer view, that is a range of bytes in the binary data.
JsonObject view(std::size_t offset, std::size_t length)
{
    return JsonObject().count("buffer", 0).count("byteOffset", offset).count("byteLength", length);
}

JsonObject view(std::size_t offset, std::size_t length, std::uint64_t target)
{
    return view(offset, length).count("target", target);
}

std::vector<JsonObject> views(const GlbBlocks& blocks, const std::vector<ImageFile>& images)
{
    std::vector<JsonObject> list;
    for (std::size_t n = 0; n < blocks.attribute_count; ++n)
        list.push_back(
            view(n * blocks.attribute_bytes, blocks.attribute_bytes, array_buffer).count("byteStride", vector_size));
    list.push_back(view(blocks.attribute_count * blocks.attribute_bytes, blocks.triangle_bytes, element_array_buffer));
    std::size_t offset = blocks.total();
    for (const ImageFile& image : images) {
        list.push_back(view(offset, image.bytes.size()));
        offset += padded_size(image);
    }
    return list;
}

JsonObject accessor(std::size_t view, std::size_t offset, std::uint64_t component, std::size_t count, const char* type)
{
    return JsonObject()
        .count("bufferView", view)
        .count("byteOffset", offset)
        .count("componentType", component)
        .count("count", count)
        .text("type", type);
}

/// Adds the range of the positions of a part, which the format requires.
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
    json.numbers("min", low).numbers("max", high);
}

/// The accessors of each part: its attributes, then its triangles.
std::vector<JsonObject> accessors(const PatchMesh& mesh, const std::vector<MaterialPart>& parts,
                                  const std::vector<std::string>& attributes)
{
    const std::size_t attribute_count = attributes.size();
    std::vector<JsonObject> list;
    std::size_t vertices_before = 0;
    std::size_t triangles_before = 0;
    for (const MaterialPart& part : parts) {
        for (std::size_t n = 0; n < attribute_count; ++n)
            list.push_back(accessor(n, vector_size * vertices_before, float_component, part.vertex_count,
                                    attributes[n] == texture_attribute ? "VEC2" : "VEC3"));
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
        const JsonObject primitive =
            JsonObject().object("attributes", numbers).count("indices", next_accessor++).count("material", list.size());
        list.push_back(
            JsonObject().text("name", scene.materials()[part.material].name).objects("primitives", {primitive}));
    }
    return list;
}

JsonObject surface_of(const Material& material, bool textured)
{
    JsonObject surface = JsonObject().count("metallicFactor", 0).number("roughnessFactor", 1.0);
    if (textured)
        surface.object("baseColorTexture", JsonObject().count("index", material.texture));
    return surface;
}

/// An unlit material. Programs that do not support this extension show a matt surface instead.
JsonObject unlit_material(const Material& material, bool textured)
{
    const auto channels = [](Rgb c) { return std::vector<double>{c.r, c.g, c.b}; };
    return JsonObject()
        .text("name", material.name)
        .object("pbrMetallicRoughness", surface_of(material, textured))
        .boolean("doubleSided", false)
        .object("extensions", JsonObject().object("KHR_materials_unlit", {}))
        .object("extras", JsonObject()
                              .numbers("reflectance", channels(material.reflectance))
                              .numbers("emittance", channels(material.emittance)));
}

JsonObject asset(const GlbFacts& facts)
{
    return JsonObject()
        .text("version", "2.0")
        .text("generator", "multipath")
        .object("extras", JsonObject().texts("record", facts.comments).number("color_scale", facts.scale));
}

/// Adds images, samplers and textures; those of one texture have the same index.
void add_textures(JsonObject& description, const Scene& scene, const std::vector<ImageFile>& images,
                  std::size_t first_view)
{
    constexpr std::uint64_t repeat = 10497;
    constexpr std::uint64_t clamp_to_edge = 33071;
    std::vector<JsonObject> files;
    std::vector<JsonObject> samplers;
    std::vector<JsonObject> textures;
    for (std::size_t k = 0; k < images.size(); ++k) {
        const Texture& texture = *scene.file().textures[k];
        const std::uint64_t wrap = texture.repeats() ? repeat : clamp_to_edge;
        files.push_back(JsonObject()
                            .text("name", texture.name())
                            .text("mimeType", images[k].type)
                            .count("bufferView", first_view + k));
        samplers.push_back(JsonObject().count("wrapS", wrap).count("wrapT", wrap));
        textures.push_back(JsonObject().count("source", k).count("sampler", k));
    }
    description.objects("images", files).objects("samplers", samplers).objects("textures", textures);
}

/// The JSON of a GLB, which describes the blocks of binary data.
std::string glb_description(const PatchMesh& mesh, const Scene& scene, const std::vector<MaterialPart>& parts,
                            const GlbBlocks& blocks, const GlbFacts& facts)
{
    std::vector<JsonObject> materials;
    std::vector<std::string> names;
    for (const MaterialPart& part : parts) {
        materials.push_back(unlit_material(scene.materials()[part.material], part.textured));
        names.push_back(scene.materials()[part.material].name);
    }
    const GlbNodes nodes = glb_nodes(scene, names, facts.cameras, facts.up);
    JsonObject description;
    description.object("asset", asset(facts))
        .texts("extensionsUsed", {"KHR_materials_unlit"})
        .count("scene", 0)
        .objects("scenes", {JsonObject().numbers("nodes", nodes.roots)})
        .objects("nodes", nodes.nodes)
        .objects("meshes", meshes(scene, parts, facts.attributes))
        .objects("materials", materials)
        .objects("accessors", accessors(mesh, parts, facts.attributes))
        .objects("bufferViews", views(blocks, facts.images))
        .objects("buffers", {JsonObject().count("byteLength", blocks.total() + size_of(facts.images))});
    if (!facts.images.empty())
        add_textures(description, scene, facts.images, blocks.attribute_count + 1);
    if (!nodes.cameras.empty()) // lists must not be empty
        description.objects("cameras", nodes.cameras);
    return description.document();
}

constexpr std::uint32_t magic = 0x46546c67; // "glTF"
constexpr std::uint32_t version = 2;
constexpr std::uint32_t json_chunk = 0x4e4f534a;
constexpr std::uint32_t number_chunk = 0x004e4942;

/// A vertex attribute of three floats.
struct Attribute
{
    std::string name;
    std::function<Float3(std::size_t vertex)> value;
};

/// The surface of each vertex.
std::vector<std::uint32_t> surfaces_of_vertices(const PatchMesh& mesh)
{
    std::vector<std::uint32_t> surfaces(mesh.positions.size());
    for (const MeshSide& side : mesh.sides)
        for (std::size_t n = side.first_vertex; n < side.first_vertex + side.vertex_count; ++n)
            surfaces[n] = side.surface;
    return surfaces;
}

/// Texture coordinates of a point of a surface, in glTF measured from the top; 0 on surfaces without texture.
Float3 texture_coordinates(const Scene& scene, std::uint32_t surface, Vec3 point)
{
    if (!scene.is_textured(surface))
        return {};
    const Surface& s = scene.surfaces()[surface];
    const Vec3 p = point - s.origin;
    const double uu = dot(s.edge_u, s.edge_u);
    const double uv = dot(s.edge_u, s.edge_v);
    const double vv = dot(s.edge_v, s.edge_v);
    const double determinant = uu * vv - uv * uv;
    const double u = (vv * dot(p, s.edge_u) - uv * dot(p, s.edge_v)) / determinant;
    const double v = (uu * dot(p, s.edge_v) - uv * dot(p, s.edge_u)) / determinant;
    const TexturePoint place = mesh_texture_frame(scene, surface).at(u, v);
    return {static_cast<float>(place.s), static_cast<float>(1.0 - place.t), 0.0f};
}

/// Factor from the radiosity of a textured surface without its detail to that with a white texture.
Rgb white_factor(const Material& material)
{
    const auto factor = [](double white, double mean) { return mean > 0.0 ? white / mean : 0.0; };
    const Rgb white = material.texture_scale;
    const Rgb mean = material.reflectance;
    return {factor(white.r, mean.r), factor(white.g, mean.g), factor(white.b, mean.b)};
}

std::vector<Attribute> attributes_of(const PatchMesh& mesh, const Scene& scene, double scale)
{
    const bool textured = !scene.file().textures.empty();
    const std::vector<std::uint32_t> surfaces = textured ? surfaces_of_vertices(mesh) : std::vector<std::uint32_t>();
    const auto shown = [&mesh, &scene, surfaces, scale](std::size_t vertex) {
        Rgb light = scale * to_rgb(mesh.radiosity[vertex]);
        if (!surfaces.empty() && scene.shows_texture(surfaces[vertex]))
            light = white_factor(scene.surface_material(surfaces[vertex])) * light;
        return single(Rgb{std::min(light.r, 1.0), std::min(light.g, 1.0), std::min(light.b, 1.0)});
    };
    std::vector<Attribute> attributes = {{"POSITION", [&mesh](std::size_t n) { return mesh.positions[n]; }},
                                         {"COLOR_0", shown},
                                         {"_RADIOSITY", [&mesh](std::size_t n) { return mesh.radiosity[n]; }}};
    if (textured)
        attributes.push_back({texture_attribute, [&mesh, &scene, surfaces](std::size_t n) {
                                  return texture_coordinates(scene, surfaces[n],
                                                             mesh.origin + to_vec3(mesh.positions[n]));
                              }});
    if (!mesh.error.empty())
        attributes.push_back({"_ERROR", [&mesh](std::size_t n) { return mesh.error[n]; }});
    return attributes;
}

/// [W/m^2] Absolute difference of the radiosities of two vertices.
double light_step(const PatchMesh& mesh, std::uint32_t a, std::uint32_t b)
{
    return std::abs(mean(to_rgb(mesh.radiosity[a])) - mean(to_rgb(mesh.radiosity[b])));
}

/// Appends a face as one or two triangles. A quadrilateral is split along the diagonal with the smaller change of
/// radiosity, so that an oblique shadow edge is not jagged. `shift` is added to the mesh's vertex indices to get those
/// of the part.
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

/// Appends the blocks of attributes and triangles in the layout of GlbBlocks.
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

struct LitArea
{
    double brightness = 0.0; ///< [W/m^2] of the brightest channel
    double area = 0.0;       ///< [m^2]
};

/// [W/m^2] Brightest channel of a patch; of a textured patch as if its texture were white.
double white_brightness(const Scene& scene, const std::vector<Rgb>& radiosity, std::uint32_t patch)
{
    Rgb light = radiosity[patch];
    if (scene.shows_texture(scene.surface_of(patch))) {
        const Rgb rho = scene.reflectance(patch);
        const Rgb white = scene.material_of(patch).texture_scale;
        constexpr double black = 1e-3; // share of white below which a texture is too dark to infer the light on it
        const auto lit = [](double b, double w, double r) { return r > black * w ? b * w / r : b; };
        light = {lit(light.r, white.r, rho.r), lit(light.g, white.g, rho.g), lit(light.b, white.b, rho.b)};
    }
    return std::max({light.r, light.g, light.b});
}

std::vector<LitArea> lit_areas(const Scene& scene, const std::vector<Rgb>& radiosity, bool with_lamps)
{
    std::vector<LitArea> areas;
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        if (!scene.is_sky(scene.surface_of(patch)) && (with_lamps || scene.emittance(patch) == Rgb{}))
            areas.push_back({white_brightness(scene, radiosity, patch), scene.area(patch)});
    return areas;
}

/// [W/m^2] The brightness that is reached or exceeded on a share of the area (a weighted quantile). `areas` must be
/// sorted by decreasing brightness.
double exceeded_on(double share, const std::vector<LitArea>& areas)
{
    double total = 0.0;
    for (const LitArea& lit : areas)
        total += lit.area;
    double before = 0.0;
    for (const LitArea& lit : areas) {
        before += lit.area;
        if (before > share * total)
            return lit.brightness;
    }
    return 0.0;
}

} // namespace

double linear_scale(const Scene& scene, const std::vector<Rgb>& radiosity)
{
    std::vector<LitArea> areas = lit_areas(scene, radiosity, false);
    if (areas.empty())
        areas = lit_areas(scene, radiosity, true);
    std::sort(areas.begin(), areas.end(),
              [](const LitArea& a, const LitArea& b) { return a.brightness > b.brightness; });
    const double bright = exceeded_on(0.01, areas);
    const double middle = exceeded_on(0.5, areas);
    if (!(bright > 0.0))
        return 1.0;
    return middle > 0.0 ? std::max(1.0 / bright, 0.18 / middle) : 1.0 / bright;
}

std::string glb_bytes(const PatchMesh& mesh, const Scene& scene, double scale, const std::vector<GlbCamera>& cameras,
                      const std::vector<std::string>& comments, const std::vector<ImageFile>& images, Vec3 up)
{
    const std::vector<MaterialPart> parts = material_parts(mesh, scene);
    const std::vector<Attribute> attributes = attributes_of(mesh, scene, scale);
    GlbFacts facts{{}, images, scale, cameras, comments, up};
    for (const Attribute& attribute : attributes)
        facts.attributes.push_back(attribute.name);
    const GlbBlocks blocks(parts, attributes.size());
    std::string json = glb_description(mesh, scene, parts, blocks, facts);
    json.append((4 - json.size() % 4) % 4, ' '); // chunks are multiples of four bytes

    const std::size_t numbers = blocks.total() + size_of(images);
    const std::size_t length = 28 + json.size() + numbers;
    if (length > std::numeric_limits<std::uint32_t>::max())
        throw InputError(scene.path() + ": too many patches for a GLB, which holds less than 4 GB; expected a PLY or "
                                        "OBJ, or a larger --patch-size");
    const auto size = [](std::size_t bytes) { return static_cast<std::uint32_t>(bytes); };
    std::string bytes;
    bytes.reserve(length);
    for (const std::uint32_t word : {magic, version, size(length), size(json.size()), json_chunk})
        append_little_endian(bytes, word);
    bytes += json;
    for (const std::uint32_t word : {size(numbers), number_chunk})
        append_little_endian(bytes, word);
    append_numbers(bytes, mesh, parts, attributes);
    for (const ImageFile& image : images)
        bytes.append(image.bytes).append(padded_size(image) - image.bytes.size(), '\0');
    return bytes;
}

} // namespace multipath

#include "export/mesh/coloured_mesh.h"

#include "base/little_endian.h"
#include "base/text_format.h"
#include "export/csv_text.h"

#include <array>
#include <cstdint>
#include <cstdio>

namespace multipath {

namespace {

/// A header line for each property of this type.
std::string properties(const std::string& type, const std::vector<std::string>& names)
{
    std::string lines;
    for (const std::string& name : names)
        lines += "property " + type + " " + name + "\n";
    return lines;
}

std::string ply_header(const PatchMesh& mesh, const std::vector<std::string>& comments)
{
    const std::string radiosity = properties("float", {"radiosity_r", "radiosity_g", "radiosity_b"});
    std::string text = "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : comments)
        text += "comment " + comment + "\n";
    if (mesh.origin != Vec3{})
        text += format("comment offset: %.17g %.17g %.17g\n", mesh.origin.x, mesh.origin.y, mesh.origin.z);
    text += "element vertex " + std::to_string(mesh.positions.size()) + "\n";
    text += properties("float", {"x", "y", "z", "nx", "ny", "nz"});
    text += properties("uchar", {"red", "green", "blue"}) + radiosity;
    if (!mesh.error.empty())
        text += properties("float", {"error_r", "error_g", "error_b"});
    text += "element face " + std::to_string(mesh.faces.size()) + "\n";
    // Signed indices, since not all readers support lists of uint.
    text += "property list uchar int vertex_indices\nproperty int patch\n" + radiosity;
    return text + "end_header\n";
}

void append(std::string& bytes, Float3 values)
{
    for (const float value : values)
        append_little_endian(bytes, value);
}

void append_colour(std::string& bytes, Rgb colour)
{
    for (const double channel : {colour.r, colour.g, colour.b})
        bytes += static_cast<char>(static_cast<unsigned char>(255.0 * channel + 0.5));
}

void append_vertices(std::string& bytes, const PatchMesh& mesh, const MeshSide& side, const ScreenColour& colour)
{
    const Float3 normal = single(side.normal);
    for (std::size_t n = side.first_vertex; n < side.first_vertex + side.vertex_count; ++n) {
        append(bytes, mesh.positions[n]);
        append(bytes, normal);
        append_colour(bytes, colour(to_rgb(mesh.radiosity[n])));
        append(bytes, mesh.radiosity[n]);
        if (!mesh.error.empty())
            append(bytes, mesh.error[n]);
    }
}

void append_face(std::string& bytes, const MeshFace& face, Rgb radiosity)
{
    bytes += static_cast<char>(face.corner_count);
    for (const std::uint32_t corner : face)
        append_little_endian(bytes, corner);
    append_little_endian(bytes, face.patch);
    append(bytes, single(radiosity));
}

} // namespace

std::string ply_bytes(const PatchMesh& mesh, const std::vector<Rgb>& radiosity_per_patch, const ScreenColour& colour,
                      const std::vector<std::string>& comments)
{
    std::string bytes = ply_header(mesh, comments);
    for (const MeshSide& side : mesh.sides)
        append_vertices(bytes, mesh, side, colour);
    for (const MeshFace& face : mesh.faces)
        append_face(bytes, face, radiosity_per_patch[face.patch]);
    return bytes;
}

namespace {

void append_side(std::string& text, const PatchMesh& mesh, const MeshSide& side, int digits, const ScreenColour& colour)
{
    std::array<char, 128> line{};
    for (std::size_t n = side.first_vertex; n < side.first_vertex + side.vertex_count; ++n) {
        const Vec3 p = mesh.origin + to_vec3(mesh.positions[n]) + Vec3{}; // never "-0"
        const Rgb c = colour(to_rgb(mesh.radiosity[n]));
        const int length = std::snprintf(line.data(), line.size(), "v %.*g %.*g %.*g %.4f %.4f %.4f\n", digits, p.x,
                                         digits, p.y, digits, p.z, c.r, c.g, c.b);
        text.append(line.data(), static_cast<std::size_t>(length));
    }
}

void append_faces(std::string& text, const PatchMesh& mesh, const MeshSide& side)
{
    for (std::size_t n = side.first_face; n < side.first_face + side.face_count; ++n) {
        text += "f";
        for (const std::uint32_t corner : mesh.faces[n])
            text += " " + std::to_string(std::uint64_t{corner} + 1);
        text += "\n";
    }
}

} // namespace

std::string obj_text(const PatchMesh& mesh, const Scene& scene, const ScreenColour& colour,
                     const std::vector<std::string>& comments)
{
    std::string text = comment_lines(comments);
    const SceneFile& file = scene.file();
    const int digits = coordinate_digits(scene.own_bounds(), 7);
    std::string group;
    std::string material;
    for (const MeshSide& side : mesh.sides) {
        append_side(text, mesh, side, digits, colour);
        const std::string& its_group = file.groups[file.group[side.surface]];
        if (its_group != group)
            text += "g " + its_group + "\n";
        group = its_group;
        const std::string& its_material = file.materials[file.material[side.surface]].name;
        if (its_material != material)
            text += "usemtl " + its_material + "\n";
        material = its_material;
        append_faces(text, mesh, side);
    }
    return text;
}

} // namespace multipath

#include "export/mesh/obj_colours.h"

#include "export/csv_text.h"

#include <array>
#include <cstdio>

namespace multipath {

namespace {

/// Appends a vertex line, with seven significant digits as positions are floats.
void append_vertex(std::string& text, Float3 position, Rgb colour)
{
    std::array<char, 128> line{};
    const auto at = [&](std::size_t axis) { return static_cast<double>(position[axis]) + 0.0; }; // never "-0"
    const int length = std::snprintf(line.data(), line.size(), "v %.7g %.7g %.7g %.4f %.4f %.4f\n", at(0), at(1), at(2),
                                     colour.r, colour.g, colour.b);
    text.append(line.data(), static_cast<std::size_t>(length));
}

void append_side(std::string& text, const PatchMesh& mesh, const MeshSide& side, const ScreenColour& colour)
{
    for (std::size_t n = side.first_vertex; n < side.first_vertex + side.vertex_count; ++n)
        append_vertex(text, mesh.positions[n], colour(to_rgb(mesh.radiosity[n])));
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
    std::string text;
    text.reserve(60 * mesh.positions.size() + 35 * mesh.faces.size());
    text += comment_lines(comments);
    const SceneFile& file = scene.file();
    std::string group;
    std::string material;
    for (const MeshSide& side : mesh.sides) {
        append_side(text, mesh, side, colour);
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

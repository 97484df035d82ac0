#include "export/material_parts.h"

#include <algorithm>

namespace multipath {

std::vector<MaterialPart> material_parts(const PatchMesh& mesh, const Scene& scene)
{
    std::vector<MaterialPart> parts(scene.materials().size());
    for (const MeshSide& side : mesh.sides) {
        MaterialPart& part = parts[scene.file().material[side.surface]];
        part.material = scene.file().material[side.surface];
        part.sides.push_back(side);
        part.vertex_count += side.vertex_count;
        for (std::size_t n = side.first_face; n < side.first_face + side.face_count; ++n)
            part.triangle_count += mesh.faces[n].corner_count - 2;
    }
    const auto unused = [](const MaterialPart& part) { return part.sides.empty(); };
    parts.erase(std::remove_if(parts.begin(), parts.end(), unused), parts.end());
    return parts;
}

} // namespace multipath

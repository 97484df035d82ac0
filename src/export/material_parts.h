#pragma once

#include "export/patch_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// What of a mesh one material has.
struct MaterialPart
{
    std::uint32_t material = 0;
    std::vector<MeshSide> sides;
    std::size_t vertex_count = 0;
    std::size_t triangle_count = 0; ///< a quadrilateral counts as two
};

/// The parts of all materials that are used, in the order of the scene's materials.
std::vector<MaterialPart> material_parts(const PatchMesh& mesh, const Scene& scene);

/// Calls visit(number) for the vertices of a part, in order.
template <class Visit>
void for_each_vertex(const MaterialPart& part, const Visit& visit)
{
    for (const MeshSide& side : part.sides)
        for (std::size_t n = side.first_vertex; n < side.first_vertex + side.vertex_count; ++n)
            visit(n);
}

} // namespace multipath

#pragma once

#include "export/material_parts.h"
#include "export/patch_mesh.h"

#include <string>
#include <vector>

namespace multipath {

/// The size of the numbers in a GLB [byte], which follow each other without gaps: one block per attribute, three floats
/// for each vertex, then three 32-bit numbers for each triangle. In every block, part follows part.
struct GlbBlocks
{
    GlbBlocks(const std::vector<MaterialPart>& parts, std::size_t attributes);

    std::size_t attribute_count = 0;
    std::size_t attribute_bytes = 0; ///< of each
    std::size_t triangle_bytes = 0;

    std::size_t total() const { return attribute_count * attribute_bytes + triangle_bytes; }
};

/// What the JSON in a GLB tells beside the mesh.
struct GlbFacts
{
    std::vector<std::string> attributes; ///< names; the first is POSITION
    double scale = 1.0;                  ///< [m^2/W] from radiosity to colour
    std::vector<std::string> comments;
};

/// The JSON of a GLB (glTF 2.0): what the blocks hold, and where.
std::string glb_description(const PatchMesh& mesh, const Scene& scene, const std::vector<MaterialPart>& parts,
                            const GlbBlocks& blocks, const GlbFacts& facts);

} // namespace multipath

#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace multipath {

/// Neighbouring patches of one surface taken together. Blocks are numbered in the order of their surfaces, like
/// patches.
struct PatchBlocks
{
    std::uint32_t count = 0;
    std::vector<std::uint32_t> block_of; ///< per patch
};

/// Blocks of up to cells x cells patches. Blocks of 2 k cells are made of whole blocks of k cells.
PatchBlocks patch_blocks(const Scene& scene, std::uint32_t cells);

/// How many there are, without finding them.
double block_count(const Scene& scene, std::uint32_t cells);

/// One block for every surface, and for its back where it has patches.
PatchBlocks surface_blocks(const Scene& scene);

} // namespace multipath

#pragma once

#include <cstdint>

namespace multipath {

/// A node of the hierarchy: the boxes of up to 16 children side by side, in the coordinates of FilterFrame. Plain data.
struct alignas(64) WideNode
{
    static constexpr unsigned lanes = 16;
    static constexpr unsigned stack_size = 1024; ///< pending children: 15 more for each of at most 64 levels
    static constexpr std::uint32_t block_flag = 0x80000000u;

    float low[3][lanes]; ///< low > high for a child that is not there
    float high[3][lanes];
    std::uint32_t child[lanes]; ///< number of a node, or block_flag + number of a block of surfaces
};

} // namespace multipath

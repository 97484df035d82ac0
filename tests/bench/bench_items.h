#pragma once

#include "sampling/sequence.h"

#include <cstddef>
#include <vector>

namespace multipath {

constexpr std::size_t block = 4096;

inline std::vector<Item> some_items(std::size_t count)
{
    std::vector<Item> items(count);
    make_sequence("sobol", 1)->generate(0, items);
    return items;
}

} // namespace multipath

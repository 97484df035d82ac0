#pragma once

#include <cstdint>
#include <vector>

namespace multipath {

/// Sorts numbers below 2^bits; time grows like count * bits. Radix sort, with a second list of the same length.
void sort_keys(std::vector<std::uint64_t>& keys, int bits);

} // namespace multipath

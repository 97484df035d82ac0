#pragma once

#include <cstddef>

namespace multipath {

/// Tells the system that large memory should come in pages of 2 MB where it can: fewer interruptions when it is first
/// touched, and fewer misses of the table of addresses afterwards. What `new` hands out was asked for already.
void ask_for_huge_pages(void* memory, std::size_t bytes);

} // namespace multipath

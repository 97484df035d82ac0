#pragma once

#include <cstdint>
#include <functional>

namespace multipath {

/// Called now and then with the number of lines done since the last call.
using LineCounter = std::function<void(std::uint64_t lines)>;

} // namespace multipath

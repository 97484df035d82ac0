#pragma once

#include <cstdint>
#include <string>

namespace multipath {

/// What printf would print.
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
std::string
format(const char* pattern, ...);

/// 4194304 as "4,194,304".
std::string grouped(std::uint64_t count);

} // namespace multipath

#include "cli/usage_error.h"

#include <algorithm>

namespace multipath {

std::string quoted_argument(std::string_view text)
{
    std::string result = "'" + std::string(text) + "'";
    std::replace_if(
        result.begin(), result.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return result;
}

} // namespace multipath

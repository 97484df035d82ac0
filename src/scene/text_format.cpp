#include "scene/text_format.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace multipath {

std::string format(const char* pattern, ...)
{
    va_list values;
    va_start(values, pattern);
    va_list values_again;
    va_copy(values_again, values);
    const int length = std::vsnprintf(nullptr, 0, pattern, values);
    va_end(values);
    std::string text(static_cast<std::size_t>(std::max(length, 0)), '\0');
    std::vsnprintf(text.data(), text.size() + 1, pattern, values_again);
    va_end(values_again);
    return text;
}

std::string grouped(std::uint64_t count)
{
    std::string digits = std::to_string(count);
    for (std::size_t place = digits.size(); place > 3; place -= 3)
        digits.insert(place - 3, ",");
    return digits;
}

} // namespace multipath

#include "scene/text_format.h"

#include <array>
#include <cstdarg>
#include <cstdio>

namespace multipath {

std::string format(const char* pattern, ...)
{
    std::array<char, 512> text{};
    va_list values;
    va_start(values, pattern);
    std::vsnprintf(text.data(), text.size(), pattern, values);
    va_end(values);
    return text.data();
}

std::string grouped(std::uint64_t count)
{
    std::string digits = std::to_string(count);
    for (std::size_t place = digits.size(); place > 3; place -= 3)
        digits.insert(place - 3, ",");
    return digits;
}

} // namespace multipath

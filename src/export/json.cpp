#include "export/json.h"

#include "base/lists.h"
#include "base/text_format.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace multipath {

namespace {

std::string quoted(std::string_view text)
{
    std::string result = "\"";
    for (const char c : valid_utf8(text)) {
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (static_cast<unsigned char>(c) < 0x20) {
            result += format("\\u%04x", static_cast<unsigned>(c));
        } else {
            result += c;
        }
    }
    return result + "\"";
}

std::string number_text(std::optional<double> value)
{
    if (!value || !std::isfinite(*value))
        return "null";
    std::array<char, 32> text{};
    for (int digits = 15; digits <= 17; ++digits) { // the shortest form that reads back as the same number
        std::snprintf(text.data(), text.size(), "%.*g", digits, *value);
        if (std::strtod(text.data(), nullptr) == *value)
            break;
    }
    return text.data();
}

template <class Values, class Format>
std::string list(const Values& values, const Format& format)
{
    return "[" + join(mapped(values, format)) + "]";
}

} // namespace

JsonObject& JsonObject::add(std::string_view key, const std::string& value)
{
    members_.push_back(quoted(key) + ": " + value);
    return *this;
}
JsonObject& JsonObject::text(std::string_view key, std::string_view value)
{
    return add(key, quoted(value));
}
JsonObject& JsonObject::number(std::string_view key, std::optional<double> value)
{
    return add(key, number_text(value));
}
JsonObject& JsonObject::numbers(std::string_view key, const std::vector<double>& values)
{
    return add(key, list(values, number_text));
}
JsonObject& JsonObject::texts(std::string_view key, const std::vector<std::string>& values)
{
    return add(key, list(values, quoted));
}
JsonObject& JsonObject::objects(std::string_view key, const std::vector<JsonObject>& values)
{
    return add(key, list(values, [](const JsonObject& object) { return "\n    " + object.inline_form(); }));
}

std::string JsonObject::inline_form() const
{
    return "{" + join(members_) + "}";
}

std::string JsonObject::document() const
{
    return "{\n  " + join(members_, ",\n  ") + "\n}\n";
}

} // namespace multipath

#include "export/json.h"

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

std::string number_text(double value)
{
    if (!std::isfinite(value))
        return "null";
    std::array<char, 32> text{};
    for (int digits = 15; digits <= 17; ++digits) { // the shortest form that reads back as the same number
        std::snprintf(text.data(), text.size(), "%.*g", digits, value);
        if (std::strtod(text.data(), nullptr) == value)
            break;
    }
    return text.data();
}

template <class Values, class Format>
std::string list(const Values& values, const Format& format)
{
    std::string result;
    for (const auto& value : values)
        result += (result.empty() ? "" : ", ") + format(value);
    return "[" + result + "]";
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
JsonObject& JsonObject::number(std::string_view key, double value)
{
    return add(key, number_text(value));
}
JsonObject& JsonObject::count(std::string_view key, std::uint64_t value)
{
    return add(key, std::to_string(value));
}
JsonObject& JsonObject::boolean(std::string_view key, bool value)
{
    return add(key, value ? "true" : "false");
}
JsonObject& JsonObject::null(std::string_view key)
{
    return add(key, "null");
}
JsonObject& JsonObject::numbers(std::string_view key, const std::vector<double>& values)
{
    return add(key, list(values, number_text));
}
JsonObject& JsonObject::texts(std::string_view key, const std::vector<std::string>& values)
{
    return add(key, list(values, quoted));
}
JsonObject& JsonObject::object(std::string_view key, const JsonObject& value)
{
    return add(key, value.inline_form());
}
JsonObject& JsonObject::objects(std::string_view key, const std::vector<JsonObject>& values)
{
    return add(key, list(values, [](const JsonObject& object) { return "\n    " + object.inline_form(); }));
}

std::string JsonObject::inline_form() const
{
    std::string result;
    for (const std::string& member : members_)
        result += (result.empty() ? "" : ", ") + member;
    return "{" + result + "}";
}

std::string JsonObject::document() const
{
    std::string result;
    for (const std::string& member : members_)
        result += (result.empty() ? "  " : ",\n  ") + member;
    return "{\n" + result + "\n}\n";
}

} // namespace multipath

#pragma once

#include "geometry/vec3.h"
#include "scene/rgb.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Builds a JSON object. Members appear in the order of the calls, which can be chained. Bytes that are not part of
/// valid UTF-8 are read as Latin-1. A number is rounded to 15, 16 or 17 significant digits, the fewest from which the
/// same double is read back; a number that is missing or not finite becomes null.
class JsonObject
{
public:
    JsonObject& text(std::string_view key, std::string_view value);
    JsonObject& number(std::string_view key, std::optional<double> value);
    JsonObject& count(std::string_view key, std::uint64_t value) { return add(key, std::to_string(value)); }
    JsonObject& boolean(std::string_view key, bool value) { return add(key, value ? "true" : "false"); }
    JsonObject& null(std::string_view key) { return add(key, "null"); }
    JsonObject& numbers(std::string_view key, const std::vector<double>& values);
    JsonObject& numbers(std::string_view key, Vec3 v) { return numbers(key, std::vector{v.x, v.y, v.z}); }
    JsonObject& numbers(std::string_view key, Rgb c) { return numbers(key, std::vector{c.r, c.g, c.b}); }
    JsonObject& texts(std::string_view key, const std::vector<std::string>& values);
    JsonObject& object(std::string_view key, const JsonObject& value) { return add(key, value.inline_form()); }
    JsonObject& objects(std::string_view key, const std::vector<JsonObject>& values);

    /// The text of a JSON file with at least one member: one indented line per member of the object, and one line per
    /// element of an array that objects() added.
    std::string document() const;

private:
    JsonObject& add(std::string_view key, const std::string& value);
    std::string inline_form() const;

    std::vector<std::string> members_; ///< each as text: "key": value
};

} // namespace multipath

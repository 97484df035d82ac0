#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Builds a JSON object. Members appear in the order of the calls, which can be chained. Bytes of texts that are not
/// UTF-8 are taken for Latin-1.
class JsonObject
{
public:
    JsonObject& text(std::string_view key, std::string_view value);
    JsonObject& number(std::string_view key, double value); ///< null if not finite, which JSON cannot represent
    JsonObject& count(std::string_view key, std::uint64_t value);
    JsonObject& boolean(std::string_view key, bool value);
    JsonObject& null(std::string_view key);
    JsonObject& numbers(std::string_view key, const std::vector<double>& values);
    JsonObject& texts(std::string_view key, const std::vector<std::string>& values);
    JsonObject& object(std::string_view key, const JsonObject& value);
    JsonObject& objects(std::string_view key, const std::vector<JsonObject>& values);

    /// The text of a JSON file: one line per member of the object, indented.
    std::string document() const;

private:
    JsonObject& add(std::string_view key, const std::string& value);
    std::string inline_form() const;

    std::vector<std::string> members_; ///< "\"key\": value"
};

} // namespace multipath

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// A JSON object that is written key by key, in the order of the calls. Bytes that are not UTF-8 are read as Latin-1.
class JsonObject
{
public:
    void text(std::string_view key, std::string_view value);
    void number(std::string_view key, double value); ///< null when not finite, which JSON cannot say
    void count(std::string_view key, std::uint64_t value);
    void boolean(std::string_view key, bool value);
    void null(std::string_view key);
    void numbers(std::string_view key, const std::vector<double>& values);
    void texts(std::string_view key, const std::vector<std::string>& values);
    void object(std::string_view key, const JsonObject& value);
    void objects(std::string_view key, const std::vector<JsonObject>& values);

    /// One line per key, indented.
    std::string document() const;

private:
    void add(std::string_view key, const std::string& value);
    std::string inline_form() const;

    std::vector<std::string> members_; ///< "\"key\": value"
};

} // namespace multipath

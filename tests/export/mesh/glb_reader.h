#pragma once

#include "export/mesh/json_reader.h"
#include "export/mesh/ply_reader.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace multipath {

/// The two chunks of a GLB, and how to find numbers in them.
struct GlbFile
{
    explicit GlbFile(const std::string& bytes)
    {
        const auto word = [&](std::size_t at) {
            return static_cast<std::size_t>(ByteReader(bytes, at).number("uint"));
        };
        REQUIRE(bytes.substr(0, 4) == "glTF");
        REQUIRE(word(4) == 2);
        REQUIRE(word(8) == bytes.size());
        const std::size_t json_length = word(12);
        REQUIRE(bytes.substr(16, 4) == "JSON");
        REQUIRE(json_length % 4 == 0);
        const std::string text = bytes.substr(20, json_length);
        json = JsonReader(text).document();
        REQUIRE(bytes.substr(24 + json_length, 4) == std::string("BIN\0", 4));
        numbers = bytes.substr(28 + json_length);
        REQUIRE(word(20 + json_length) == numbers.size());
        REQUIRE(json["buffers"][0]["byteLength"].count() == numbers.size());
    }

    const JsonValue& primitive(std::size_t mesh) const { return json["meshes"][mesh]["primitives"][0]; }

    /// The numbers of an accessor, one after the other.
    std::vector<double> values(std::size_t accessor) const
    {
        const JsonValue& entry = json["accessors"][accessor];
        const JsonValue& view = json["bufferViews"][entry["bufferView"].count()];
        const std::map<std::string, std::size_t> sizes = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}};
        const std::size_t count = entry["count"].count() * sizes.at(entry["type"].text);
        REQUIRE(entry["byteOffset"].count() + 4 * count <= view["byteLength"].count());
        ByteReader reader(numbers, view["byteOffset"].count() + entry["byteOffset"].count());
        std::vector<double> result;
        for (std::size_t n = 0; n < count; ++n)
            result.push_back(reader.number(entry["componentType"].text == "5126" ? "float" : "uint"));
        return result;
    }
    std::vector<double> values(const JsonValue& accessor) const { return values(accessor.count()); }
    std::vector<double> attribute(const JsonValue& primitive, const std::string& name) const
    {
        return values(primitive["attributes"][name].count());
    }

    std::string view(std::size_t number) const
    {
        const JsonValue& view = json["bufferViews"][number];
        return numbers.substr(view["byteOffset"].count(), view["byteLength"].count());
    }

    JsonValue json;
    std::string numbers;
};

} // namespace multipath

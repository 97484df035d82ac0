#pragma once

#include "export/mesh/json_reader.h"
#include "export/mesh/ply_reader.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <map>
#include <optional>
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
        const std::size_t size = sizes.at(entry["type"].text);
        const std::size_t stride = view.members.count("byteStride") == 1 ? view["byteStride"].count() : 4 * size;
        REQUIRE(entry["byteOffset"].count() + stride * entry["count"].count() <= view["byteLength"].count());
        std::vector<double> result;
        for (std::size_t n = 0; n < entry["count"].count(); ++n) {
            ByteReader reader(numbers, view["byteOffset"].count() + entry["byteOffset"].count() + n * stride);
            for (std::size_t k = 0; k < size; ++k)
                result.push_back(reader.number(entry["componentType"].text == "5126" ? "float" : "uint"));
        }
        return result;
    }
    std::vector<double> values(const JsonValue& accessor) const { return values(accessor.count()); }
    std::vector<double> attribute(const JsonValue& primitive, const std::string& name) const
    {
        return values(primitive["attributes"][name].count());
    }

    /// Where the nodes of the scene put a point of a mesh, or of a camera: `kind` is "mesh" or "camera".
    Vec3 placed(const std::string& kind, std::size_t number, Vec3 p) const
    {
        for (const JsonValue& root : json["scenes"][0]["nodes"].list)
            if (const auto place = placed_by(root.count(), kind, number, p))
                return *place;
        FAIL("no node has it");
        return {};
    }

    /// The corners of the triangles of a mesh where the nodes put them.
    std::vector<Vec3> corners(std::size_t mesh) const
    {
        const std::vector<double> positions = attribute(primitive(mesh), "POSITION");
        std::vector<Vec3> result;
        for (const double corner : values(primitive(mesh)["indices"])) {
            const auto first = 3 * static_cast<std::size_t>(corner);
            result.push_back(
                placed("mesh", mesh, {positions.at(first), positions.at(first + 1), positions.at(first + 2)}));
        }
        return result;
    }
    /// Those of all meshes.
    std::vector<Vec3> corners() const
    {
        std::vector<Vec3> all;
        for (std::size_t mesh = 0; mesh < json["meshes"].list.size(); ++mesh)
            for (const Vec3 corner : corners(mesh))
                all.push_back(corner);
        return all;
    }

    std::string view(std::size_t number) const
    {
        const JsonValue& view = json["bufferViews"][number];
        return numbers.substr(view["byteOffset"].count(), view["byteLength"].count());
    }

    JsonValue json;
    std::string numbers;

private:
    std::optional<Vec3> placed_by(std::size_t number, const std::string& kind, std::size_t wanted, Vec3 p) const
    {
        const JsonValue& node = json["nodes"][number];
        const auto has = [&](const char* key) { return node.members.count(key) == 1; };
        std::optional<Vec3> place;
        if (has(kind.c_str()) && node[kind].count() == wanted)
            place = p;
        if (has("children"))
            for (const JsonValue& child : node["children"].list)
                if (!place)
                    place = placed_by(child.count(), kind, wanted, p);
        if (!place || !has("matrix"))
            return place;
        const auto m = [&](std::size_t n) { return node["matrix"][n].number(); };
        const auto row = [&](std::size_t k) {
            return m(k) * place->x + m(4 + k) * place->y + m(8 + k) * place->z + m(12 + k);
        };
        return Vec3{row(0), row(1), row(2)};
    }
};

} // namespace multipath

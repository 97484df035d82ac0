#pragma once

#include "geometry/vec3.h"
#include "scene/rgb.h"

#include <cstdint>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace multipath {

/// A second opinion on what a binary PLY says: reads by the header alone, whatever properties there are.
struct PlyFile
{
    struct Vertex
    {
        Vec3 position;
        Vec3 normal;
        Rgb colour; ///< bytes
        Rgb radiosity;
        Rgb error;
    };
    struct Face
    {
        std::vector<std::size_t> corners;
        std::uint32_t patch = 0;
        Rgb radiosity;
    };

    std::vector<std::string> comments;
    std::vector<Vertex> vertices;
    std::vector<Face> faces;
    std::vector<std::string> vertex_properties; ///< "float x"
    std::vector<std::string> face_properties;
};

/// Takes numbers off the front of binary data.
class ByteReader
{
public:
    ByteReader(const std::string& bytes, std::size_t at) : bytes_(bytes), at_(at) {}

    double number(const std::string& type)
    {
        const std::size_t size = type == "uchar" ? 1 : 4;
        if (at_ + size > bytes_.size())
            throw std::runtime_error("the data are too short");
        std::uint32_t bits = 0;
        for (std::size_t n = 0; n < size; ++n)
            bits |= std::uint32_t{static_cast<unsigned char>(bytes_[at_ + n])} << (8 * n);
        at_ += size;
        if (type != "float")
            return bits;
        float value = 0.0f;
        std::memcpy(&value, &bits, sizeof value);
        return static_cast<double>(value);
    }
    std::size_t at() const { return at_; }

private:
    const std::string& bytes_;
    std::size_t at_;
};

inline PlyFile::Vertex read_vertex(ByteReader& reader, const std::vector<std::string>& properties)
{
    PlyFile::Vertex vertex;
    for (const std::string& property : properties) {
        const std::size_t blank = property.find(' ');
        const std::string name = property.substr(blank + 1);
        const double value = reader.number(property.substr(0, blank));
        const auto set = [&](const char* wanted, double& place) {
            if (name == wanted)
                place = value;
        };
        set("x", vertex.position.x), set("y", vertex.position.y), set("z", vertex.position.z);
        set("nx", vertex.normal.x), set("ny", vertex.normal.y), set("nz", vertex.normal.z);
        set("red", vertex.colour.r), set("green", vertex.colour.g), set("blue", vertex.colour.b);
        set("radiosity_r", vertex.radiosity.r), set("radiosity_g", vertex.radiosity.g);
        set("radiosity_b", vertex.radiosity.b);
        set("error_r", vertex.error.r), set("error_g", vertex.error.g), set("error_b", vertex.error.b);
    }
    return vertex;
}

/// Throws for what is no such file or has bytes left over.
inline PlyFile read_ply(const std::string& bytes)
{
    PlyFile file;
    std::size_t vertex_count = 0;
    std::size_t face_count = 0;
    std::vector<std::string>* properties = nullptr;
    std::size_t at = 0;
    for (std::string line; line != "end_header";) {
        const std::size_t end = bytes.find('\n', at);
        if (end == std::string::npos)
            throw std::runtime_error("no end of the header");
        line = bytes.substr(at, end - at);
        at = end + 1;
        if (line.compare(0, 8, "comment ") == 0)
            file.comments.push_back(line.substr(8));
        else if (line.compare(0, 15, "element vertex ") == 0)
            vertex_count = std::stoul(line.substr(15)), properties = &file.vertex_properties;
        else if (line.compare(0, 13, "element face ") == 0)
            face_count = std::stoul(line.substr(13)), properties = &file.face_properties;
        else if (line.compare(0, 9, "property ") == 0)
            properties->push_back(line.substr(9));
        else if (line != "ply" && line != "format binary_little_endian 1.0" && line != "end_header")
            throw std::runtime_error("unexpected: " + line);
    }
    ByteReader reader(bytes, at);
    for (std::size_t n = 0; n < vertex_count; ++n)
        file.vertices.push_back(read_vertex(reader, file.vertex_properties));
    for (std::size_t n = 0; n < face_count; ++n) {
        PlyFile::Face face;
        const double corners = reader.number("uchar");
        for (double k = 0; k < corners; ++k)
            face.corners.push_back(static_cast<std::size_t>(reader.number("int")));
        face.patch = static_cast<std::uint32_t>(reader.number("int"));
        face.radiosity.r = reader.number("float");
        face.radiosity.g = reader.number("float");
        face.radiosity.b = reader.number("float");
        file.faces.push_back(face);
    }
    if (reader.at() != bytes.size())
        throw std::runtime_error("bytes are left over");
    return file;
}

} // namespace multipath

// An OBJ file is a list of statements, one per line. `v` adds a vertex, `f` a polygon given by vertex numbers: positive
// ones count from 1, negative ones back from the last vertex read so far. A number may refer to a later vertex, so
// numbers are checked after the whole file is read. `vt` adds a texture point; corners refer to it in the same way, but
// a reference to one that does not exist is ignored. Normals do not matter for diffuse light and are skipped.
//
// `g` divides an object into groups, so a face after `o` and `g` has both names. A new `o` ends the group.

#include "scene/obj/obj_mesh.h"

#include "base/lists.h"
#include "scene/text/text_lines.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <system_error>
#include <unordered_map>
#include <utility>

namespace multipath {

namespace {

/// Squares of areas must stay in the range of single precision, in which the exchange between patches is stored.
constexpr double largest_coordinate = 1e9;

/// Free-form surfaces and included files: ignoring them would change the scene.
constexpr std::array<std::string_view, 6> unsupported_keywords = {"surf", "bzp", "bsp", "cdp", "cdc", "call"};

/// Statements that do not affect diffuse surfaces: lines and points have no area.
constexpr std::array<std::string_view, 16> harmless_keywords = {
    "vn",       "vp",       "s",      "l",      "p",         "mg",         "lod",   "bevel",
    "c_interp", "d_interp", "usemap", "maplib", "trace_obj", "shadow_obj", "ctech", "stech"};

constexpr std::string_view unknown_numbers = "the numbers after the coordinates of a vertex are ignored, expected a "
                                             "weight, or red, green and blue from 0 to 1";

/// [1] Colour of a vertex without one.
constexpr Rgb no_colour = {-1.0, -1.0, -1.0};

/// The number in a reference such as "12" or "-3", clamped to 2^32 - 1 in magnitude; nothing for other texts.
std::optional<std::int64_t> reference(std::string_view text)
{
    constexpr std::int64_t largest = std::numeric_limits<std::uint32_t>::max();
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc::invalid_argument || end != text.data() + text.size())
        return std::nullopt;
    if (error == std::errc::result_out_of_range)
        return text[0] == '-' ? -largest : largest;
    return std::clamp(number, -largest, largest);
}

class ObjParser
{
public:
    explicit ObjParser(const std::string& path) : lines_(path)
    {
        constexpr std::size_t bytes_of_vertex = 32; // usual; memory that stays unused takes no time, but moving would
        mesh_.path = path;
        mesh_.vertices.reserve(lines_.file_size() / bytes_of_vertex);
    }
    ObjMesh parse()
    {
        bool any_line = false;
        TextLine line;
        while (lines_.next(line)) {
            statement(line);
            any_line = true;
        }
        if (!any_line)
            refuse(at_line(1), "the file is empty, expected a Wavefront OBJ file");
        if (mesh_.faces.empty())
            refuse(at_line(0), "no faces found, expected a Wavefront OBJ file with `f` statements of three vertices or "
                               "more");
        check_references();
        complete_colours();
        mesh_.warnings = flaws_.warnings(mesh_.path);
        return std::move(mesh_);
    }

private:
    void statement(const TextLine& line)
    {
        std::string_view rest = line.text;
        const std::string_view keyword = next_word(rest);
        if (keyword == "v")
            vertex(without_comment(rest), line.place);
        else if (keyword == "f" || keyword == "fo")
            face(without_comment(rest), line);
        else if (keyword == "vt")
            texture_point(without_comment(rest), line.place.line);
        else if (!keyword.empty() && keyword[0] != '#' && keyword != "vn")
            named_statement(keyword, rest, line.place);
    }

    void named_statement(std::string_view keyword, std::string_view rest, const TextLocation& place)
    {
        if (keyword == "usemtl") {
            material_ = trimmed(rest);
            names_changed_ = true;
        } else if (keyword == "g") {
            group_ = name_in(rest);
            names_changed_ = true;
        } else if (keyword == "o") {
            object_ = name_in(rest);
            group_.clear();
            names_changed_ = true;
        } else if (keyword == "mtllib") {
            library(name_in(rest), place);
        } else if (is_among(keyword, unsupported_keywords)) {
            refuse(place, in_quotes(keyword) + " is not supported, expected polygons (`f`)");
        } else if (!is_among(keyword, harmless_keywords)) {
            flaws_.add("unknown statements ignored", place.line, keyword);
        }
    }

    /// Adds a vertex: x y z, optionally followed by a weight (one number) or a colour (three).
    void vertex(std::string_view rest, const TextLocation& place)
    {
        std::array<double, 3> x = {};
        for (double& coordinate : x) {
            coordinate = read_number(next_word(rest), place, "vertex");
            if (std::abs(coordinate) > largest_coordinate)
                refuse(place, "coordinate beyond 1e9, expected a scene of sensible size");
        }
        if (mesh_.vertices.size() == std::numeric_limits<std::uint32_t>::max() / 2)
            refuse(place, "more than 2^31 vertices, expected fewer");
        mesh_.vertices.push_back({x[0], x[1], x[2]});

        std::array<double, 3> more = {};
        std::size_t count = 0;
        for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest), ++count)
            (count < more.size() ? more[count] : x[0]) = read_number(word, place, "vertex");
        if (count == 1 && more[0] != 1.0)
            flaws_.add("the weight of a vertex (fourth number) is ignored, polygons have none", place.line);
        if (count == 3)
            colour(more[0], more[1], more[2], place.line);
        else if (count > 1)
            flaws_.add(unknown_numbers, place.line);
    }

    void face(std::string_view rest, const TextLine& line)
    {
        if (names_changed_)
            number_names(line.place.line);
        const std::size_t first = mesh_.corners.size();
        std::string_view last_word;
        for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
            mesh_.corners.push_back(corner(word, line.place));
            last_word = word;
        }
        const std::size_t count = mesh_.corners.size() - first;
        if (!line.ended && (count < 3 || last_word.back() == '/'))
            refuse(line.place, "the file ends in the middle of a face, expected at least three complete corners");
        if (mesh_.corners.size() > std::numeric_limits<std::uint32_t>::max() / 2)
            refuse(line.place, "more than 2^31 corners of faces, expected fewer");
        if (count < 3) {
            mesh_.corners.resize(first);
            return flaws_.add("a face of fewer than three vertices is dropped", line.place.line);
        }
        next_face_.first_corner = static_cast<std::uint32_t>(first);
        next_face_.corner_count = static_cast<std::uint32_t>(count);
        next_face_.line = line.place.line;
        mesh_.faces.push_back(next_face_);
    }

    /// A corner `v`, `v/vt`, `v//vn` or `v/vt/vn`. References to later vertices and points are returned unchecked, and
    /// a malformed reference to a point as one that does not exist.
    ObjCorner corner(std::string_view word, const TextLocation& place) const
    {
        const std::size_t slash = std::min(word.find('/'), word.size());
        const std::optional<std::int64_t> number = reference(word.substr(0, slash));
        const auto is_part = [](char c) { return (c >= '0' && c <= '9') || c == '/' || c == '-'; };
        if (!number || !std::all_of(word.begin() + static_cast<std::ptrdiff_t>(slash), word.end(), is_part))
            refuse(place, in_quotes(word) + " is not a corner, expected a vertex number, or `v/vt/vn`");
        if (*number == 0)
            refuse(place, "vertex number 0, expected a number from 1, or a negative one that counts back");
        const auto vertex_count = static_cast<std::int64_t>(mesh_.vertices.size());
        if (-*number > vertex_count)
            refuse(place, "vertex " + in_quotes(word) + " counts back past the first vertex, " +
                              std::to_string(vertex_count) + " are defined before this line");
        if (*number >= std::int64_t{ObjCorner::none})
            refuse(place, "vertex number " + in_quotes(word) + " is too large");
        ObjCorner result;
        result.vertex = static_cast<std::uint32_t>(*number < 0 ? vertex_count + *number : *number - 1);

        const std::string_view rest = word.substr(std::min(slash + 1, word.size()));
        if (const std::string_view point = rest.substr(0, rest.find('/')); !point.empty()) {
            constexpr std::int64_t missing = ObjCorner::none - 1;
            const std::int64_t given = reference(point).value_or(0);
            const auto point_count = static_cast<std::int64_t>(mesh_.texture_points.size());
            const std::int64_t index = given < 0 ? point_count + given : given - 1;
            result.point = static_cast<std::uint32_t>(index < 0 ? missing : std::min(index, missing));
        }
        return result;
    }

    /// Sets the colour of the vertex added last.
    void colour(double red, double green, double blue, std::uint32_t line)
    {
        const auto [least, largest] = std::minmax({red, green, blue});
        if (least < 0.0 || largest > 1.0) {
            flaws_.add(unknown_numbers, line);
            return;
        }
        mesh_.colours.resize(mesh_.vertices.size(), no_colour);
        mesh_.colours.back() = {srgb_decoded(red), srgb_decoded(green), srgb_decoded(blue)};
    }

    /// Adds a texture point: s, optionally followed by t. A value that is not a number, or is beyond 1e9, counts as 0:
    /// it is no reason to refuse a scene.
    void texture_point(std::string_view rest, std::uint32_t line)
    {
        std::array<double, 2> st = {};
        bool sound = true;
        for (double& x : st) {
            const std::string_view word = next_word(rest);
            const std::optional<double> value = word.empty() ? 0.0 : to_number(word);
            sound = sound && value && std::abs(*value) <= largest_coordinate;
            x = sound ? *value : 0.0;
        }
        if (!sound)
            flaws_.add("a texture coordinate is not a number up to 1e9 and counts as 0", line);
        mesh_.texture_points.push_back({st[0], st[1]});
    }

    /// Looks up the numbers of the current material, group and object, which a face is about to use.
    void number_names(std::uint32_t line)
    {
        const auto number = [](auto& numbers, const auto& name, auto& list, const auto& entry) {
            const auto [known, is_new] = numbers.emplace(name, static_cast<std::uint32_t>(list.size()));
            if (is_new)
                list.push_back(entry);
            return known->second;
        };
        const ObjGroup group = group_.empty() || group_ == object_ ? ObjGroup{object_, ""} : ObjGroup{group_, object_};
        next_face_.material = number(material_numbers_, material_, mesh_.materials, ObjName{material_, line});
        next_face_.group = number(group_numbers_, std::pair(group.name, group.other), mesh_.groups, group);
        names_changed_ = false;
    }

    /// Adds a `mtllib` statement unless it is a repetition: some exporters repeat it for every object.
    void library(std::string_view names, const TextLocation& place)
    {
        constexpr std::size_t most_libraries = 256; // limits the search for files that a bad file can cause
        std::vector<ObjName>& known = mesh_.libraries;
        if (std::any_of(known.begin(), known.end(), [&](const ObjName& other) { return other.name == names; }))
            return;
        if (known.size() == most_libraries)
            refuse(place, "more than 256 different `mtllib` statements");
        known.push_back({std::string(names), place.line});
    }

    void check_references()
    {
        for (const ObjFace& face : mesh_.faces) {
            bool has_missing_point = false;
            for (std::uint32_t k = 0; k < face.corner_count; ++k) {
                ObjCorner& corner = mesh_.corners[face.first_corner + k];
                if (corner.vertex >= mesh_.vertices.size())
                    refuse(at_line(face.line), "vertex " + std::to_string(corner.vertex + std::uint64_t{1}) +
                                                   " does not exist, the file has " +
                                                   std::to_string(mesh_.vertices.size()));
                if (corner.point != ObjCorner::none && corner.point >= mesh_.texture_points.size()) {
                    has_missing_point = true;
                    corner.point = ObjCorner::none;
                }
            }
            if (has_missing_point)
                flaws_.add(
                    "a face refers to a texture point that does not exist, so it has the mean colour of its texture",
                    face.line);
        }
    }

    /// Completes the list of colours. White alone changes nothing, and many programs write it.
    void complete_colours()
    {
        const auto is_plain = [](Rgb colour) { return colour == no_colour || colour == Rgb{1.0, 1.0, 1.0}; };
        if (std::all_of(mesh_.colours.begin(), mesh_.colours.end(), is_plain))
            mesh_.colours.clear();
        else
            mesh_.colours.resize(mesh_.vertices.size(), no_colour);
    }

    TextLocation at_line(std::uint32_t line) const { return {mesh_.path, line}; }

    TextLines lines_;
    ObjMesh mesh_;
    std::string material_;
    std::string object_;
    std::string group_;
    bool names_changed_ = true;
    ObjFace next_face_; ///< with the numbers of the current names
    std::unordered_map<std::string, std::uint32_t> material_numbers_;
    std::map<std::pair<std::string, std::string>, std::uint32_t> group_numbers_;
    Flaws flaws_;
};

} // namespace

std::vector<std::string> ObjMesh::material_names() const
{
    return mapped(materials, [](const ObjName& material) { return material.name.empty() ? "default" : material.name; });
}

ObjMesh parse_obj(const std::string& path)
{
    return ObjParser(path).parse();
}

} // namespace multipath

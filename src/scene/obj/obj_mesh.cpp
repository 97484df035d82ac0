// An OBJ file is a list of statements, one per line. `v` adds a vertex, `f` a polygon given by vertex numbers: positive
// ones count from 1, negative ones back from the last vertex read so far. A number may refer to a later vertex, so
// numbers are checked after the whole file is read. `vt` adds a texture point; corners refer to it in the same way, but
// a reference to one that does not exist is ignored. Normals do not matter for diffuse light and are skipped.
//
// `g` divides an object into groups, so a face after `o` and `g` has both names. A new `o` ends the group, unless no
// face came between: then both name the same faces.

#include "scene/obj/obj_mesh.h"

#include "base/text_format.h"
#include "scene/text/text_lines.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace multipath {

namespace {

/// Squares of areas must stay in the range of single precision, in which the exchange between patches is stored.
constexpr double largest_coordinate = 1e9;

/// Free-form surfaces and included files: ignoring them would change the scene.
constexpr std::array<std::string_view, 6> unsupported_keywords = {"surf", "bzp", "bsp", "cdp", "cdc", "call"};

/// Statements that do not affect diffuse surfaces: lines, points and curves have no area.
constexpr std::array<std::string_view, 30> harmless_keywords = {
    "vn",     "vp",     "s",         "l",          "p",     "mg",    "lod",    "bevel", "c_interp", "d_interp",
    "usemap", "maplib", "trace_obj", "shadow_obj", "ctech", "stech", "cstype", "deg",   "bmat",     "step",
    "parm",   "trim",   "hole",      "scrv",       "sp",    "con",   "end",    "curv",  "curv2",    "csh"};

template <std::size_t size>
bool contains(const std::array<std::string_view, size>& words, std::string_view word)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Reference to a texture point that is no number, 0 or counts back too far.
constexpr std::uint32_t no_such_point = ObjMesh::no_point - 1;

/// [1] Colour of a vertex without one.
constexpr Rgb no_colour = {-1.0, -1.0, -1.0};

/// Numbers names in order of appearance.
class NameNumbers
{
public:
    /// The index of a name, and true if the name is new.
    std::pair<std::uint32_t, bool> number_of(const std::string& name)
    {
        const auto [entry, is_new] = numbers_.emplace(name, static_cast<std::uint32_t>(numbers_.size()));
        return {entry->second, is_new};
    }

private:
    std::unordered_map<std::string, std::uint32_t> numbers_;
};

class ObjParser
{
public:
    explicit ObjParser(const std::string& path) : lines_(path)
    {
        mesh_.path = path;
        other_numbers_.number_of("");
    }
    ObjMesh parse();

private:
    void statement(const TextLine& line);
    void named_statement(std::string_view keyword, std::string_view rest, const TextLocation& place);
    void vertex(std::string_view rest, const TextLocation& place);
    void face(std::string_view rest, const TextLine& line);
    std::uint32_t corner(std::string_view word, const TextLocation& place) const;
    void colour(double red, double green, double blue, std::uint32_t line);
    void texture_point(std::string_view rest, std::uint32_t line);
    void note_texture_point(std::string_view corner);
    void number_names(TextLocation place);
    void library(std::string_view names, const TextLocation& place);
    void reserve_vertices();
    void check_corners() const;
    void check_texture_points();
    void complete_colours();
    void drop_comments();
    void summarise_warnings();
    TextLocation at_line(std::uint32_t line) const { return {mesh_.path, line}; }

    TextLines lines_;
    ObjMesh mesh_;
    std::string material_;
    std::string object_;
    std::string group_;
    bool object_is_last_ = true; ///< of the last `o` and `g`
    bool group_is_used_ = false; ///< a face followed the last `g`
    bool names_changed_ = true;
    std::uint32_t material_number_ = 0;
    std::uint32_t group_number_ = 0;
    std::uint32_t other_number_ = 0;
    NameNumbers material_numbers_;
    NameNumbers group_numbers_;
    NameNumbers other_numbers_;
    FlawCount weights_, numbers_after_vertices_, texture_coordinates_, missing_points_;
    IgnoredKeywords unknown_{8};
};

ObjMesh ObjParser::parse()
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
        refuse(at_line(0), mesh_.faces_without_corners == 0
                               ? "no faces found, expected a Wavefront OBJ file with `f` statements"
                               : "every face has fewer than three vertices");
    check_corners();
    check_texture_points();
    complete_colours();
    drop_comments();
    summarise_warnings();
    return std::move(mesh_);
}

void ObjParser::statement(const TextLine& line)
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

void ObjParser::named_statement(std::string_view keyword, std::string_view rest, const TextLocation& place)
{
    if (keyword == "usemtl") {
        material_ = trimmed(rest);
        names_changed_ = true;
    } else if (keyword == "g") {
        group_ = trimmed(rest);
        object_is_last_ = group_is_used_ = false;
        names_changed_ = true;
    } else if (keyword == "o") {
        object_ = trimmed(rest);
        object_is_last_ = names_changed_ = true;
        if (group_is_used_)
            group_.clear();
    } else if (keyword == "mtllib") {
        library(trimmed(rest), place);
    } else if (contains(unsupported_keywords, keyword)) {
        refuse(place, in_quotes(keyword) + " is not supported, expected polygons (`f`)");
    } else if (!contains(harmless_keywords, keyword)) {
        unknown_.note(keyword, place);
    }
}

/// Adds a `mtllib` statement unless it is a repetition: some exporters repeat it for every object.
void ObjParser::library(std::string_view names, const TextLocation& place)
{
    constexpr std::size_t most_libraries = 256; // limits the search for files that a bad file can cause
    std::vector<ObjName>& known = mesh_.libraries;
    if (std::any_of(known.begin(), known.end(), [&](const ObjName& other) { return other.name == names; }))
        return;
    if (known.size() == most_libraries)
        refuse(place, "more than 256 different `mtllib` statements");
    known.push_back({std::string(names), place.line});
}

/// Adds a vertex: x y z, optionally followed by a weight (one number) or a colour (three).
void ObjParser::vertex(std::string_view rest, const TextLocation& place)
{
    std::array<double, 3> x = {};
    for (double& coordinate : x) {
        coordinate = read_number(next_word(rest), place, "vertex");
        if (std::abs(coordinate) > largest_coordinate)
            refuse(place, "coordinate beyond 1e9, expected a scene of sensible size");
    }
    if (mesh_.vertices.size() == std::numeric_limits<std::uint32_t>::max() / 2)
        refuse(place, "more than 2^31 vertices, expected fewer");
    reserve_vertices();
    mesh_.vertices.push_back({x[0], x[1], x[2]});

    std::array<double, 3> more = {};
    std::size_t count = 0;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest), ++count)
        (count < more.size() ? more[count] : x[0]) = read_number(word, place, "vertex");
    if (count == 1 && more[0] != 1.0)
        weights_.add(place.line);
    if (count == 3)
        colour(more[0], more[1], more[2], place.line);
    else if (count > 1)
        numbers_after_vertices_.add(place.line);
}

/// Sets the colour of the vertex added last.
void ObjParser::colour(double red, double green, double blue, std::uint32_t line)
{
    const auto [least, largest] = std::minmax({red, green, blue});
    if (least < 0.0 || largest > 1.0) {
        numbers_after_vertices_.add(line);
        return;
    }
    if (mesh_.colours.capacity() < mesh_.vertices.size())
        mesh_.colours.reserve(mesh_.vertices.capacity());
    mesh_.colours.resize(mesh_.vertices.size(), no_colour);
    mesh_.colours.back() = {srgb_decoded(red), srgb_decoded(green), srgb_decoded(blue)};
}

void ObjParser::face(std::string_view rest, const TextLine& line)
{
    if (names_changed_)
        number_names(line.place);
    const std::size_t first = mesh_.corners.size();
    std::string_view last_word;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
        mesh_.corners.push_back(corner(word, line.place));
        note_texture_point(word);
        last_word = word;
    }
    const std::size_t count = mesh_.corners.size() - first;
    if (!line.ended && (count < 3 || last_word.back() == '/'))
        refuse(line.place, "the file ends in the middle of a face, expected at least three complete corners");
    if (mesh_.corners.size() > std::numeric_limits<std::uint32_t>::max() / 2)
        refuse(line.place, "more than 2^31 corners of faces, expected fewer");
    if (count < 3) {
        mesh_.corners.resize(first);
        if (!mesh_.corner_points.empty())
            mesh_.corner_points.resize(first);
        ++mesh_.faces_without_corners;
        return;
    }
    mesh_.faces.push_back(
        {static_cast<std::uint32_t>(count), line.place.line, material_number_, group_number_, other_number_});
}

/// The vertex index of a corner `v`, `v/vt`, `v//vn` or `v/vt/vn`. A reference to a later vertex is returned unchecked.
std::uint32_t ObjParser::corner(std::string_view word, const TextLocation& place) const
{
    constexpr std::int64_t too_large = std::numeric_limits<std::uint32_t>::max();
    const bool negative = word[0] == '-';
    std::size_t i = negative || word[0] == '+' ? 1 : 0;
    const std::size_t first_digit = i;
    std::int64_t number = 0;
    for (; i < word.size() && word[i] >= '0' && word[i] <= '9'; ++i)
        number = number < too_large ? 10 * number + (word[i] - '0') : number;
    if (i == first_digit || word.find_first_not_of("0123456789/+-", i) != std::string_view::npos ||
        (i < word.size() && word[i] != '/'))
        refuse(place, in_quotes(word) + " is not a corner, expected a vertex number, or `v/vt/vn`");
    if (number == 0)
        refuse(place, "vertex number 0, expected a number from 1, or a negative one that counts back");

    const std::int64_t vertex_count = static_cast<std::int64_t>(mesh_.vertices.size());
    if (negative && number > vertex_count)
        refuse(place, "vertex " + in_quotes(word) + " counts back past the first vertex, " +
                          std::to_string(vertex_count) + " are defined before this line");
    if (number >= too_large)
        refuse(place, "vertex number " + in_quotes(word) + " is too large");
    return static_cast<std::uint32_t>(negative ? vertex_count - number : number - 1);
}

/// Adds a texture point: s, optionally followed by t. A value that is not a number, or is beyond 1e9, counts as 0: it
/// is no reason to refuse a scene.
void ObjParser::texture_point(std::string_view rest, std::uint32_t line)
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
        texture_coordinates_.add(line);
    mesh_.texture_points.push_back({st[0], st[1]});
}

/// Records the texture point of the corner added last: the middle number of `v/vt/vn`.
void ObjParser::note_texture_point(std::string_view corner)
{
    const std::size_t slash = corner.find('/');
    const std::string_view text =
        slash == std::string_view::npos ? "" : corner.substr(slash + 1, corner.find('/', slash + 1) - slash - 1);
    std::int64_t number = 0;
    const bool is_number = std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc();
    const auto count = static_cast<std::int64_t>(mesh_.texture_points.size());
    if (text.empty() && mesh_.corner_points.empty())
        return;
    number = number < 0 ? count + number : number - 1;
    const bool may_exist = is_number && number >= 0 && number < no_such_point;
    mesh_.corner_points.resize(mesh_.corners.size(), ObjMesh::no_point);
    if (!text.empty())
        mesh_.corner_points.back() = may_exist ? static_cast<std::uint32_t>(number) : no_such_point;
}

/// Looks up the indices of the current material, group and object, which a face is about to use.
void ObjParser::number_names(TextLocation place)
{
    names_changed_ = false;
    const auto [material, material_is_new] = material_numbers_.number_of(material_);
    if (material_is_new)
        mesh_.materials.push_back({material_, place.line});
    const auto& [last, other] = object_is_last_ ? std::tie(object_, group_) : std::tie(group_, object_);
    const auto [group, group_is_new] = group_numbers_.number_of(last);
    if (group_is_new)
        mesh_.groups.push_back(last);
    const auto [other_number, other_is_new] = other_numbers_.number_of(other == last ? "" : other);
    if (other_is_new)
        mesh_.other_names.push_back(other);
    material_number_ = material;
    group_number_ = group;
    other_number_ = other_number;
    group_is_used_ = true;
}

/// Reserves memory for the vertices of the whole file when the list is full, extrapolating from the share read so far.
/// Moving millions of vertices repeatedly takes time; reserved memory that stays unused does not.
void ObjParser::reserve_vertices()
{
    constexpr std::size_t some = 4096;
    const auto count = static_cast<double>(mesh_.vertices.size());
    const double read = lines_.share_read();
    if (mesh_.vertices.size() == mesh_.vertices.capacity() && count >= some && read > 0.0 && read < 1.0)
        mesh_.vertices.reserve(static_cast<std::size_t>(std::max(2.0 * count, 1.05 * count / read)));
}

void ObjParser::check_corners() const
{
    std::size_t next = 0;
    for (const ObjFace& face : mesh_.faces)
        for (const std::size_t end = next + face.corner_count; next < end; ++next)
            if (mesh_.corners[next] >= mesh_.vertices.size())
                refuse(at_line(face.line), "vertex " + std::to_string(mesh_.corners[next] + std::uint64_t{1}) +
                                               " does not exist, the file has " +
                                               std::to_string(mesh_.vertices.size()));
}

void ObjParser::check_texture_points()
{
    if (mesh_.corner_points.empty())
        return;
    mesh_.corner_points.resize(mesh_.corners.size(), ObjMesh::no_point);
    auto point = mesh_.corner_points.begin();
    for (const ObjFace& face : mesh_.faces) {
        bool sound = true;
        for (const auto end = point + face.corner_count; point != end; ++point)
            if (*point >= mesh_.texture_points.size()) {
                sound = sound && *point == ObjMesh::no_point;
                *point = ObjMesh::no_point;
            }
        if (!sound)
            missing_points_.add(face.line);
    }
}

/// Completes the list of colours. White alone changes nothing, and many programs write it.
void ObjParser::complete_colours()
{
    const auto is_plain = [](Rgb colour) { return colour == no_colour || colour == Rgb{1.0, 1.0, 1.0}; };
    if (std::all_of(mesh_.colours.begin(), mesh_.colours.end(), is_plain))
        mesh_.colours.clear();
    else
        mesh_.colours.resize(mesh_.vertices.size(), no_colour);
}

/// Drops the comments after the names of groups and objects.
void ObjParser::drop_comments()
{
    std::vector<std::string> names = mesh_.groups;
    names.insert(names.end(), mesh_.other_names.begin(), mesh_.other_names.end());
    names = without_comments(std::move(names));
    const auto end_of_groups = names.begin() + static_cast<std::ptrdiff_t>(mesh_.groups.size());
    mesh_.groups.assign(names.begin(), end_of_groups);
    mesh_.other_names.assign(end_of_groups, names.end());
}

void ObjParser::summarise_warnings()
{
    const auto warn = [&](const FlawCount& lines, const std::string& flaw) {
        if (lines.count != 0)
            mesh_.warnings.push_back(name_of(at_line(lines.first_line)) + ": " + flaw + " (" +
                                     std::to_string(lines.count) + " in the file)");
    };
    warn(weights_, "the weight of a vertex (fourth number) is ignored, polygons have none");
    warn(numbers_after_vertices_,
         "the numbers after the coordinates of a vertex are ignored, expected a weight, or red, "
         "green and blue from 0 to 1");
    warn(texture_coordinates_, "a texture coordinate is not a number up to 1e9 and counts as 0");
    warn(missing_points_, "a face refers to a texture point that does not exist, so it has the mean colour of its "
                          "texture; the file has " +
                              counted(mesh_.texture_points.size(), "texture point"));
    if (const auto warning = unknown_.warning("unknown statements ignored"))
        mesh_.warnings.push_back(*warning);
}

} // namespace

ObjMesh parse_obj(const std::string& path)
{
    return ObjParser(path).parse();
}

} // namespace multipath

// An MTL file is a list of statements, one per line. `newmtl` begins a material; the statements after it describe this
// material. Only Kd, Ke (or Ka) and their textures matter for diffuse light. All other statements are ignored, with a
// warning that names the first 16 keywords; Ka, d and Tr are recorded for other messages.

#include "scene/obj/mtl_reader.h"

#include "scene/text/text_lines.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <unordered_map>

namespace multipath {

namespace {

std::optional<std::string> find_texture(const std::string& mtl_path, const std::string& name);
std::string last_part(const std::string& path);
std::string url_decoded(std::string_view text);

// [W/m^2] Powers and their squares must stay within the range of doubles.
constexpr double largest_emittance = 1e30;
constexpr double smallest_emittance = 1e-30;

bool names_image(std::string_view keyword)
{
    constexpr std::array<std::string_view, 5> others = {"bump", "disp", "decal", "refl", "norm"};
    return keyword.substr(0, 4) == "map_" || std::find(others.begin(), others.end(), keyword) != others.end();
}

class MtlParser
{
public:
    MtlParser(const std::string& path, EmissionFrom emission_from, MaterialLibrary& library)
        : path_(path), emission_from_(emission_from), library_(library), lines_(path)
    {
    }
    void parse()
    {
        TextLine line;
        while (lines_.next(line))
            statement(line);
        if (const auto warning = ignored_.warning("ignored, since only Kd and " + emission_keyword() + " count"))
            library_.warnings.push_back(*warning);
        if (const auto warning = ignored_options_.warning("options of textures that are ignored"))
            library_.warnings.push_back(*warning);
    }

private:
    void statement(const TextLine& line)
    {
        std::string_view rest = line.text;
        const std::string_view keyword = next_word(rest);
        if (keyword.empty() || keyword[0] == '#')
            return;
        if (keyword == "newmtl")
            define(std::string(trimmed(rest)), line.place);
        else if (keyword == "Kd")
            set_reflectance(without_comment(rest), line.place);
        else if (keyword == emission_keyword())
            set_emittance(keyword, without_comment(rest), line.place);
        else if (keyword == "map_Kd" || keyword == "map_kd")
            set_map(keyword, rest, line.place, &MtlMaterial::reflectance_map);
        else if (keyword == "map_Ke" || keyword == "map_ke")
            set_map(keyword, rest, line.place, &MtlMaterial::emission_map);
        else if (keyword == "map_d" || keyword == "map_D")
            set_map(keyword, rest, line.place, &MtlMaterial::opacity_map);
        else
            ignore(keyword, rest, line.place);
        if (keyword == "Ka")
            note_ambient(without_comment(rest));
        if (keyword == "d" || keyword == "Tr")
            note_opacity(keyword, without_comment(rest));
    }

    void ignore(std::string_view keyword, std::string_view rest, TextLocation place)
    {
        ignored_.note(keyword, place);
        std::vector<std::string_view> unused;
        if (names_image(keyword))
            read_map(rest, unused);
    }

    /// Begins a material. A repeated definition replaces the earlier one, at its index.
    void define(const std::string& name, TextLocation place)
    {
        const std::uint32_t next_number = static_cast<std::uint32_t>(library_.materials.size());
        const auto [entry, is_new] = library_.number_of_name.emplace(name, next_number);
        current_ = entry->second;
        has_dissolve_ = false;
        MtlMaterial fresh;
        fresh.material.name = name;
        fresh.material.source = name_of(place);
        if (is_new) {
            library_.materials.push_back(fresh);
            return;
        }
        library_.warnings.push_back(name_of(place) + ": material " + in_quotes(name) + " is defined again (first at " +
                                    library_.materials[*current_].material.source + "), the last definition counts");
        library_.materials[*current_] = fresh;
    }

    void set_reflectance(std::string_view rest, TextLocation place)
    {
        MtlMaterial& current = current_material("Kd", place);
        const Rgb reflectance = colour("Kd", rest, place);
        const auto [least, largest] = std::minmax({reflectance.r, reflectance.g, reflectance.b});
        if (least < 0.0)
            refuse(place, subject("Kd") + " is negative, expected 0 to 1");
        current.flaw = largest > 1.0 ? name_of(place) + ": " + subject("Kd") +
                                           " is above 1, it would reflect more light than it receives; expected 0 to 1"
                                     : "";
        note_repetition("Kd", current.kd_line, place);
        current.material.reflectance = reflectance;
        current.kd_line = place.line;
    }

    void set_emittance(std::string_view keyword, std::string_view rest, TextLocation place)
    {
        MtlMaterial& current = current_material(keyword, place);
        Rgb emittance = colour(keyword, rest, place);
        const auto [least, largest] = std::minmax({emittance.r, emittance.g, emittance.b});
        if (least < 0.0 || largest > largest_emittance)
            refuse(place, subject(keyword) + " is " + (least < 0.0 ? "negative" : "above 1e30") +
                              ", expected the emitted power per area");
        note_repetition(keyword, current.emission_line, place);
        current.emission_too_small = false;
        for (double* channel : {&emittance.r, &emittance.g, &emittance.b})
            if (*channel > 0.0 && *channel < smallest_emittance) {
                *channel = 0.0;
                current.emission_too_small = true;
            }
        if (current.emission_too_small)
            library_.warnings.push_back(name_of(place) + ": " + subject(keyword) +
                                        " is below 1e-30, which counts as 0");
        current.material.emittance = emittance;
        current.emission_line = place.line;
    }

    /// Parses three numbers, or a single one for grey.
    Rgb colour(std::string_view keyword, std::string_view rest, TextLocation place) const
    {
        const std::string statement = subject(keyword);
        std::array<double, 3> values = {};
        std::size_t count = 0;
        for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
            if (word == "spectral" || word == "xyz")
                refuse(place, statement + " is given as " + in_quotes(word) + ", expected red, green and blue");
            if (count == values.size())
                refuse(place, statement + " has more than three numbers, expected one or three");
            values[count++] = read_number(word, place, statement);
        }
        if (count != 1 && count != 3)
            refuse(place, statement + " has " + std::to_string(count) + " numbers, expected one or three");
        return count == 1 ? Rgb{values[0], values[0], values[0]} : Rgb{values[0], values[1], values[2]};
    }

    void note_repetition(std::string_view keyword, std::uint32_t first_line, TextLocation place)
    {
        if (first_line != 0)
            library_.warnings.push_back(name_of(place) + ": " + subject(keyword) + " is given again (first in line " +
                                        std::to_string(first_line) + "), the last value counts");
    }

    /// Records Ka. It serves only for a hint if the scene has no light, so errors are ignored.
    void note_ambient(std::string_view rest)
    {
        if (!current_)
            return;
        const double red = to_number(next_word(rest)).value_or(0.0);
        const double green = to_number(next_word(rest)).value_or(red);
        library_.materials[*current_].ambient = {red, green, to_number(next_word(rest)).value_or(red)};
    }

    /// Records `d` or `Tr`. Exporters disagree whether `Tr 1` alone means opaque or invisible, so it is ignored.
    void note_opacity(std::string_view keyword, std::string_view rest)
    {
        std::string_view word = next_word(rest);
        if (word == "-halo")
            word = next_word(rest);
        const std::optional<double> value = to_number(word);
        if (!current_ || !value || !(*value >= 0.0 && *value <= 1.0) ||
            (keyword == "Tr" && (has_dissolve_ || *value == 1.0)))
            return;
        has_dissolve_ = has_dissolve_ || keyword == "d";
        library_.materials[*current_].opacity = keyword == "d" ? *value : 1.0 - *value;
    }

    void set_map(std::string_view keyword, std::string_view rest, TextLocation place, TextureMap MtlMaterial::*map)
    {
        MtlMaterial& current = current_material(keyword, place);
        std::vector<std::string_view> ignored_options;
        TextureMap result = read_map(rest, ignored_options);
        result.line = place.line;
        for (const std::string_view option : ignored_options)
            ignored_options_.note(std::string(keyword) + ' ' + std::string(option), place);
        if (!result.file.empty())
            current.*map = result;
    }

    /// Parses options, each a word that begins with "-" followed by values, and the name of a file, which may contain
    /// blanks. `ignored_options`: those that would change the colours.
    TextureMap read_map(std::string_view rest, std::vector<std::string_view>& ignored_options)
    {
        TextureMap result;
        const auto numbers = [&rest](double& first, double& second) { // up to three; the second and third are optional
            std::array<double*, 3> targets = {&first, &second, nullptr};
            for (double* const target : targets) {
                std::string_view after = rest;
                const std::optional<double> value = to_number(next_word(after));
                if (!value)
                    return;
                if (target)
                    *target = std::abs(*value) <= 1e6 ? *value : 0.0;
                rest = after;
            }
        };
        for (std::string_view after = rest; !after.empty(); after = rest) {
            const std::string_view option = next_word(after);
            if (option.size() < 2 || option[0] != '-')
                break;
            std::string_view value = after;
            const std::string_view word = next_word(value);
            if (option == "-s" || option == "-o" || option == "-t" || option == "-mm") {
                rest = after;
                const std::array<double, 2> identity = {0.0, option == "-mm" ? 1.0 : 0.0};
                std::array<double, 2> unused = identity;
                if (option == "-s")
                    numbers(result.scale_s, result.scale_t);
                else if (option == "-o")
                    numbers(result.offset_s, result.offset_t);
                else
                    numbers(unused[0], unused[1]);
                if (unused != identity)
                    ignored_options.push_back(option);
            } else if (word.empty() || word[0] == '-' || value.empty()) {
                break; // a file name that looks like an option
            } else {
                result.repeats = option == "-clamp" ? word != "on" : result.repeats;
                if (option == "-imfchan" || (option == "-cc" && word != "off"))
                    ignored_options.push_back(option);
                rest = value;
            }
        }
        for (const std::string_view name : {trimmed(rest), name_in(rest)}) { // with and without what may be a comment
            result.file = std::string(name);
            if (result.file.size() > 2 && result.file.front() == '"' && result.file.back() == '"')
                result.file = result.file.substr(1, result.file.size() - 2);
            result.found = result.file.empty() ? "" : texture(result.file);
            if (!result.found.empty())
                break;
        }
        return result;
    }

    /// The path of an image; empty if it is not found. Each name is looked up once, which may list many folders.
    const std::string& texture(const std::string& name)
    {
        const auto [entry, is_new] = textures_.try_emplace(name);
        if (is_new) {
            entry->second = find_texture(path_, name).value_or("");
            const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
            std::string path = name;
            std::replace(path.begin(), path.end(), '\\', '/');
            for (const std::string& spelling : std::set<std::string>{path, url_decoded(path)})
                for (const std::filesystem::path& place : {folder / spelling, folder / last_part(spelling)})
                    library_.texture_files.push_back(place.string());
            if (!entry->second.empty())
                library_.texture_files.push_back(entry->second);
        }
        return entry->second;
    }

    MtlMaterial& current_material(std::string_view keyword, TextLocation place)
    {
        if (!current_)
            refuse(place, std::string(keyword) + " before the first `newmtl`, expected the name of a material first");
        return library_.materials[*current_];
    }

    /// "Kd of material `wood`"
    std::string subject(std::string_view keyword) const
    {
        return std::string(keyword) + " of material " + in_quotes(library_.materials[*current_].material.name);
    }
    std::string emission_keyword() const { return emission_from_ == EmissionFrom::ka ? "Ka" : "Ke"; }

    const std::string path_;
    const EmissionFrom emission_from_;
    MaterialLibrary& library_;
    TextLines lines_;
    std::optional<std::uint32_t> current_;
    bool has_dissolve_ = false;                             ///< the current material has a `d`
    std::unordered_map<std::string, std::string> textures_; ///< paths of the images by name; empty if not found
    IgnoredKeywords ignored_{16};
    IgnoredKeywords ignored_options_{8};
};

} // namespace

void read_mtl(const std::string& path, EmissionFrom emission_from, MaterialLibrary& library)
{
    MtlParser(path, emission_from, library).parse();
}

// "a b.mtl" may mean one file or two, and the format does not say which. The longest sequence of words that names an
// existing file is taken.

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_words = 32;

/// The text with `%` and two hexadecimal digits replaced by the byte that they encode (RFC 3986), unless it is 0.
std::string url_decoded(std::string_view text)
{
    std::string decoded;
    for (; !text.empty(); text.remove_prefix(1)) {
        unsigned byte = 0;
        const char* const end = text.data() + 3;
        if (text.size() >= 3 && text[0] == '%' && std::from_chars(text.data() + 1, end, byte, 16).ptr == end &&
            byte != 0)
            text.remove_prefix(2);
        else
            byte = static_cast<unsigned char>(text[0]);
        decoded += static_cast<char>(byte);
    }
    return decoded;
}

/// The entry of a folder with this name, or else with this name in another case: the first of them in order of names,
/// which does not depend on the file system. If there is none, the name may be encoded as in a URL.
std::optional<fs::path> find_entry(const fs::path& folder, const std::string& name)
{
    std::error_code error;
    if (fs::exists(folder / name, error))
        return folder / name;
    std::optional<fs::path> found;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string entry_name = entry->path().filename().string();
        if (equal_but_for_case(entry_name, name) && (!found || entry_name < found->filename().string()))
            found = folder / entry_name;
    }
    if (const std::string plain = url_decoded(name); !found && plain != name)
        return find_entry(folder, plain);
    return found;
}

/// Finds a file relative to a folder, ignoring case. Only regular files count: reading from a pipe could block forever.
std::optional<std::string> find_file(const fs::path& folder, std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    const fs::path relative(name);
    fs::path found = relative.is_absolute() ? relative.root_path() : folder;
    for (const fs::path& part : relative.relative_path()) {
        if (part == "." || part.empty())
            continue;
        const std::optional<fs::path> entry = find_entry(found, part.string());
        if (!entry)
            return std::nullopt;
        found = *entry;
    }
    std::error_code error;
    return fs::is_regular_file(found, error) ? std::optional<std::string>(found.generic_string()) : std::nullopt;
}

std::string last_part(const std::string& path)
{
    return path.substr(path.find_last_of("/\\") + 1);
}

/// Finds a texture by its path relative to the MTL file or, since that path may be of another machine, by its file name
/// alone, beside the MTL file or in a folder with a usual name.
std::optional<std::string> find_texture(const std::string& mtl_path, const std::string& name)
{
    const fs::path folder = fs::path(mtl_path).parent_path();
    const std::string last = last_part(name);
    if (std::optional<std::string> file = find_file(folder, name))
        return file;
    for (const char* subfolder : {"", "textures/", "texture/", "maps/", "map/", "images/", "../textures/", "../maps/"})
        if (std::optional<std::string> file = find_file(folder, subfolder + last))
            return file;
    return std::nullopt;
}

/// A word of an argument, or the text between two quotes: the characters [begin, end) of the argument.
struct NamePart
{
    std::size_t begin = 0;
    std::size_t end = 0;
    bool is_quoted = false;
};

std::vector<NamePart> parts_of(std::string_view names, TextLocation place)
{
    std::vector<NamePart> parts;
    for (std::size_t begin = names.find_first_not_of(" \t"); begin != std::string_view::npos;) {
        if (parts.size() == most_words)
            refuse(place, "more than 32 words in `mtllib`, expected the names of MTL files");
        const char quote = names[begin] == '"' || names[begin] == '\'' ? names[begin] : '\0';
        const std::size_t closing = quote == '\0' ? std::string_view::npos : names.find(quote, begin + 1);
        if (closing != std::string_view::npos)
            parts.push_back({begin + 1, closing, true});
        else
            parts.push_back({begin, std::min(names.find_first_of(" \t", begin), names.size()), false});
        begin = names.find_first_not_of(" \t", parts.back().end + (parts.back().is_quoted ? 1 : 0));
    }
    return parts;
}

std::string text_of(std::string_view names, const NamePart& first, const NamePart& last)
{
    return std::string(names.substr(first.begin, last.end - first.begin));
}

bool is_mtl_name(const std::string& name)
{
    constexpr std::string_view ending = ".mtl";
    return name.size() > ending.size() && equal_but_for_case(name.substr(name.size() - ending.size()), ending);
}

} // namespace

MtlFiles find_mtl_files(std::string_view names, TextLocation place)
{
    const std::vector<NamePart> parts = parts_of(names, place);
    if (parts.empty())
        refuse(place, "`mtllib` without a name, expected the name of an MTL file");
    const fs::path folder = fs::path(std::string(place.path)).parent_path();

    MtlFiles files;
    for (std::size_t first = 0; first < parts.size();) {
        const std::size_t longest = parts[first].is_quoted ? 1 : parts.size() - first;
        std::optional<std::string> file;
        std::size_t length = longest + 1;
        while (!file && --length > 0)
            file = find_file(folder, text_of(names, parts[first], parts[first + length - 1]));
        if (file) {
            files.found.push_back(*file);
        } else {
            const auto begin = parts.begin() + static_cast<std::ptrdiff_t>(first);
            const auto last =
                std::find_if(begin, begin + static_cast<std::ptrdiff_t>(longest) - 1,
                             [&](const NamePart& part) { return is_mtl_name(text_of(names, part, part)); });
            files.missing.push_back(text_of(names, *begin, *last));
            length = static_cast<std::size_t>(last - begin) + 1;
        }
        first += length;
    }
    return files;
}

} // namespace multipath

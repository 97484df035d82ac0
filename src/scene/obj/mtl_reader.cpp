// An MTL file is a list of statements, one per line. `newmtl` begins a material; the statements after it describe this
// material. Only Kd, Ke and their textures matter for diffuse light. All other statements are ignored, with a
// warning that names the first 16 keywords; d is recorded for another message.

#include "scene/obj/mtl_reader.h"

#include "base/file_bytes.h"
#include "base/text_format.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>

namespace multipath {

namespace {

namespace fs = std::filesystem;

// [W/m^2] Powers and their squares must stay within the range of doubles.
constexpr double largest_emittance = 1e30;
constexpr double smallest_emittance = 1e-30;

/// The entry of a folder with this name, or else with this name in another case: the first of them in order of names,
/// which does not depend on the file system.
std::optional<fs::path> find_entry(const fs::path& folder, const std::string& name)
{
    std::error_code error;
    if (fs::exists(folder / path_of(name), error))
        return folder / path_of(name);
    std::optional<fs::path> found;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string entry_name = entry->path().filename().u8string();
        if (equal_but_for_case(entry_name, name) && (!found || entry_name < found->filename().u8string()))
            found = folder / entry->path().filename();
    }
    return found;
}

/// Finds a file relative to a folder, ignoring case. Only regular files count: reading from a pipe could block forever.
std::optional<std::string> find_file(const fs::path& folder, std::string name)
{
    std::replace(name.begin(), name.end(), '\\', '/');
    const fs::path relative = path_of(name);
    fs::path found = relative.is_absolute() ? relative.root_path() : folder;
    for (const fs::path& part : relative.relative_path()) {
        if (part == "." || part.empty())
            continue;
        const std::optional<fs::path> entry = find_entry(found, part.u8string());
        if (!entry)
            return std::nullopt;
        found = *entry;
    }
    std::error_code error;
    return fs::is_regular_file(found, error) ? std::optional<std::string>(found.generic_u8string()) : std::nullopt;
}

/// Finds a texture by its path relative to the MTL file or, since that path may be of another machine, by its file name
/// alone, beside the MTL file or in a folder with a usual name.
std::optional<std::string> find_texture(const std::string& mtl_path, const std::string& name)
{
    const fs::path folder = path_of(mtl_path).parent_path();
    const std::string last = name.substr(name.find_last_of("/\\") + 1);
    if (std::optional<std::string> file = find_file(folder, name))
        return file;
    for (const char* subfolder : {"", "textures/", "texture/", "maps/", "map/", "images/", "../textures/", "../maps/"})
        if (std::optional<std::string> file = find_file(folder, subfolder + last))
            return file;
    return std::nullopt;
}

class MtlParser
{
public:
    MtlParser(const std::string& path, MaterialLibrary& library) : path_(path), library_(library), lines_(path) {}
    void parse()
    {
        TextLine line;
        while (lines_.next(line))
            statement(line);
        for (const std::string& warning : flaws_.warnings(path_))
            library_.warnings.push_back(warning);
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
        else if (keyword == "Ke")
            set_emittance(without_comment(rest), line.place);
        else if (keyword == "map_Kd" || keyword == "map_kd")
            set_map(keyword, rest, line.place, &MtlMaterial::reflectance_map);
        else if (keyword == "map_Ke" || keyword == "map_ke")
            set_map(keyword, rest, line.place, &MtlMaterial::emission_map);
        else if (keyword == "map_d" || keyword == "map_D")
            set_map(keyword, rest, line.place, &MtlMaterial::opacity_map);
        else
            flaws_.add("ignored, since only Kd and Ke count", line.place.line, keyword);
        if (keyword == "d" && current_)
            library_.materials[*current_].opacity = to_number(next_word(rest)).value_or(1.0);
    }

    /// Begins a material. A repeated definition replaces the earlier one, at its index.
    void define(const std::string& name, TextLocation place)
    {
        const std::uint32_t next_number = static_cast<std::uint32_t>(library_.materials.size());
        const auto [entry, is_new] = library_.number_of_name.emplace(name, next_number);
        current_ = entry->second;
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
        const Rgb reflectance = value("Kd", rest, place, std::numeric_limits<double>::infinity(), current.kd_line);
        current.flaw = at_most(reflectance, {1.0, 1.0, 1.0})
                           ? ""
                           : name_of(place) + ": " + subject("Kd") +
                                 " is above 1, it would reflect more light than it receives; expected 0 to 1";
        current.material.reflectance = reflectance;
    }

    void set_emittance(std::string_view rest, TextLocation place)
    {
        MtlMaterial& current = current_material("Ke", place);
        const Rgb emittance = value("Ke", rest, place, largest_emittance, current.emission_line);
        current.material.emittance = by_channel([](double e) { return e < smallest_emittance ? 0.0 : e; }, emittance);
    }

    /// The colour in a statement that may occur once in a material; `line` is that of the earlier one, or 0.
    Rgb value(std::string_view keyword, std::string_view rest, TextLocation place, double most, std::uint32_t& line)
    {
        const Rgb result = colour(keyword, rest, place);
        const auto [least, largest] = std::minmax({result.r, result.g, result.b});
        if (least < 0.0 || largest > most)
            refuse(place, subject(keyword) + (least < 0.0 ? " is negative" : " is above 1e30") + ", expected " +
                              (keyword == "Kd" ? "0 to 1" : "the emitted power per area"));
        if (line != 0)
            library_.warnings.push_back(name_of(place) + ": " + subject(keyword) + " is given again (first in line " +
                                        std::to_string(line) + "), the last value counts");
        line = place.line;
        return result;
    }

    /// Parses three numbers, or a single one for grey.
    Rgb colour(std::string_view keyword, std::string_view rest, TextLocation place) const
    {
        std::vector<double> values;
        for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest))
            values.push_back(read_number(word, place, subject(keyword)));
        if (values.size() != 1 && values.size() != 3)
            refuse(place, subject(keyword) + " has " + counted(values.size(), "number") + ", expected one or three");
        return {values.front(), values[values.size() / 2], values.back()};
    }

    /// The first two of one to three numbers after an option, which leave `rest`; those that lack are `missing`.
    static TexturePoint numbers(std::string_view& rest, double missing)
    {
        std::array<double, 3> values = {missing, missing, missing};
        for (double& value : values) {
            std::string_view after = rest;
            const std::optional<double> number = to_number(next_word(after));
            if (!number)
                break;
            value = std::abs(*number) <= 1e6 ? *number : 0.0;
            rest = after;
        }
        return {values[0], values[1]};
    }

    /// Parses options, each a word that begins with "-" followed by values, and the name of a file, which may contain
    /// blanks. Without a name the statement has no effect.
    void set_map(std::string_view keyword, std::string_view rest, TextLocation place, TextureMap MtlMaterial::*map)
    {
        MtlMaterial& current = current_material(keyword, place);
        TextureMap result;
        result.line = place.line;
        for (std::string_view after = rest;; rest = after) {
            const std::string_view option = next_word(after);
            if (option.size() < 2 || option[0] != '-')
                break;
            if (option == "-s") {
                result.scale = numbers(after, 1.0);
            } else if (option == "-o") {
                result.offset = numbers(after, 0.0);
            } else {
                const std::string_view word = next_word(after);
                const bool is_number = to_number(word).has_value();
                if (word.empty() || (word[0] == '-' && !is_number) || after.empty())
                    break; // a file name that looks like an option
                if (is_number)
                    numbers(after, 0.0); // all those of `-mm` and `-t`
                if (option == "-clamp")
                    result.repeats = word != "on";
                else
                    flaws_.add("options of textures that are ignored", place.line,
                               std::string(keyword) + ' ' + std::string(option));
            }
        }
        result.file = std::string(name_in(rest));
        if (result.file.size() > 2 && result.file.front() == '"' && result.file.back() == '"')
            result.file = result.file.substr(1, result.file.size() - 2);
        if (result.file.empty())
            return;
        result.found = texture(result.file);
        current.*map = result;
    }

    /// The path of an image; empty if it is not found. Each name is looked up once, which may list many folders.
    const std::string& texture(const std::string& name)
    {
        const auto [entry, is_new] = textures_.try_emplace(name);
        if (is_new) {
            entry->second = find_texture(path_, name).value_or("");
            const fs::path folder = path_of(path_).parent_path();
            std::string path = name;
            std::replace(path.begin(), path.end(), '\\', '/');
            for (const fs::path& place : {folder / path_of(path), folder / path_of(path).filename()})
                library_.texture_files.push_back(place.u8string());
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

    const std::string path_;
    MaterialLibrary& library_;
    TextLines lines_;
    std::optional<std::uint32_t> current_;
    std::unordered_map<std::string, std::string> textures_; ///< paths of the images by name; empty if not found
    Flaws flaws_;
};

} // namespace

void read_mtl(const std::string& path, MaterialLibrary& library)
{
    MtlParser(path, library).parse();
}

namespace {

/// The names in the argument of `mtllib`.
std::vector<std::string> mtl_names(std::string_view text, TextLocation place)
{
    constexpr std::size_t most_names = 32; // each may list a folder
    std::vector<std::string> names;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        if (names.size() == most_names)
            refuse(place, "more than 32 names in `mtllib`, expected the names of MTL files");
        const bool is_quote = text[0] == '"' || text[0] == '\'';
        const std::size_t closing = is_quote ? text.find(text[0], 1) : std::string_view::npos;
        std::string_view rest = text;
        if (closing != std::string_view::npos) {
            names.emplace_back(text.substr(1, closing - 1));
            rest.remove_prefix(closing + 1);
        } else {
            while (!ends_in(next_word(rest), ".mtl") && !rest.empty()) {
            }
            names.emplace_back(text.substr(0, text.size() - rest.size()));
        }
        text = rest;
    }
    if (names.empty())
        refuse(place, "`mtllib` without a name, expected the name of an MTL file");
    return names;
}

} // namespace

MtlFiles find_mtl_files(std::string_view names, TextLocation place)
{
    const fs::path folder = path_of(std::string(place.path)).parent_path();
    MtlFiles files;
    for (const std::string& name : mtl_names(names, place)) {
        const std::optional<std::string> file = find_file(folder, name);
        (file ? files.found : files.missing).push_back(file.value_or(name));
    }
    return files;
}

} // namespace multipath

// "a b.mtl" may be one file or two, and the format does not say which: the longest run of words that is a file counts.

#include "scene/mtl_path.h"

#include "scene/text_words.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

namespace multipath {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_words = 32;

char lower_case(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

bool equal_but_for_case(const std::string& a, const std::string& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char c, char d) { return lower_case(c) == lower_case(d); });
}

/// The entry of a folder with this name in any case; of several the first by name, whatever the file system's order.
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
    return found;
}

/// Only regular files: a pipe would wait for ever.
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
    return fs::is_regular_file(found, error) ? std::optional<std::string>(found.string()) : std::nullopt;
}

/// A word of the argument, or all that stands between two quotes; where it lies in the argument.
struct NamePart
{
    std::size_t begin = 0;
    std::size_t end = 0;
    bool is_quoted = false;
};

std::vector<NamePart> parts_of(std::string_view names, TextPlace place)
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

} // namespace

std::vector<std::string> find_mtl_files(std::string_view names, TextPlace place)
{
    const std::vector<NamePart> parts = parts_of(names, place);
    if (parts.empty())
        refuse(place, "`mtllib` without a name, expected the name of an MTL file");
    const fs::path folder = fs::path(std::string(place.path)).parent_path();

    std::vector<std::string> files;
    for (std::size_t first = 0; first < parts.size();) {
        const std::size_t longest = parts[first].is_quoted ? 1 : parts.size() - first;
        std::optional<std::string> file;
        std::size_t length = longest + 1;
        while (!file && --length > 0)
            file = find_file(folder, text_of(names, parts[first], parts[first + length - 1]));
        if (!file)
            refuse(place, "material file " + in_quotes(names.substr(parts[first].begin)) +
                              " not found in the folder `" + (folder.empty() ? "." : folder.string()) +
                              "`, without it no surface emits light");
        files.push_back(*file);
        first += length;
    }
    return files;
}

} // namespace multipath

#include "cli/planned_outputs.h"

#include "cli/choice.h"
#include "cli/part_file.h"
#include "cli/usage_error.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sys/stat.h>

namespace multipath {

namespace {

constexpr std::array<FormatDescription, 10> known_formats = {
    {{OutputFormat::ppm, ".ppm", "picture, binary PPM (P6)"},
     {OutputFormat::pfm, ".pfm", "picture as numbers, W/m^2, not tone-mapped"},
     {OutputFormat::png, ".png", "picture"},
     {OutputFormat::csv, ".csv", "table; of a solved scene one row per patch"},
     {OutputFormat::svg, ".svg", "plot or drawing"},
     {OutputFormat::ply, ".ply", "mesh with the light as colours and as numbers"},
     {OutputFormat::glb, ".glb", "the same, for three.js and Blender"},
     {OutputFormat::obj, ".obj", "the same, for MeshLab"},
     {OutputFormat::html, ".html", "page to walk through the room in a browser"},
     {OutputFormat::state, ".state", "all of the run, to go on, merge or render again"}}};

void refuse_input(const std::string& path, const std::vector<std::string>& inputs)
{
    for (const std::string& input : inputs)
        if (same_file(path, input))
            throw UsageError("--output: '" + path + "' is an input; expected another file");
}

std::string lower_case_extension(const std::string& path)
{
    const std::size_t slash = path.find_last_of('/');
    const std::size_t dot = path.find_last_of('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash))
        return "";
    std::string extension = path.substr(dot);
    for (char& c : extension)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

} // namespace

bool same_file(const std::string& a, const std::string& b)
{
    struct stat status_a = {};
    struct stat status_b = {};
    const auto same = [&] { return status_a.st_dev == status_b.st_dev && status_a.st_ino == status_b.st_ino; };
    if (stat(a.c_str(), &status_a) == 0 && stat(b.c_str(), &status_b) == 0)
        return same();
    // Files that do not exist yet: the same name in the same folder.
    const std::string end_a = follow_links(a);
    const std::string end_b = follow_links(b);
    const auto folder = [](const std::string& path) {
        return path[0] == '/' ? folder_of(path) : "./" + folder_of(path);
    };
    const auto name = [](const std::string& path) { return path.substr(folder_of(path).size()); };
    return !end_a.empty() && !end_b.empty() && name(end_a) == name(end_b) &&
           stat(folder(end_a).c_str(), &status_a) == 0 && stat(folder(end_b).c_str(), &status_b) == 0 && same();
}

const std::array<FormatDescription, 10>& output_formats()
{
    return known_formats;
}

OutputFormat output_format(const std::string& path, const std::vector<OutputFormat>& formats)
{
    if (path == "-")
        return formats.front();
    const std::string extension = lower_case_extension(path);
    std::string known;
    std::vector<std::string> candidates;
    for (const FormatDescription& entry : known_formats) {
        if (std::find(formats.begin(), formats.end(), entry.format) == formats.end())
            continue;
        if (extension == entry.extension)
            return entry.format;
        known += (known.empty() ? "" : ", ") + std::string(entry.extension);
        candidates.emplace_back(entry.extension);
    }
    throw UsageError("--output: '" + path + "' does not end in a known extension; expected one of " + known +
                     did_you_mean(extension, candidates));
}

bool wants_pictures(const std::vector<std::string>& paths)
{
    return paths.empty() || std::any_of(paths.begin(), paths.end(),
                                        [](const std::string& path) { return is_picture(output_format(path)); });
}

std::vector<PlannedOutput> open_outputs(const std::vector<std::string>& paths, const std::vector<std::string>& inputs,
                                        const std::vector<OutputFormat>& formats)
{
    std::vector<OutputFormat> chosen;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        chosen.push_back(output_format(paths[i], formats));
        refuse_input(paths[i], inputs);
        for (std::size_t j = 0; j < i; ++j)
            if (same_file(paths[i], paths[j]))
                throw UsageError("--output: '" + paths[i] + "' is named twice");
    }
    std::vector<PlannedOutput> outputs;
    for (std::size_t i = 0; i < paths.size(); ++i)
        outputs.push_back({chosen[i], OutputFile(paths[i])});
    return outputs;
}

void require_no_input(const std::vector<PlannedOutput>& outputs, const std::vector<std::string>& inputs)
{
    for (const PlannedOutput& output : outputs)
        refuse_input(output.file.name(), inputs);
}

void commit(std::vector<PlannedOutput>& outputs)
{
    for (PlannedOutput& output : outputs)
        output.file.complete();
    for (PlannedOutput& output : outputs)
        output.file.commit();
}

} // namespace multipath

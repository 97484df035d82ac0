#include "cli/files/planned_outputs.h"

#include "cli/files/part_file.h"
#include "cli/options/usage_error.h"

#include <algorithm>
#include <cctype>
#include <sys/stat.h>

namespace multipath {

namespace {

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

std::string_view output_extension(const std::string& path, const std::vector<std::string_view>& extensions)
{
    if (path == "-")
        return extensions.front();
    const std::string extension = lower_case_extension(path);
    for (const std::string_view known : extensions)
        if (extension == known)
            return known;
    throw UsageError("--output: '" + path + "' does not end in a known extension; expected one of " +
                     listed(extensions) + did_you_mean(extension, {extensions.begin(), extensions.end()}));
}

std::vector<PlannedOutput> open_outputs(const std::vector<std::string>& paths, const std::vector<std::string>& inputs,
                                        const std::vector<std::string_view>& extensions)
{
    std::vector<std::string_view> chosen;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        chosen.push_back(output_extension(paths[i], extensions));
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

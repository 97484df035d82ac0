#include "commands/rerun.h"

#include "cli/output_file.h"
#include "cli/provenance.h"
#include "cli/temporary_folder.h"
#include "cli/usage_error.h"
#include "commands/bundled_scenes.h"
#include "commands/commands.h"
#include "export/file_bytes.h"
#include "scene/input_error.h"

#include <algorithm>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>
#include <vector>

namespace multipath {

namespace {

/// While it lives, what is printed on standard output is lost.
class SilentOutput
{
public:
    SilentOutput() : before_(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3))
    {
        std::fflush(stdout);
        const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (before_ >= 0 && nowhere >= 0)
            dup2(nowhere, STDOUT_FILENO);
        if (nowhere >= 0)
            ::close(nowhere);
    }
    ~SilentOutput()
    {
        std::fflush(stdout);
        if (before_ >= 0) {
            dup2(before_, STDOUT_FILENO);
            ::close(before_);
        }
    }
    SilentOutput(const SilentOutput&) = delete;
    SilentOutput& operator=(const SilentOutput&) = delete;

private:
    int before_; ///< -1: standard output is closed
};

bool writes_folder(const CommandTable& table)
{
    return find_option(table, "output")->argument == "FOLDER";
}

/// The one of this name among those that write files; `reproduce` is none of them.
Command command_to_run(const std::string& name, const std::string& path)
{
    std::string known;
    for (const Command& command : commands()) {
        if (find_option(command.table, "output") == nullptr)
            continue;
        if (command.table.name == name)
            return command;
        known += (known.empty() ? "" : ", ") + std::string(command.table.name);
    }
    throw InputError(path + ": expected a multipath command that writes files (" + known + "), got " +
                     quoted_argument(name));
}

/// Refuses what the record would not hold had multipath written it.
void require_as_recorded(const CommandTable& table, const CommandLine& line, const std::string& path)
{
    const auto refuse = [&](std::string_view option) {
        throw InputError(path + ": the command in its record has --" + std::string(option) +
                         ", which multipath does not record");
    };
    if (line.has("help"))
        refuse("help");
    for (const OptionGroup& group : table.groups)
        for (const Option& option : group.options)
            if (!is_recorded(option.name) && line.has(option.name))
                refuse(option.name);
}

const char* extension_of(RecordedFile kind)
{
    switch (kind) {
    case RecordedFile::ppm:
        return ".ppm";
    case RecordedFile::png:
        return ".png";
    case RecordedFile::drawing:
        return ".svg";
    case RecordedFile::report:
    case RecordedFile::page:
        return ".html";
    case RecordedFile::ply:
        return ".ply";
    case RecordedFile::glb:
        return ".glb";
    case RecordedFile::obj:
        return ".obj";
    case RecordedFile::table:
        break;
    }
    return ".csv";
}

/// Options stand before the recorded words, which may end in `--` and operands.
CommandLine line_of(const CommandTable& table, const std::vector<std::string>& recorded, const std::string& output,
                    const std::optional<std::string>& threads)
{
    std::vector<std::string> words = {"--output=" + output};
    if (find_option(table, "quiet") != nullptr)
        words.emplace_back("--quiet");
    if (threads && find_option(table, "threads") != nullptr)
        words.push_back("--threads=" + *threads);
    words.insert(words.end(), recorded.begin(), recorded.end());
    return {table, words};
}

/// Files and folders that the command reads.
bool an_input_is_missing(const CommandLine& line)
{
    std::vector<std::string> inputs;
    for (const std::string& operand : line.operands())
        inputs.push_back(find_scene(operand));
    for (const char* option : {"reference", "scenes"})
        if (line.knows(option) && !line.text(option).empty())
            inputs.push_back(line.text(option));
    return std::any_of(inputs.begin(), inputs.end(),
                       [](const std::string& input) { return access(input.c_str(), F_OK) != 0; });
}

std::string one_line(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return text;
}

void run_silently(const Command& command, const CommandLine& line, const std::string& path)
{
    const SilentOutput silence;
    try {
        const int status = command.run(line);
        if (status != 0)
            throw InputError(path + ": the command in its record has failed");
    } catch (const InputError& error) {
        const std::string hint = "; the paths in the record of " + path + " start where the command was first run";
        throw InputError(one_line(error.what()) + (an_input_is_missing(line) ? hint : ""));
    }
}

} // namespace

std::string run_again(const RecordedCommand& record, const std::string& path, const std::optional<std::string>& threads)
{
    const Command command = command_to_run(record.words.front(), path);
    const CommandTable& table = command.table;
    if (writes_folder(table) != (record.kind == RecordedFile::report))
        throw InputError(path + ": 'multipath " + std::string(table.name) + "' does not write such a file");
    const std::vector<std::string> recorded(record.words.begin() + 1, record.words.end());
    try {
        require_as_recorded(table, CommandLine(table, recorded), path);
        const TemporaryFolder folder;
        const bool report = writes_folder(table);
        const std::string output =
            folder.path() + "/" + (report ? "report" : "new" + std::string(extension_of(record.kind)));
        run_silently(command, line_of(table, recorded, output, threads), path);
        return bytes_of_file(report ? output + "/index.html" : output);
    } catch (const UsageError& error) {
        throw InputError(path + ": the command in its record is refused: " + one_line(error.what()));
    }
}

} // namespace multipath

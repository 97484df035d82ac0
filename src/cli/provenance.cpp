#include "cli/provenance.h"

#include "base/text_format.h"
#include "cli/version.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace multipath {

namespace {

constexpr std::array<std::string_view, 11> without_effect = {"threads",    "output", "quiet",     "cache",
                                                             "progress",   "json",   "verbose",   "state",
                                                             "save-every", "resume", "from-state"};

bool default_holds(const Option& option, const CommandLine& line)
{
    const std::vector<OptionValue>& others = option.default_depends_on;
    return std::all_of(others.begin(), others.end(), [&](const OptionValue& other) {
        return !line.knows(other.option) ||
               line.text(other.option) == (other.value.empty() ? line.default_text(other.option) : other.value);
    });
}

/// The option as words of a command line, after a space; "" if it is not recorded.
std::string words_of(const Option& option, const CommandLine& line)
{
    const std::string name(option.name);
    if (option.argument.empty())
        return line.has(name) ? " --" + name : "";
    if (!line.has(name))
        return line.text(name).empty() || !default_holds(option, line) ? "" : option_text(name, line.text(name));
    std::string text;
    for (const std::string& value : line.all(name))
        if (!value.empty())
            text += option_text(name, value);
    return text;
}

std::string command_text(const CommandTable& table, const CommandLine& line)
{
    const std::vector<std::string>& operands = line.operands();
    const bool like_options =
        std::any_of(operands.begin(), operands.end(), [](const std::string& word) { return word.substr(0, 1) == "-"; });
    std::string options;
    for (const OptionGroup& group : table.groups)
        for (const Option& option : group.options)
            if (is_recorded(option.name))
                options += words_of(option, line);
    std::string words;
    for (const std::string& operand : operands)
        words += " " + shell_word(operand);
    return "multipath " + std::string(table.name) + (like_options ? options + " --" + words : words + options);
}

} // namespace

bool is_recorded(std::string_view option)
{
    return std::find(without_effect.begin(), without_effect.end(), option) == without_effect.end();
}

std::vector<std::string> provenance(const CommandTable& table, const CommandLine& line, const Scene& scene)
{
    std::array<char, 32> hash{};
    std::snprintf(hash.data(), hash.size(), "%016llx", static_cast<unsigned long long>(scene.hash()));
    std::vector<std::string> facts = provenance(table, line);
    facts.push_back("scene: " + std::string(hash.data()));
    if (scene.file().photometric)
        facts.emplace_back("unit: lx");
    return facts;
}

std::vector<std::string> provenance(const CommandTable& table, const CommandLine& line)
{
    std::vector<std::string> facts = {version(), "command: " + command_text(table, line)};
    if (line.knows("seed"))
        facts.push_back("seed: " + line.text("seed"));
    return facts;
}

} // namespace multipath

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

/// A default that is recorded only while another option has its own default, or has `value`. In other cases the option
/// would be refused if it were given, have another meaning or no effect.
struct DependentDefault
{
    std::string_view option;
    std::string_view other;
    std::string_view value{};
};

constexpr std::array<DependentDefault, 10> dependent_defaults = {{{"ratio", "power-per-line"},
                                                                  {"lines", "tolerance"},
                                                                  {"lines", "time"},
                                                                  {"replicates", "tolerance"},
                                                                  {"replicates", "time"},
                                                                  {"adaptive", "tolerance"},
                                                                  {"shading", "show"},
                                                                  {"exposure", "show"},
                                                                  {"tone-map", "show"},
                                                                  {"gather-rays", "shading", "gather"}}};

bool default_holds(const CommandLine& line, std::string_view option)
{
    return std::none_of(dependent_defaults.begin(), dependent_defaults.end(), [&](const DependentDefault& d) {
        if (d.option != option || !line.knows(d.other))
            return false;
        return line.text(d.other) != (d.value.empty() ? line.default_text(d.other) : std::string(d.value));
    });
}

/// The option as words of a command line, after a space; "" if it is not recorded.
std::string words_of(const Option& option, const CommandLine& line)
{
    const std::string name(option.name);
    if (option.argument.empty())
        return line.has(name) ? " --" + name : "";
    if (!line.has(name))
        return line.text(name).empty() || !default_holds(line, name) ? "" : option_text(name, line.text(name));
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

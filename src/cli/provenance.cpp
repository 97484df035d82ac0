#include "cli/provenance.h"

#include "cli/version.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace multipath {

namespace {

constexpr std::array<std::string_view, 6> without_effect = {"threads",  "output", "quiet",
                                                            "progress", "json",   "verbose"};

/// A word as a shell reads it back.
std::string shell_word(const std::string& text)
{
    const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:,^%+=@";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos)
        return text;
    std::string quoted = "'";
    for (const char c : text)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

std::string command_text(const CommandTable& table, const CommandLine& line)
{
    std::string text = "multipath " + std::string(table.name);
    for (const std::string& operand : line.operands())
        text += " " + shell_word(operand);
    for (const OptionGroup& group : table.groups)
        for (const Option& option : group.options) {
            const bool matters =
                std::find(without_effect.begin(), without_effect.end(), option.name) == without_effect.end();
            if (matters && option.argument.empty() && line.has(option.name))
                text += " --" + std::string(option.name);
            if (!matters || option.argument.empty())
                continue;
            const std::vector<std::string> given = line.all(option.name);
            for (const std::string& value : given.empty() ? std::vector{line.text(option.name)} : given)
                if (!value.empty())
                    text += " --" + std::string(option.name) + " " + shell_word(value);
        }
    return text;
}

} // namespace

std::vector<std::string> provenance(const CommandTable& table, const CommandLine& line, const Scene& scene)
{
    std::array<char, 32> hash{};
    std::snprintf(hash.data(), hash.size(), "%016llx", static_cast<unsigned long long>(scene.hash()));
    std::vector<std::string> facts = provenance(table, line);
    facts.push_back("scene: " + std::string(hash.data()));
    return facts;
}

std::vector<std::string> provenance(const CommandTable& table, const CommandLine& line)
{
    return {version(), "command: " + command_text(table, line), "seed: " + line.text("seed")};
}

} // namespace multipath

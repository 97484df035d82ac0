#include "cli/provenance.h"

#include "base/lists.h"
#include "base/text_format.h"
#include "cli/version.h"

#include <algorithm>
#include <array>

namespace multipath {

namespace {

constexpr std::array<std::string_view, 10> without_effect = {"threads", "output", "quiet",      "cache",  "json",
                                                             "verbose", "state",  "save-every", "resume", "from-state"};

std::string command_text(const CommandLine& line, const std::vector<std::string>& left_out)
{
    const std::vector<std::string>& operands = line.operands();
    const bool like_options =
        std::any_of(operands.begin(), operands.end(), [](const std::string& word) { return word.substr(0, 1) == "-"; });
    std::string options;
    for (const Option& option : all_options(line.table().groups))
        for (const std::string& value : line.all(option.name))
            if (is_recorded(option.name) && !is_among(option.name, left_out))
                options += option_text(option.name, value);
    std::string words;
    for (const std::string& operand : operands)
        words += " " + shell_word(operand);
    return "multipath " + std::string(line.table().name) + (like_options ? options + " --" + words : words + options);
}

} // namespace

bool is_recorded(std::string_view option)
{
    return !is_among(option, without_effect);
}

std::vector<std::string> provenance(const CommandLine& line, const Scene& scene,
                                    const std::vector<std::string>& left_out)
{
    std::vector<std::string> facts = provenance(line, left_out);
    facts.push_back(format("scene: %016llx", static_cast<unsigned long long>(scene.hash())));
    if (scene.file().photometric)
        facts.emplace_back("unit: lx");
    return facts;
}

std::vector<std::string> provenance(const CommandLine& line, const std::vector<std::string>& left_out)
{
    std::vector<std::string> facts = {version(), "command: " + command_text(line, left_out)};
    if (line.knows("seed"))
        facts.push_back("seed: " + line.text("seed"));
    return facts;
}

} // namespace multipath

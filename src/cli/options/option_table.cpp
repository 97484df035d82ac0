#include "cli/options/option_table.h"

#include <algorithm>

namespace multipath {

std::string operand_text(const Operand& operand)
{
    const std::string text = std::string(operand.name) + (operand.repeatable ? "..." : "");
    return operand.optional ? "[" + text + "]" : text;
}

OptionGroup without_options(OptionGroup group, const std::vector<std::string>& names)
{
    const auto left_out = [&](const Option& option) {
        return std::find(names.begin(), names.end(), option.name) != names.end();
    };
    group.options.erase(std::remove_if(group.options.begin(), group.options.end(), left_out), group.options.end());
    return group;
}

CommandTable without_options(CommandTable table, const std::vector<std::string>& names)
{
    for (OptionGroup& group : table.groups)
        group = without_options(group, names);
    return table;
}

const Option* find_option(const CommandTable& table, std::string_view name)
{
    for (const OptionGroup& group : table.groups)
        for (const Option& option : group.options)
            if (option.name == name)
                return &option;
    return nullptr;
}

const Option* find_short_option(const CommandTable& table, char short_name)
{
    for (const OptionGroup& group : table.groups)
        for (const Option& option : group.options)
            if (option.short_name == short_name && short_name != 0)
                return &option;
    return nullptr;
}

} // namespace multipath

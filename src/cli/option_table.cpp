#include "cli/option_table.h"

namespace multipath {

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

#include "cli/completion.h"
#include "cli/completion_words.h"
#include "cli/shell_words.h"

namespace multipath {

namespace {

constexpr const char* fish_functions = R"(# fish completion of multipath, written by 'multipath help --completion fish'.

function __multipath_has_no_command
    test (count (commandline -opc)) -eq 1
end

function __multipath_command
    set -l words (commandline -opc)
    test (count $words) -gt 1; and test $words[2] = $argv[1]
end

complete -c multipath -f
complete -c multipath -n __multipath_has_no_command -l help -d 'Print the commands'
complete -c multipath -n __multipath_has_no_command -l version -d 'Print the version'
)";

std::string line_for(const CommandTable& table)
{
    return "complete -c multipath -n '__multipath_command " + std::string(table.name) + "'";
}

/// Whether the option has a value, and where it comes from.
std::string value_words(const Option& option)
{
    if (option.argument.empty())
        return "";
    if (takes_file(option))
        return " -r -F";
    if (takes_folder(option))
        return " -x -a '(__fish_complete_directories)'";
    return option.choices.empty() ? " -x" : " -x -a '" + joined(option.choices, " ") + "'";
}

std::string operand_line(const CommandTable& table)
{
    const Operand& operand = table.operands.back();
    if (!operand.choices.empty())
        return line_for(table) + " -a '" + joined(operand.choices, " ") + "'\n";
    if (operand.extensions.empty())
        return line_for(table) + " -F\n";
    return line_for(table) + " -k -a '(__fish_complete_suffix " + joined(operand.extensions, " ") + ")'\n";
}

} // namespace

std::string fish_completion(const std::vector<CommandTable>& tables)
{
    std::string text = fish_functions;
    for (const CommandTable& table : tables) {
        text += "\ncomplete -c multipath -n __multipath_has_no_command -a " + std::string(table.name) + " -d " +
                shell_word(table.summary) + "\n";
        for (const Option& option : shown_options(table)) {
            text += line_for(table) + (option.short_name != 0 ? std::string(" -s ") + option.short_name : "") + " -l " +
                    std::string(option.name) + value_words(option) + " -d " + shell_word(first_phrase(option.help)) +
                    "\n";
        }
        text += table.operands.empty() ? "" : operand_line(table);
    }
    return text;
}

} // namespace multipath

#include "cli/completion.h"
#include "cli/completion_words.h"
#include "cli/shell_words.h"

namespace multipath {

namespace {

/// "[Where to write]", with the brackets of the text itself escaped.
std::string description(const Option& option)
{
    std::string text;
    for (const char c : first_phrase(option.help))
        text += c == '[' || c == ']' ? std::string("\\") + c : std::string(1, c);
    return "[" + text + "]";
}

/// Brackets only around several: those around one would be read as flags of the pattern.
std::string files_with(const std::vector<std::string_view>& extensions)
{
    if (extensions.empty())
        return "_files";
    const std::string list = joined(extensions, "|");
    return "_files -g \"*" + (extensions.size() == 1 ? list : "(" + list + ")") + "\"";
}

/// What is completed for the value of an option: an action of _arguments.
std::string value_action(const Option& option)
{
    if (takes_file(option))
        return "_files";
    if (takes_folder(option))
        return "_files -/";
    return option.choices.empty() ? " " : "(" + joined(option.choices, " ") + ")";
}

/// '(-m --method)'{-m,--method=}'[How the light is found]:NAME:(local global)'
std::string option_words(const Option& option)
{
    const std::string name = "--" + std::string(option.name);
    const std::string value =
        option.argument.empty() ? "" : ":" + std::string(option.argument) + ":" + value_action(option);
    const std::string rest = description(option) + value;
    const std::string equals = option.argument.empty() ? "" : "=";
    if (option.short_name == 0)
        return shell_word((option.repeatable ? "*" : "") + name + equals + rest);
    const std::string short_name = std::string("-") + option.short_name;
    const std::string apart = option.repeatable ? "'*'" : shell_word("(" + short_name + " " + name + ")");
    return apart + "{" + short_name + "," + name + equals + "}" + shell_word(rest);
}

/// '1:SCENE.obj:_files -g "*.obj"'
std::string operand_words(const Operand& operand, std::size_t number)
{
    const std::string action =
        operand.choices.empty() ? files_with(operand.extensions) : "(" + joined(operand.choices, " ") + ")";
    const std::string place = operand.repeatable ? "*" : std::to_string(number);
    return shell_word(place + (operand.optional ? "::" : ":") + std::string(operand.name) + ":" + action);
}

std::string zsh_case(const CommandTable& table)
{
    std::string text = "(" + std::string(table.name) + ")\n    _arguments -s -S";
    for (const Option& option : shown_options(table))
        text += " \\\n        " + option_words(option);
    for (std::size_t i = 0; i < table.operands.size(); ++i)
        text += " \\\n        " + operand_words(table.operands[i], i + 1);
    return text + "\n    ;;\n";
}

} // namespace

std::string zsh_completion(const std::vector<CommandTable>& tables)
{
    std::string commands;
    std::string cases;
    for (const CommandTable& table : tables) {
        commands += "    " + shell_word(std::string(table.name) + ":" + std::string(table.summary)) + "\n";
        cases += zsh_case(table);
    }
    return "#compdef multipath\n"
           "# zsh completion of multipath, written by 'multipath help --completion zsh'.\n\n"
           "local -a commands=(\n" +
           commands +
           ")\n"
           "if (( CURRENT == 2 )); then\n"
           "    _describe -t commands command commands\n"
           "    _arguments '--help[Print the commands]' '--version[Print the version]'\n"
           "    return\n"
           "fi\n"
           "local command=$words[2]\n"
           "shift words\n"
           "(( CURRENT-- ))\n"
           "case $command in\n" +
           cases + "esac\n";
}

} // namespace multipath

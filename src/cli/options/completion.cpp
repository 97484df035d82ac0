#include "cli/options/completion.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace multipath {

namespace {

// Where '=' separates words, as it does unless COMP_WORDBREAKS says otherwise, --method=reuse arrives as three of them.
constexpr const char* bash_functions = R"(# bash completion of multipath, written by 'multipath help --completion bash'.

_multipath_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$word"); }
_multipath_folders() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$word")
}
_multipath_files() {
    local extension
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(
        compgen -d -- "$word"
        for extension in ${*:-""}; do compgen -f -X "!*$extension" -- "$word"; done
    )
}

_multipath() {
    local word=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD - 1]}
    [[ $word == = ]] && word=
    [[ $option == = ]] && option=${COMP_WORDS[COMP_CWORD - 2]}
    COMPREPLY=()
)";

/// All options of a command that its help shows, and --help.
std::vector<Option> shown_options(const CommandTable& table)
{
    std::vector<Option> options;
    for (const OptionGroup& group : table.groups)
        std::copy_if(group.options.begin(), group.options.end(), std::back_inserter(options),
                     [](const Option& option) { return !option.hidden; });
    options.push_back({"help", 'h', "", "", "Print the help."});
    return options;
}

/// Words with blanks between them.
std::string joined(const std::vector<std::string_view>& words)
{
    std::string text;
    for (const std::string_view word : words)
        text.append(text.empty() ? "" : " ").append(word);
    return text;
}

/// "--output | -o"
std::string names_of(const Option& option)
{
    const std::string name = "--" + std::string(option.name);
    return option.short_name == 0 ? name : name + " | -" + option.short_name;
}

std::string value_case(const Option& option)
{
    const std::string action = option.argument == "FILE"     ? "_multipath_files; "
                               : option.argument == "FOLDER" ? "_multipath_folders; "
                               : option.choices.empty()      ? ""
                                                             : "_multipath_words '" + joined(option.choices) + "'; ";
    return "        " + names_of(option) + ") " + action + "return ;;\n";
}

std::string command_case(const CommandTable& table)
{
    std::string values;
    std::string names;
    for (const Option& option : shown_options(table)) {
        values += option.argument.empty() ? "" : value_case(option);
        names += (names.empty() ? "--" : " --") + std::string(option.name);
    }
    const std::string options = "_multipath_words '" + names + "'";
    std::string operand = options;
    if (!table.operands.empty()) {
        const Operand& last = table.operands.back();
        operand = last.choices.empty() ? "_multipath_files " + joined(last.extensions)
                                       : "_multipath_words '" + joined(last.choices) + "'";
    }
    return "    " + std::string(table.name) + ")\n        case $option in\n" + values +
           "        esac\n        case $word in\n        -*) " + options + " ;;\n        *) " + operand +
           " ;;\n        esac ;;\n";
}

} // namespace

std::string bash_completion(const std::vector<CommandTable>& tables)
{
    std::string commands;
    std::string cases;
    for (const CommandTable& table : tables) {
        commands += std::string(table.name) + " ";
        cases += command_case(table);
    }
    return std::string(bash_functions) + "    if ((COMP_CWORD == 1)); then\n        _multipath_words '" + commands +
           "--help --version'\n        return\n    fi\n    case ${COMP_WORDS[1]} in\n" + cases +
           "    esac\n}\n\ncomplete -F _multipath multipath\n";
}

} // namespace multipath

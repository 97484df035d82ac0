#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// One option of a command. Views refer to string literals and tables of constants.
struct Option
{
    std::string_view name;                      ///< long form without the dashes
    char short_name = 0;                        ///< 0: long form only
    std::string_view argument = {};             ///< what the help calls the value, such as FILE; empty: a flag
    std::string_view default_text = {};         ///< value when not given; empty: none
    std::string help = {};                      ///< wrapped by help_text(), which adds choices and default in brackets
    bool repeatable = false;                    ///< may be given more than once
    std::vector<std::string_view> choices = {}; ///< allowed values; empty: any text
    bool hidden = false;                        ///< not in the help: for the program's own tests
};

struct OptionGroup
{
    std::string_view heading; ///< "Budget"
    std::vector<Option> options;
};

/// An argument that is not an option. Only the last one may be repeatable (one or more) or optional.
struct Operand
{
    std::string_view name; ///< "SCENE.obj"
    bool repeatable = false;
    bool optional = false;
    std::vector<std::string_view> extensions = {}; ///< of the files that completion offers, ".obj"; empty: any file
    std::vector<std::string_view> choices = {};    ///< allowed words, when it is no file; empty: any text
};

/// Everything the parser, the help, the man page and the completion know about one command.
/// `--help` and `-h` belong to every command and are not listed.
struct CommandTable
{
    std::string_view name;    ///< "solve"
    std::string_view summary; ///< one line for the list of commands, without a full stop
    std::vector<Operand> operands;
    std::vector<OptionGroup> groups;
    std::string_view notes = {}; ///< examples and remarks below the options, printed as they are
};

/// As the usage shows it: "SCENE.obj", "STATE...", "[SCENE.obj]".
std::string operand_text(const Operand& operand);

/// The table, or the group, without the options of these long names.
CommandTable without_options(CommandTable table, const std::vector<std::string>& names);
OptionGroup without_options(OptionGroup group, const std::vector<std::string>& names);

/// The option with this long name, nullptr when the table has none.
const Option* find_option(const CommandTable& table, std::string_view name);

/// The option with this short name, nullptr when the table has none.
const Option* find_short_option(const CommandTable& table, char short_name);

} // namespace multipath

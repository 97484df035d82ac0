#pragma once

#include "base/lists.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The text that the user gave, in single quotes and with '?' for control characters, so that a message stays one line.
std::string quoted_argument(std::string_view text);

/// Throws UsageError "OPTION: expected one of A, B, C, got 'WORD'" unless `word` is among the choices.
void require_choice(std::string_view option, std::string_view word, const std::vector<std::string_view>& choices);

/// The choices of an option that takes any text.
inline const std::vector<std::string_view> any_text = {};

/// One option of a command. The views refer to string literals and tables of constants.
struct Option
{
    std::string_view name;                      ///< long form without the dashes
    char short_name = 0;                        ///< 0: the option has a long form only
    std::string_view argument = {};             ///< name of the value in the help, such as FILE; empty: a flag
    std::string_view default_text = {};         ///< value if the option is not given; empty: no default
    std::string help = {};                      ///< help_text() wraps it and adds choices and default in brackets
    bool repeatable = false;                    ///< true: the option may be given more than once
    std::vector<std::string_view> choices = {}; ///< allowed values; empty: any text
    bool may_change = false;                    ///< true: may differ from the run whose state is resumed
};

struct OptionGroup
{
    std::string_view heading; ///< "Budget"
    std::vector<Option> options;
};

constexpr std::size_t any_number = std::string_view::npos;

/// The arguments of a command that are not options.
struct Operands
{
    std::string_view text = {}; ///< as the usage line shows them: "SCENE.obj", "STATE...", "A [B]"
    std::size_t least = 0;      ///< smallest number of them
    std::size_t most = 0;       ///< largest number; any_number: no limit
};

/// The description of a command from which parser, help and man page are made.
/// `--help` and `-h` belong to every command and are not listed.
struct CommandTable
{
    std::string_view name;    ///< "solve"
    std::string_view summary; ///< one line for the list of commands, without a full stop
    Operands operands;
    std::vector<OptionGroup> groups;
    std::string_view notes = {}; ///< remarks and examples below the options, a line each
};

/// A copy of the table with one more group, of --help.
CommandTable with_help(CommandTable table);

/// A copy of the group without the options of these long names.
OptionGroup without_options(OptionGroup group, const std::vector<std::string>& names);

/// The options of all groups, in order.
std::vector<Option> all_options(const std::vector<OptionGroup>& groups);

/// The option with this long name; nullptr if the table has none.
const Option* find_option(const CommandTable& table, std::string_view name);

/// " --name value", quoted for a shell; " --name=value" if the value begins with "--", and " --name" if it is empty.
std::string option_text(std::string_view name, std::string_view value);

/// A word that an option allows, and the value that it stands for. For an array of such rows, or of any rows with a
/// `name`, names_of() returns the choices of the option, and CommandLine::choice() the row that the user chose.
template <typename Value>
struct NamedValue
{
    std::string_view name;
    Value value;
};

/// The names of all rows, in order.
template <typename Rows>
std::vector<std::string_view> names_of(const Rows& rows)
{
    return mapped(rows, [](const auto& row) -> std::string_view { return row.name; });
}

/// The row with this name. Throws UsageError with the list of names if there is none; the message begins with `option`.
template <typename Rows>
auto row_named(const Rows& rows, std::string_view option, std::string_view name)
{
    require_choice(option, name, names_of(rows));
    return *std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; });
}

/// The name of the first row with this value. One of the rows must have it.
template <typename Rows, typename Value>
std::string name_of(const Rows& rows, Value value)
{
    return std::string(
        std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row.value == value; })->name);
}

/// The arguments after the name of a command, checked against the table of the command.
class CommandLine
{
public:
    /// Reads the arguments that follow the name of the command, GNU style. Throws UsageError. Stops at `--help` or
    /// `-h`: has("help") is true then, and neither the arguments after it nor the operands have been checked.
    CommandLine(const CommandTable& table, const std::vector<std::string>& arguments);

    /// True if the option was given; its default does not count. The command must have the option.
    bool has(std::string_view name) const;

    /// The value given (the last one of a repeatable option), or else the default, or else "". The command must have
    /// the option.
    std::string text(std::string_view name) const;

    /// The row whose name is the value of the option. Throws UsageError if there is no such row.
    template <typename Rows>
    auto choice(std::string_view name, const Rows& rows) const
    {
        return row_named(rows, "--" + std::string(name), text(name));
    }

    const CommandTable& table() const { return table_; } ///< of the command

    /// True if the command has this option.
    bool knows(std::string_view name) const { return find_option(table_, name) != nullptr; }

    /// The default in the table of the command; "" if there is none. The command must have the option.
    std::string default_text(std::string_view name) const;

    /// All values given, in the order of the user. Empty if the option was not given, whatever its default.
    std::vector<std::string> all(std::string_view name) const;

    /// Those of the options that were given, as words of a command line: "--name=value", or "--name" for a flag.
    std::vector<std::string> words(const std::vector<Option>& options) const;

    /// The operands in order. Their number agrees with the table unless has("help").
    const std::vector<std::string>& operands() const { return operands_; }

private:
    /// Records an option with its value: `--name value`, `--name=value`, `-n value`, `-nvalue`. Returns true if the
    /// value was `next`, the argument that follows; null: there is none. A `next` that looks like a long option is
    /// refused: `-o --quiet` more often has its value missing than names such a file, for which one writes
    /// `--output=--quiet`.
    bool read_option(const std::string& argument, const std::string* next);

    CommandTable table_;
    std::map<std::string, std::vector<std::string>, std::less<>> given_; ///< by long name; a flag has the value ""
    std::vector<std::string> operands_;
};

} // namespace multipath

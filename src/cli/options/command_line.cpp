#include "cli/options/command_line.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "cli/options/choices.h"

#include <algorithm>
#include <cassert>

namespace multipath {

namespace {

std::string dashed(const Option& option)
{
    return "--" + std::string(option.name);
}

/// The first option for which the predicate holds; nullptr if there is none.
template <class Predicate>
const Option* first_option(const CommandTable& table, const Predicate& holds)
{
    for (const OptionGroup& group : table.groups)
        for (const Option& option : group.options)
            if (holds(option))
                return &option;
    return nullptr;
}

/// Parses the arguments in one pass into options and operands.
class Reader
{
public:
    Reader(const CommandTable& table, const std::vector<std::string>& arguments) : table_(table), arguments_(arguments)
    {
    }

    void read()
    {
        bool options_ended = false;
        while (next_ < arguments_.size() && !help_wanted()) {
            const std::string& argument = arguments_[next_++];
            if (options_ended || argument.size() < 2 || argument[0] != '-')
                operands.push_back(argument);
            else if (argument == "--")
                options_ended = true;
            else if (argument[1] == '-')
                read_long(argument);
            else
                read_short(argument);
        }
        if (!help_wanted())
            check_operands();
    }

    std::map<std::string, std::vector<std::string>, std::less<>> given;
    std::vector<std::string> operands;

private:
    bool help_wanted() const { return given.count("help") > 0; }

    /// `--name`, `--name value`, `--name=value`
    void read_long(const std::string& argument)
    {
        const std::size_t equals = argument.find('=');
        const std::string name = argument.substr(2, equals == std::string::npos ? equals : equals - 2);
        const Option* option = find_option(table_, name);
        if (option == nullptr)
            refuse_unknown(argument.substr(0, equals));
        else if (option->argument.empty() && equals != std::string::npos)
            throw UsageError(dashed(*option) + " takes no value, got " + quoted_argument(argument.substr(equals + 1)));
        else if (option->argument.empty())
            record(*option, "");
        else
            record(*option, equals == std::string::npos ? next_value(*option) : argument.substr(equals + 1));
    }

    /// `-q`, `-o value`, `-ovalue`, and flags in front of either: `-qo value`
    void read_short(const std::string& argument)
    {
        for (std::size_t i = 1; i < argument.size() && !help_wanted(); ++i) {
            const Option* option = first_option(table_, [&](const Option& o) { return o.short_name == argument[i]; });
            if (option == nullptr) {
                refuse_unknown(i == 1 ? argument : std::string("-") + argument[i]);
            } else if (option->argument.empty()) {
                record(*option, "");
            } else {
                const std::string rest = argument.substr(i + 1);
                if (!rest.empty() && rest[0] == '=')
                    throw UsageError("write " + dashed(*option) + rest + " or -" + option->short_name + " " +
                                     rest.substr(1) + ", not " + argument);
                record(*option, rest.empty() ? next_value(*option) : rest);
                return;
            }
        }
    }

    /// Takes the argument after an option as its value. Throws UsageError for one that looks like a long option:
    /// `-o --quiet` more often has its value missing than names such a file, for which one writes `--output=--quiet`.
    std::string next_value(const Option& option)
    {
        if (next_ == arguments_.size() || arguments_[next_].compare(0, 2, "--") == 0)
            throw UsageError(dashed(option) + " needs a value: " + dashed(option) + " " + std::string(option.argument));
        return arguments_[next_++];
    }

    void record(const Option& option, const std::string& value)
    {
        if (!option.choices.empty())
            require_choice(dashed(option), value, option.choices);
        std::vector<std::string>& values = given[std::string(option.name)];
        if (!values.empty() && !option.repeatable)
            throw UsageError(dashed(option) + " is given twice");
        if (std::find(values.begin(), values.end(), value) != values.end())
            throw UsageError(dashed(option) + ": " + quoted_argument(value) + " is named twice");
        values.push_back(value);
    }

    [[noreturn]] void refuse_unknown(const std::string& typed) const
    {
        std::vector<std::string> names;
        for (const Option& option : all_options(table_.groups))
            names.push_back(dashed(option));
        throw UsageError("unknown option " + quoted_argument(typed) + did_you_mean(typed, names));
    }

    void check_operands() const
    {
        const std::vector<Operand>& wanted = table_.operands;
        const bool last_is_optional = !wanted.empty() && wanted.back().optional;
        if (operands.size() + (last_is_optional ? 1 : 0) < wanted.size())
            throw UsageError("missing " +
                             operands_text({wanted.begin() + std::ptrdiff_t(operands.size()), wanted.end()}));
        if (operands.size() > wanted.size() && (wanted.empty() || !wanted.back().repeatable))
            throw UsageError("unexpected argument " + quoted_argument(operands[wanted.size()]) + ": '" +
                             std::string(table_.name) + "' takes " + (wanted.empty() ? "none" : operands_text(wanted)));
        for (std::size_t i = 0; i < operands.size(); ++i) {
            const Operand& operand = wanted[std::min(i, wanted.size() - 1)];
            if (!operand.choices.empty())
                require_choice(operand.name, operands[i], operand.choices);
        }
    }

    const CommandTable& table_;
    const std::vector<std::string>& arguments_;
    std::size_t next_ = 0;
};

} // namespace

std::string operands_text(const std::vector<Operand>& operands)
{
    std::vector<std::string> texts;
    for (const Operand& operand : operands) {
        const std::string text = std::string(operand.name) + (operand.repeatable ? "..." : "");
        texts.push_back(operand.optional ? "[" + text + "]" : text);
    }
    return join(texts, " ");
}

CommandTable with_help(CommandTable table)
{
    table.groups.push_back({"Help", {{"help", 'h', "", "", "Print this help."}}});
    return table;
}

OptionGroup without_options(OptionGroup group, const std::vector<std::string>& names)
{
    const auto left_out = [&](const Option& option) {
        return std::find(names.begin(), names.end(), option.name) != names.end();
    };
    group.options.erase(std::remove_if(group.options.begin(), group.options.end(), left_out), group.options.end());
    return group;
}

std::vector<Option> all_options(const std::vector<OptionGroup>& groups)
{
    std::vector<Option> options;
    for (const OptionGroup& group : groups)
        options.insert(options.end(), group.options.begin(), group.options.end());
    return options;
}

const Option* find_option(const CommandTable& table, std::string_view name)
{
    return first_option(table, [&](const Option& option) { return option.name == name; });
}

std::string option_text(std::string_view name, std::string_view value)
{
    return " --" + std::string(name) +
           (value.empty() ? "" : (value.substr(0, 2) == "--" ? "=" : " ") + shell_word(value));
}

CommandLine::CommandLine(const CommandTable& table, const std::vector<std::string>& arguments)
    : table_(with_help(table))
{
    Reader reader(table_, arguments);
    reader.read();
    given_ = std::move(reader.given);
    operands_ = std::move(reader.operands);
}

bool CommandLine::has(std::string_view name) const
{
    assert(knows(name));
    return given_.find(name) != given_.end();
}

std::string CommandLine::text(std::string_view name) const
{
    if (has(name))
        return given_.find(name)->second.back();
    const auto settled = settled_.find(name);
    return settled != settled_.end() ? settled->second : default_text(name);
}

std::string CommandLine::default_text(std::string_view name) const
{
    return std::string(find_option(table_, name)->default_text);
}

std::vector<std::string> CommandLine::all(std::string_view name) const
{
    return has(name) ? given_.find(name)->second : std::vector<std::string>();
}

std::vector<std::string> CommandLine::words(const std::vector<Option>& options) const
{
    std::vector<std::string> words;
    for (const Option& option : options)
        for (const std::string& value : all(option.name))
            words.push_back(dashed(option) + (option.argument.empty() ? "" : "=" + value));
    return words;
}

} // namespace multipath

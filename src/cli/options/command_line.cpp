#include "cli/options/command_line.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "cli/options/spelling.h"

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

} // namespace

std::string quoted_argument(std::string_view text)
{
    return "'" + without_controls(text) + "'";
}

void require_choice(std::string_view option, std::string_view word, const std::vector<std::string_view>& choices)
{
    if (is_among(word, choices))
        return;
    throw UsageError(std::string(option) + ": expected one of " + join(choices) + ", got " + quoted_argument(word));
}

CommandTable with_help(CommandTable table)
{
    table.groups.push_back({"Help", {{"help", 'h', "", "", "Print this help."}}});
    return table;
}

OptionGroup without_options(OptionGroup group, const std::vector<std::string>& names)
{
    const auto left_out = [&](const Option& option) { return is_among(option.name, names); };
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
    bool options_ended = false;
    for (std::size_t i = 0; i < arguments.size() && !has("help"); ++i) {
        const std::string& argument = arguments[i];
        if (options_ended || argument.size() < 2 || argument[0] != '-')
            operands_.push_back(argument);
        else if (argument == "--")
            options_ended = true;
        else if (read_option(argument, i + 1 < arguments.size() ? &arguments[i + 1] : nullptr))
            ++i;
    }
    if (has("help"))
        return;
    const Operands& wanted = table_.operands;
    if (operands_.size() < wanted.least)
        throw UsageError("missing " + std::string(wanted.text));
    if (operands_.size() > wanted.most)
        throw UsageError("unexpected argument " + quoted_argument(operands_[wanted.most]) + ": '" +
                         std::string(table_.name) + "' takes " + (wanted.most > 0 ? std::string(wanted.text) : "none"));
}

bool CommandLine::read_option(const std::string& argument, const std::string* next)
{
    const bool is_long = argument[1] == '-';
    const std::string name = argument.substr(0, is_long ? argument.find('=') : 2);
    const Option* option = first_option(
        table_, [&](const Option& o) { return is_long ? dashed(o) == name : o.short_name == name.back(); });
    if (option == nullptr) {
        const std::string typed = is_long ? name : argument;
        throw UsageError("unknown option " + quoted_argument(typed) +
                         did_you_mean(typed, mapped(all_options(table_.groups), dashed)));
    }
    const bool attached = name.size() < argument.size();
    std::string value = attached ? argument.substr(name.size() + (argument[name.size()] == '=' ? 1 : 0)) : "";
    if (attached && option->argument.empty())
        throw UsageError(dashed(*option) + " takes no value, got " + quoted_argument(value));
    const bool takes_next = !attached && !option->argument.empty();
    if (takes_next && (next == nullptr || next->compare(0, 2, "--") == 0))
        throw UsageError(dashed(*option) + " needs a value: " + dashed(*option) + " " + std::string(option->argument));
    if (takes_next)
        value = *next;
    if (!option->choices.empty())
        require_choice(dashed(*option), value, option->choices);
    std::vector<std::string>& values = given_[std::string(option->name)];
    if (!values.empty() && !option->repeatable)
        throw UsageError(dashed(*option) + " is given twice");
    if (is_among(value, values))
        throw UsageError(dashed(*option) + ": " + quoted_argument(value) + " is named twice");
    values.push_back(value);
    return takes_next;
}

bool CommandLine::has(std::string_view name) const
{
    assert(knows(name));
    return given_.find(name) != given_.end();
}

std::string CommandLine::text(std::string_view name) const
{
    return has(name) ? given_.find(name)->second.back() : default_text(name);
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

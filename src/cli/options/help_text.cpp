#include "cli/options/help_text.h"

#include "cli/options/command_line.h"
#include "scene/text/text_format.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::size_t widest_left_column = 30; // longer entries put their help on the next line

std::string left_column(const Option& option)
{
    std::string left = "  ";
    left += option.short_name != 0 ? std::string("-") + option.short_name + ", " : "    ";
    left.append("--").append(option.name);
    if (!option.argument.empty())
        left.append(" ").append(option.argument);
    return left;
}

std::size_t left_width(const std::vector<OptionGroup>& groups)
{
    std::size_t widest = 0;
    for (const OptionGroup& group : groups)
        for (const Option& option : group.options) {
            if (option.hidden)
                continue;
            const std::size_t width = column_count(left_column(option)) + 2;
            widest = width <= widest_left_column ? std::max(widest, width) : widest;
        }
    return widest;
}

} // namespace

std::string wrapped_text(std::string_view text, std::size_t column, std::size_t indent, std::size_t width)
{
    std::string result;
    bool line_empty = true;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, length);
        text.remove_prefix(std::min(length + 1, text.size()));
        if (!line_empty && column + 1 + column_count(word) > width) {
            result.append("\n").append(indent, ' ');
            column = indent;
            line_empty = true;
        }
        result.append(line_empty ? "" : " ").append(word);
        column += (line_empty ? 0 : 1) + column_count(word);
        line_empty = false;
    }
    return result + "\n";
}

std::string two_columns(const std::string& left, std::string_view right, std::size_t indent, std::size_t width)
{
    const std::size_t used = column_count(left);
    const std::string gap = used + 2 > indent ? "\n" + std::string(indent, ' ') : std::string(indent - used, ' ');
    return left + (right.empty() ? "\n" : gap + wrapped_text(right, indent, indent, width));
}

std::string option_help(const Option& option)
{
    std::string facts = option.choices.empty() ? "" : "one of " + listed(option.choices);
    if (!option.default_text.empty())
        facts.append(facts.empty() ? "" : "; ").append("default ").append(option.default_text);
    if (option.repeatable)
        facts.append(facts.empty() ? "" : "; ").append("may be repeated");
    return option.help + (facts.empty() ? "" : " (" + facts + ")");
}

std::string usage_line(const CommandTable& table)
{
    std::string line = "multipath " + std::string(table.name) + " [OPTIONS]";
    for (const Operand& operand : table.operands)
        line.append(" ").append(operand_text(operand));
    return line;
}

std::string help_hint(std::string_view command)
{
    return "try 'multipath " + std::string(command) + (command.empty() ? "" : " ") + "--help'";
}

std::string help_text(const CommandTable& table)
{
    std::vector<OptionGroup> groups = table.groups;
    groups.push_back({"Help", {{"help", 'h', "", "", "print this help"}}});
    const std::size_t indent = left_width(groups);

    std::string text = "usage: " + usage_line(table) + "\n\n" + wrapped_text(table.summary, 0, 0, page_width);
    for (const OptionGroup& group : groups) {
        text.append("\n").append(group.heading).append(":\n");
        for (const Option& option : group.options)
            if (!option.hidden)
                text += two_columns(left_column(option), option_help(option), indent);
    }
    if (!table.notes.empty())
        text.append("\n").append(table.notes).append(table.notes.back() == '\n' ? "" : "\n");
    return text;
}

std::string command_list(const std::vector<CommandTable>& tables)
{
    std::size_t indent = 0;
    for (const CommandTable& table : tables)
        indent = std::max(indent, column_count(table.name) + 4);
    std::string text;
    for (const CommandTable& table : tables)
        text += two_columns("  " + std::string(table.name), table.summary, indent);
    return text;
}

std::string program_help(const std::vector<CommandTable>& tables, const std::vector<HelpTopic>& topics)
{
    return program_summary + "\n\nusage: multipath COMMAND [OPTIONS] ARGUMENTS\n\n" + command_list(tables) +
           "\n'multipath COMMAND --help' explains a command; 'multipath --version' tells the version.\n" +
           wrapped_text("'multipath help TOPIC' explains " + listed(names_of(topics)) + ".", 0, 0, page_width) +
           "For a first picture: multipath solve scenes/5cubes.obj\n";
}

} // namespace multipath

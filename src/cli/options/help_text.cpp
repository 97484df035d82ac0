#include "cli/options/help_text.h"

#include "base/text_format.h"
#include "cli/version.h"

#include <algorithm>
#include <sstream>

namespace multipath {

namespace {

constexpr std::size_t option_indent = 28; ///< [columns] of the help of options

std::string left_column(const Option& option)
{
    std::string left = "  ";
    left += option.short_name != 0 ? std::string("-") + option.short_name + ", " : "    ";
    left.append("--").append(option.name);
    if (!option.argument.empty())
        left.append(" ").append(option.argument);
    return left;
}

/// The help of an option, followed by choices, default and repeatability in brackets: "(one of 4d, 2d; default 4d)".
std::string option_help(const Option& option)
{
    std::vector<std::string> facts;
    if (!option.choices.empty())
        facts.push_back("one of " + join(option.choices));
    if (!option.default_text.empty())
        facts.push_back("default " + std::string(option.default_text));
    if (option.repeatable)
        facts.emplace_back("may be repeated");
    return option.help + (facts.empty() ? "" : " (" + join(facts, "; ") + ")");
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

std::string two_columns(const std::string& left, std::string_view right, std::size_t indent)
{
    const std::size_t used = column_count(left);
    const std::string gap = used + 2 > indent ? "\n" + std::string(indent, ' ') : std::string(indent - used, ' ');
    return left + (right.empty() ? "\n" : gap + wrapped_text(right, indent, indent, page_width));
}

std::string help_text(const CommandTable& table)
{
    std::string text = "usage: multipath " + std::string(table.name) + " [OPTIONS]" +
                       (table.operands.text.empty() ? "" : " ") + std::string(table.operands.text) + "\n\n" +
                       wrapped_text(table.summary, 0, 0, page_width);
    for (const OptionGroup& group : with_help(table).groups) {
        text.append("\n").append(group.heading).append(":\n");
        for (const Option& option : group.options)
            text += two_columns(left_column(option), option_help(option), option_indent);
    }
    std::istringstream notes((table.notes.empty() ? "" : "\n") + std::string(table.notes));
    for (std::string line; std::getline(notes, line);)
        text += wrapped_text(line, 0, 0, page_width);
    return text;
}

std::string program_help(const std::vector<CommandTable>& tables, const std::vector<HelpTopic>& topics)
{
    std::string commands;
    for (const CommandTable& table : tables)
        commands += two_columns("  " + std::string(table.name), table.summary, 12);
    return program_summary + "\n\nusage: multipath COMMAND [OPTIONS] ARGUMENTS\n\n" + commands +
           wrapped_text("\n'multipath COMMAND --help' explains a command, 'multipath --version' prints the version. "
                        "'multipath help TOPIC' explains a topic: " +
                            join(names_of(topics)) + ".",
                        0, 0, page_width) +
           "For a first picture: multipath solve scenes/5cubes.obj\n";
}

namespace {

/// ASCII text escaped for roff, in which a backslash begins a command and a bare hyphen may become a dash, which cannot
/// be pasted into a shell.
std::string escaped(std::string_view text)
{
    std::string result;
    bool line_begins = true;
    for (const char c : text) {
        if (line_begins && (c == '.' || c == '\''))
            result += "\\&"; // a line with such a first character would be a command
        line_begins = c == '\n';
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if (c == '\'')
            result += "\\(aq"; // otherwise it becomes a curved quote
        else
            result += c;
    }
    return result;
}

/// Preformatted lines.
std::string as_it_is(std::string_view text)
{
    return ".nf\n" + escaped(text) + ".fi\n";
}

} // namespace

std::string man_page(const std::vector<CommandTable>& tables, const std::vector<HelpTopic>& topics)
{
    std::string text = ".TH MULTIPATH 1 \"\" \"" + escaped(version()) +
                       "\" \"User Commands\"\n"
                       ".SH NAME\nmultipath \\- diffuse global illumination (radiosity) with global lines\n"
                       ".SH DESCRIPTION\n" +
                       as_it_is(program_help(tables, topics)) + ".SH COMMANDS\n";
    for (const CommandTable& table : tables)
        text += ".SS " + escaped(table.name) + "\n" + as_it_is(help_text(table));
    text += ".SH TOPICS\n";
    for (const HelpTopic& topic : topics)
        text += ".SS " + escaped(topic.name) + "\n" + as_it_is(topic.text);
    return text + ".SH ENVIRONMENT\n.TP\nMULTIPATH_KERNELS\n"
                  "Limits the instruction sets to avx512, avx2, sse2 or plain; the result does not depend on it.\n";
}

} // namespace multipath

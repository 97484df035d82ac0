#include "cli/options/man_page.h"

#include "cli/version.h"

#include <algorithm>

namespace multipath {

namespace {

/// ASCII text as roff prints it: a backslash begins a command, and a bare hyphen may become a dash that cannot be
/// pasted into a shell.
std::string escaped(std::string_view text)
{
    std::string result;
    bool line_begins = true;
    for (const char c : text) {
        if (line_begins && (c == '.' || c == '\''))
            result += "\\&"; // such a line would be a command
        line_begins = c == '\n';
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if (c == '\'')
            result += "\\(aq"; // else a curved quote
        else
            result += c;
    }
    return result;
}

std::string bold(std::string_view text)
{
    return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(std::string_view text)
{
    return "\\fI" + escaped(text) + "\\fR";
}

std::string upper_case(std::string_view text)
{
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return result;
}

/// Lines that stay as they are.
std::string as_it_is(std::string_view text)
{
    const bool ended = !text.empty() && text.back() == '\n';
    return ".PP\n.nf\n" + escaped(text) + (ended ? "" : "\n") + ".fi\n";
}

std::string option_entry(const Option& option)
{
    std::string names = option.short_name != 0 ? bold(std::string("-") + option.short_name) + ", " : "";
    names += bold("--" + std::string(option.name));
    if (!option.argument.empty())
        names += " " + italic(option.argument);
    return ".TP\n" + names + "\n" + escaped(option_help(option)) + "\n";
}

std::string command_section(const CommandTable& table)
{
    std::string text = ".SS " + escaped(table.name) + "\n" + bold("multipath " + std::string(table.name)) + " [" +
                       italic("OPTIONS") + "]";
    for (const Operand& operand : table.operands)
        text += " " + italic(operand_text(operand));
    text += "\n.PP\n" + escaped(table.summary) + "\n";
    for (const OptionGroup& group : table.groups) {
        text += ".PP\n" + bold(std::string(group.heading) + ":") + "\n";
        for (const Option& option : group.options)
            if (!option.hidden)
                text += option_entry(option);
    }
    return text + (table.notes.empty() ? "" : as_it_is(table.notes));
}

} // namespace

std::string man_page(const std::vector<CommandTable>& tables, const std::vector<HelpTopic>& topics)
{
    std::string text = ".TH MULTIPATH 1 \"\" \"" + escaped(version()) +
                       "\" \"User Commands\"\n"
                       ".SH NAME\nmultipath \\- diffuse global illumination (radiosity) with global lines\n"
                       ".SH SYNOPSIS\n" +
                       bold("multipath") + " " + italic("COMMAND") + " [" + italic("OPTIONS") + "] " +
                       italic("ARGUMENTS") + "\n.SH DESCRIPTION\n" + escaped(program_summary) +
                       "\nFor a first picture:" + as_it_is("  multipath solve scenes/5cubes.obj").insert(0, "\n") +
                       ".SH COMMANDS\n";
    text +=
        "Every command has the option " + bold("--help") + ", or " + bold("-h") + ", which prints what stands here.\n";
    for (const CommandTable& table : tables)
        text += command_section(table);
    for (const HelpTopic& topic : topics)
        text += ".SH " + escaped(upper_case(topic.name)) + "\n" + as_it_is(topic.text);
    return text + ".SH ENVIRONMENT\n.TP\n" + bold("MULTIPATH_KERNELS") +
           "\nLimits the instruction sets to avx512, avx2, sse2 or plain; the result does not depend on it.\n";
}

} // namespace multipath

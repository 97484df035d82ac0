#include "cli/options/help_text.h"

#include "base/text_format.h"
#include "cli/options/command_line.h"
#include "cli/version.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::size_t widest_left_column = 30; // the help of longer entries begins on the next line

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
    for (const Option& option : all_options(groups)) {
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
    std::vector<std::string> facts;
    if (!option.choices.empty())
        facts.push_back("one of " + join(option.choices));
    if (!option.default_text.empty())
        facts.push_back("default " + std::string(option.default_text));
    if (option.repeatable)
        facts.emplace_back("may be repeated");
    return option.help + (facts.empty() ? "" : " (" + join(facts, "; ") + ")");
}

std::string help_hint(std::string_view command)
{
    return "try 'multipath " + std::string(command) + (command.empty() ? "" : " ") + "--help'";
}

std::string help_text(const CommandTable& table)
{
    const std::vector<OptionGroup> groups = with_help(table).groups;
    const std::size_t indent = left_width(groups);
    std::string text = "usage: multipath " + std::string(table.name) + " [OPTIONS]" +
                       (table.operands.empty() ? "" : " ") + operands_text(table.operands) + "\n\n" +
                       wrapped_text(table.summary, 0, 0, page_width);
    for (const OptionGroup& group : groups) {
        text.append("\n").append(group.heading).append(":\n");
        for (const Option& option : group.options)
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
           "\n'multipath COMMAND --help' explains a command; 'multipath --version' prints the version.\n" +
           wrapped_text("'multipath help TOPIC' explains a topic: " + join(names_of(topics)) + ".", 0, 0, page_width) +
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

/// Preformatted lines.
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
        text += " " + italic(operands_text({operand}));
    text += "\n.PP\n" + escaped(table.summary) + "\n";
    for (const OptionGroup& group : table.groups) {
        text += ".PP\n" + bold(std::string(group.heading) + ":") + "\n";
        for (const Option& option : group.options)
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
    text += "Every command has the option " + bold("--help") + ", or " + bold("-h") + ", which prints its help.\n";
    for (const CommandTable& table : tables)
        text += command_section(table);
    for (const HelpTopic& topic : topics)
        text += ".SH " + escaped(upper_case(topic.name)) + "\n" + as_it_is(topic.text);
    return text + ".SH ENVIRONMENT\n.TP\n" + bold("MULTIPATH_KERNELS") +
           "\nLimits the instruction sets to avx512, avx2, sse2 or plain; the result does not depend on it.\n";
}

namespace {

// '=' separates words unless COMP_WORDBREAKS is changed: --method=reuse then arrives as three words.
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

std::string offered(const std::vector<std::string_view>& words)
{
    return "_multipath_words '" + join(words, " ") + "'";
}

std::string value_case(const Option& option)
{
    const std::string action = option.argument == "FILE"     ? "_multipath_files; "
                               : option.argument == "FOLDER" ? "_multipath_folders; "
                               : option.choices.empty()      ? ""
                                                             : offered(option.choices) + "; ";
    const std::string short_form = option.short_name == 0 ? "" : std::string(" | -") + option.short_name;
    return "        --" + std::string(option.name) + short_form + ") " + action + "return ;;\n";
}

std::string command_case(const CommandTable& table)
{
    std::string values;
    std::string names;
    for (const Option& option : all_options(with_help(table).groups)) {
        values += option.argument.empty() ? "" : value_case(option);
        names += (names.empty() ? "--" : " --") + std::string(option.name);
    }
    const std::string options = "_multipath_words '" + names + "'";
    std::string operand = options;
    if (!table.operands.empty()) {
        const Operand& last = table.operands.back();
        operand = last.choices.empty() ? "_multipath_files " + join(last.extensions, " ") : offered(last.choices);
    }
    return "    " + std::string(table.name) + ")\n        case $option in\n" + values +
           "        esac\n        case $word in\n        -*) " + options + " ;;\n        *) " + operand +
           " ;;\n        esac ;;\n";
}

} // namespace

std::string bash_completion(const std::vector<CommandTable>& tables)
{
    std::vector<std::string_view> first_words = names_of(tables);
    first_words.insert(first_words.end(), {"--help", "--version"});
    std::string cases;
    for (const CommandTable& table : tables)
        cases += command_case(table);
    return std::string(bash_functions) + "    if ((COMP_CWORD == 1)); then\n        " + offered(first_words) +
           "\n        return\n    fi\n    case ${COMP_WORDS[1]} in\n" + cases +
           "    esac\n}\n\ncomplete -F _multipath multipath\n";
}

} // namespace multipath

#include "cli/completion.h"
#include "cli/help_text.h"
#include "cli/man_page.h"
#include "cli/standard_streams.h"
#include "cli/usage_error.h"
#include "commands/commands.h"
#include "commands/help_topics.h"

#include <algorithm>

namespace multipath {

namespace {

CommandTable help_table(const std::vector<CommandTable>& others)
{
    CommandTable table = {"help",
                          "a command or a topic in words; the manual and completions for shells",
                          {{"TOPIC", false, true}},
                          {{"For installation",
                            {{"man", 0, "", "", "Print the manual page, for 'man'."},
                             {"completion",
                              0,
                              "SHELL",
                              "",
                              "Print the script that lets a shell complete commands, options, their values and files.",
                              false,
                              {"bash", "zsh", "fish"}}}}},
                          "  multipath help scenes\n"
                          "  multipath help solve\n"
                          "  . <(multipath help --completion bash)\n"};
    for (const CommandTable& other : others)
        table.operands[0].choices.push_back(other.name);
    table.operands[0].choices.push_back(table.name);
    for (const HelpTopic& topic : help_topics())
        table.operands[0].choices.push_back(topic.name);
    return table;
}

std::string completion(const std::string& shell, const std::vector<CommandTable>& tables)
{
    if (shell == "bash")
        return bash_completion(tables);
    return shell == "zsh" ? zsh_completion(tables) : fish_completion(tables);
}

/// The text about a command or topic that exists.
std::string explanation(const std::string& name, const std::vector<CommandTable>& tables,
                        const std::vector<HelpTopic>& topics)
{
    for (const CommandTable& table : tables)
        if (table.name == name)
            return help_text(table);
    return std::find_if(topics.begin(), topics.end(), [&](const HelpTopic& topic) { return topic.name == name; })->text;
}

int run_help(const CommandLine& line)
{
    const std::vector<CommandTable> tables = tables_of(commands());
    const std::vector<HelpTopic> topics = help_topics();
    const bool shell_given = line.has("completion");
    if (line.operands().size() + (line.has("man") ? 1 : 0) + (shell_given ? 1 : 0) > 1)
        throw UsageError("a topic, --man and --completion exclude each other; expected one of them");
    if (line.has("man"))
        print(man_page(tables, topics));
    else if (shell_given)
        print(completion(line.text("completion"), tables));
    else if (line.operands().empty())
        print(program_help(tables, topics));
    else
        print(explanation(line.operands()[0], tables, topics));
    return 0;
}

} // namespace

Command help_command(const std::vector<Command>& others)
{
    return {help_table(tables_of(others)), run_help};
}

} // namespace multipath

#include "commands/commands.h"

#include "cli/options/help_text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

namespace commands_test {

using namespace multipath;

namespace {

/// Every option of every command, with the command's name.
template <class Check>
void for_each_option(Check check)
{
    for (const Command& command : commands())
        for (const OptionGroup& group : command.table.groups)
            for (const Option& option : group.options) {
                INFO(std::string(command.table.name), " --", std::string(option.name));
                check(command.table, option);
            }
}

} // namespace

TEST_CASE("no command has two options of one name, and the help's own names are free")
{
    for (const Command& command : commands()) {
        std::set<std::string> names = {"--help", "-h"};
        for (const OptionGroup& group : command.table.groups)
            for (const Option& option : group.options) {
                CHECK_MESSAGE(names.insert("--" + std::string(option.name)).second, std::string(option.name));
                if (option.short_name != 0)
                    CHECK_MESSAGE(names.insert(std::string("-") + option.short_name).second, std::string(option.name));
            }
    }
}

TEST_CASE("every default is one of its option's choices, and only options with a value have either")
{
    for_each_option([](const CommandTable&, const Option& option) {
        CHECK((!option.argument.empty() || (option.default_text.empty() && option.choices.empty())));
        const bool chosen = std::count(option.choices.begin(), option.choices.end(), option.default_text) == 1;
        CHECK((option.choices.empty() || option.default_text.empty() || chosen));
    });
}

TEST_CASE("every option is explained in its command's help")
{
    for_each_option([](const CommandTable& table, const Option& option) {
        CHECK_FALSE(option.help.empty());
        const std::string left = " --" + std::string(option.name) + (option.argument.empty() ? "" : " ");
        CHECK(help_text(table).find(left + std::string(option.argument)) != std::string::npos);
    });
}

TEST_CASE("topics have names of their own, and their lines are no wider than 80 columns")
{
    std::set<std::string_view> names;
    for (const Command& command : commands())
        names.insert(command.table.name);
    for (const HelpTopic& topic : help_topics()) {
        CHECK_MESSAGE(names.insert(topic.name).second, std::string(topic.name));
        std::istringstream lines(topic.text);
        for (std::string line; std::getline(lines, line);)
            CHECK_MESSAGE(line.size() <= 80, line);
        CHECK(topic.text.back() == '\n');
    }
}

TEST_CASE("everything that is printed as it is holds ASCII only, so that it is the same in every locale")
{
    std::string all;
    for (const Command& command : commands())
        all += help_text(command.table);
    for (const HelpTopic& topic : help_topics())
        all += topic.text;
    CHECK(std::all_of(all.begin(), all.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); }));
}

} // namespace commands_test

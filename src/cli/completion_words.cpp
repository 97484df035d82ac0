#include "cli/completion_words.h"

#include <algorithm>
#include <iterator>

namespace multipath {

std::vector<Option> shown_options(const CommandTable& table)
{
    std::vector<Option> options;
    for (const OptionGroup& group : table.groups)
        std::copy_if(group.options.begin(), group.options.end(), std::back_inserter(options),
                     [](const Option& option) { return !option.hidden; });
    options.push_back({"help", 'h', "", "", "Print the help."});
    return options;
}

bool takes_file(const Option& option)
{
    return option.argument == "FILE";
}

bool takes_folder(const Option& option)
{
    return option.argument == "FOLDER";
}

std::string_view first_phrase(std::string_view help)
{
    std::size_t end = help.size();
    for (const char* mark : {". ", ": ", "; "})
        end = std::min(end, help.find(mark));
    if (end == help.size() && !help.empty() && help.back() == '.')
        --end;
    return help.substr(0, end);
}

std::string joined(const std::vector<std::string_view>& words, std::string_view separator)
{
    std::string text;
    for (const std::string_view word : words)
        text.append(text.empty() ? "" : separator).append(word);
    return text;
}

} // namespace multipath

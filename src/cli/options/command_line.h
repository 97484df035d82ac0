#pragma once

#include "cli/options/option_table.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The words after the command's name, checked against the command's table.
class CommandLine
{
public:
    /// Reads the arguments that follow the command's name, GNU style. Throws UsageError.
    /// Stops at `--help` or `-h`: then has("help") holds and nothing else has been checked.
    CommandLine(const CommandTable& table, const std::vector<std::string>& arguments);

    /// True if the option (or flag) was given; a default does not count.
    bool has(std::string_view name) const;

    /// The value given, else the default, else "".
    std::string text(std::string_view name) const;

    /// True if the command has such an option; its default text, "" without one.
    bool knows(std::string_view name) const { return find_option(table_, name) != nullptr; }
    std::string default_text(std::string_view name) const;

    /// All values given, in the user's order; empty when there are none, whatever the default.
    std::vector<std::string> all(std::string_view name) const;

    /// Operands in order: as many as the table asks for, unless has("help").
    const std::vector<std::string>& operands() const { return operands_; }

private:
    CommandTable table_;
    std::map<std::string, std::vector<std::string>, std::less<>> given_; ///< by long name; a flag has the value ""
    std::vector<std::string> operands_;
};

} // namespace multipath

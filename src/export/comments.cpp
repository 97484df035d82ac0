#include "export/comments.h"

namespace multipath {

std::string comment_lines(const std::vector<std::string>& comments)
{
    std::string lines;
    for (const std::string& comment : comments)
        lines += "# " + comment + "\n";
    return lines;
}

std::optional<std::string> comment_value(const std::vector<std::string>& comments, std::string_view name)
{
    const std::string start = std::string(name) + ": ";
    for (const std::string& comment : comments)
        if (comment.compare(0, start.size(), start) == 0)
            return comment.substr(start.size());
    return std::nullopt;
}

} // namespace multipath

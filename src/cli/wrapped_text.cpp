#include "cli/wrapped_text.h"

#include "scene/utf8.h"

#include <algorithm>

namespace multipath {

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

} // namespace multipath

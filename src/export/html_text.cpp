#include "export/html_text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace multipath {

std::string html_escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '&'   ? std::string("&amp;")
                  : c == '<' ? std::string("&lt;")
                  : c == '>' ? std::string("&gt;")
                  : c == '"' ? std::string("&quot;")
                             : std::string(1, c);
    return result;
}

std::string html_unescaped(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, char>, 4> entities = {
        {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}}};
    std::string result;
    while (!text.empty()) {
        const auto entity = std::find_if(entities.begin(), entities.end(),
                                         [&](const auto& e) { return text.substr(0, e.first.size()) == e.first; });
        const bool found = entity != entities.end();
        result += found ? entity->second : text[0];
        text.remove_prefix(found ? entity->first.size() : 1);
    }
    return result;
}

std::string html_record_line(const std::string& fact)
{
    return std::string(html_record_begin) + html_escaped(fact) + std::string(html_record_end) + "\n";
}

std::string replaced_between(const std::string& text, std::string_view open, std::string_view close,
                             const std::function<std::string(const std::string& between)>& new_text)
{
    std::string result;
    std::size_t from = 0;
    for (;;) {
        const std::size_t begin = text.find(open, from);
        const std::size_t end = begin == std::string::npos ? begin : text.find(close, begin + open.size());
        if (end == std::string::npos)
            return result + text.substr(from);
        const std::size_t inside = begin + open.size();
        result += text.substr(from, begin - from) + new_text(text.substr(inside, end - inside));
        from = end + close.size();
    }
}

} // namespace multipath

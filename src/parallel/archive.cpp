#include "parallel/archive.h"

#include <algorithm>

namespace multipath {

// One list of bytes, with a zero behind each text.
void Archive::texts(std::string_view name, std::vector<std::string>& texts)
{
    std::string joined;
    for (const std::string& text : texts)
        joined.append(text).push_back('\0');
    growing_list<char>(name, joined);
    texts.clear();
    for (std::size_t begin = 0; begin < joined.size();) {
        const std::size_t end = std::min(joined.find('\0', begin), joined.size());
        texts.push_back(joined.substr(begin, end - begin));
        begin = end + 1;
    }
}

} // namespace multipath

// The page is written as an ordinary web page: page.html names its style sheet and its scripts, each on a line of its
// own. Their text replaces these lines here, and the data replace a comment.

#include "viewer/viewer_page.h"

#include "export/html_text.h"
#include "viewer/room_json.h"

#include <algorithm>
#include <stdexcept>

namespace multipath {

namespace {

struct PageFile
{
    std::string_view name;
    std::string_view text;
};

constexpr PageFile page_files[] = {
#include "viewer/page_files.inc"
};

bool starts_with(std::string_view text, std::string_view start)
{
    return text.substr(0, start.size()) == start;
}

/// What is between the first two quotation marks behind `attribute`.
std::string_view value_of(std::string_view line, std::string_view attribute)
{
    const std::size_t begin = line.find('"', line.find(attribute)) + 1;
    return line.substr(begin, line.find('"', begin) - begin);
}

/// The title, and one line of the head for each part of the record, as a report has them.
std::string head_of(const Scene& scene, const ViewerContent& content)
{
    std::string text = "<title>" + html_escaped(scene.path()) + " - multipath</title>\n";
    for (const std::string& fact : content.record)
        text += html_record_line(fact);
    return text;
}

/// No name in the scene may end the element that holds the data.
std::string room_element(const Scene& scene, const ViewerContent& content)
{
    std::string text = room_data_begin;
    for (const char c : room_json(scene, content))
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text + room_data_end + "\n";
}

} // namespace

std::string viewer_page(const Scene& scene, const ViewerContent& content)
{
    std::string page;
    std::string_view rest = page_file("page.html");
    while (!rest.empty()) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        if (starts_with(line, "<link rel=\"stylesheet\""))
            page += "<style>\n" + std::string(page_file(value_of(line, "href="))) + "</style>\n";
        else if (starts_with(line, "<script src="))
            page += "<script>\n" + std::string(page_file(value_of(line, "src="))) + "</script>\n";
        else if (line == "<!-- head -->")
            page += head_of(scene, content);
        else if (line == "<!-- room -->")
            page += room_element(scene, content);
        else
            page += std::string(line) + "\n";
    }
    return page;
}

std::string_view page_file(std::string_view name)
{
    for (const PageFile& file : page_files)
        if (file.name == name)
            return file.text;
    throw std::logic_error("the program holds no page file " + std::string(name));
}

} // namespace multipath

#include "commands/story_words.h"

#include "scene/text_format.h"

#include <algorithm>

namespace multipath {

namespace {

constexpr std::size_t page_width = 110;
constexpr std::size_t widest_name = 41;

/// Bytes that begin a character.
std::size_t columns(const std::string& text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

/// Cut or filled to a number of columns.
std::string fitted(const std::string& text, std::size_t width)
{
    std::string cut = text;
    if (columns(text) > width) {
        while (columns(cut) > width - 2)
            cut.pop_back();
        cut += "..";
    }
    return cut + std::string(width - std::min(width, columns(cut)), ' ');
}

std::string patch_number(std::uint32_t patch)
{
    return Segment::is_patch(patch) ? std::to_string(patch) : "-";
}

} // namespace

std::string wrapped(const std::string& text, std::size_t first, std::size_t others)
{
    std::string result(first, ' ');
    std::size_t column = first;
    bool line_is_empty = true;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        if (!line_is_empty && column + 1 + columns(word) > page_width) {
            result += "\n" + std::string(others, ' ');
            column = others;
            line_is_empty = true;
        }
        result += (line_is_empty ? "" : " ") + word;
        column += (line_is_empty ? 0 : 1) + columns(word);
        line_is_empty = false;
        begin = end + 1;
    }
    std::replace(result.begin(), result.end(), tied, ' ');
    return result + "\n";
}

std::string colour_text(Rgb c)
{
    const std::string r = format("%.4g", c.r);
    const std::string g = format("%.4g", c.g);
    const std::string b = format("%.4g", c.b);
    return r == g && g == b ? r : "(" + r + "," + tied + g + "," + tied + b + ")";
}

std::string watts(Rgb power)
{
    return colour_text(power) + tied + "W";
}

std::string point_text(Vec3 p)
{
    const auto tidy = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; }; // no "-0.000"
    return format("(%.3f, %.3f, %.3f)", tidy(p.x), tidy(p.y), tidy(p.z));
}

std::string surface_name(const Scene& scene, std::uint32_t surface)
{
    const SceneFile& file = scene.file();
    const std::string& group = file.groups[file.group[surface]];
    return (group.empty() ? file.materials[file.material[surface]].name : group) + " (line " +
           std::to_string(file.line[surface]) + ")";
}

std::string patch_name(const Scene& scene, std::uint32_t patch)
{
    const bool back = scene.two_sided() && patch >= scene.patch_count() / 2;
    return "patch " + std::to_string(patch) + " of " + surface_name(scene, scene.surface_of(patch)) +
           (back ? ", its back" : "");
}

std::string origin_text(const LineOrigin& origin)
{
    return "item " + grouped(origin.item) + " = " +
           format("(%.6f, %.6f, %.6f, %.6f)", origin.numbers[0], origin.numbers[1], origin.numbers[2],
                  origin.numbers[3]);
}

std::string meetings_table(const Scene& scene, const std::vector<Meeting>& meetings)
{
    std::size_t name_width = 7;
    for (const Meeting& meeting : meetings)
        name_width = std::max(name_width, columns(surface_name(scene, meeting.hit.surface)));
    name_width = std::min(name_width, widest_name);
    std::string text = "   no       t  " + fitted("surface", name_width) + "  side   arrives at  leaves  point\n";
    for (std::size_t k = 0; k < meetings.size(); ++k) {
        const Meeting& meeting = meetings[k];
        text += format("  %3zu  %.4f  %s  %-5s  %10s  %6s  %s\n", k + 1, meeting.hit.t,
                       fitted(surface_name(scene, meeting.hit.surface), name_width).c_str(),
                       meeting.hit.front ? "front" : "back", patch_number(meeting.patches.arrives_at).c_str(),
                       patch_number(meeting.patches.leaves).c_str(), point_text(meeting.point).c_str());
    }
    return text;
}

} // namespace multipath

#include "commands/story_words.h"

#include "cli/wrapped_text.h"
#include "scene/text_format.h"
#include "scene/utf8.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

constexpr std::size_t story_width = 110;
constexpr std::size_t widest_name = 41;

/// Cut or filled to a number of columns.
std::string fitted(const std::string& text, std::size_t width)
{
    std::string cut = text;
    if (column_count(text) > width) {
        while (column_count(cut) > width - 2)
            cut.pop_back();
        cut += "..";
    }
    return cut + std::string(width - std::min(width, column_count(cut)), ' ');
}

std::string patch_number(std::uint32_t patch)
{
    return Segment::is_patch(patch) ? std::to_string(patch) : "-";
}

} // namespace

std::string wrapped(const std::string& text, std::size_t first, std::size_t others)
{
    std::string result = std::string(first, ' ') + wrapped_text(text, first, others, story_width);
    std::replace(result.begin(), result.end(), tied, ' ');
    return result;
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
    return "patch " + std::to_string(patch) + " of " + surface_name(scene, scene.surface_of(patch)) +
           (scene.is_front(patch) ? "" : ", its back");
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
        name_width = std::max(name_width, column_count(surface_name(scene, meeting.hit.surface)));
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

#include "radiosity/line_story.h"

#include "scene/input_error.h"

namespace multipath {

Meeting meeting_at(const Scene& scene, const Line& line, const Hit& hit)
{
    return {hit, line.at(hit.t), passage_at(scene, hit)};
}

void require_in_stage(const ToldRange& range, std::uint64_t lines, const char* what)
{
    if (range.first >= lines || range.count > lines - range.first)
        throw SettingsError("this stage has " + std::to_string(lines) + " " + what + ", but number " +
                            std::to_string(range.first + range.count) + " is asked for");
}

} // namespace multipath

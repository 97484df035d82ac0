#include "radiosity/line_story.h"

#include "scene/input_error.h"

namespace multipath {

namespace {

std::uint32_t patch_on(const Scene& scene, const Hit& hit, bool front)
{
    const std::uint32_t patch = scene.patch_at(hit.surface, hit.u, hit.v, front);
    return patch == Scene::no_patch ? Segment::behind : patch;
}

} // namespace

Meeting meeting_at(const Scene& scene, const Line& line, const Hit& hit)
{
    return {hit, line.at(hit.t), patch_on(scene, hit, hit.front), patch_on(scene, hit, !hit.front)};
}

void require_in_stage(const ToldRange& range, std::uint64_t lines, const char* what)
{
    if (range.first >= lines || range.count > lines - range.first)
        throw SettingsError("this stage has " + std::to_string(lines) + " " + what + ", but number " +
                            std::to_string(range.first + range.count) + " is asked for");
}

} // namespace multipath

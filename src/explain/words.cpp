#include "explain/words.h"

#include "base/text_format.h"
#include "scene/scene_file.h"
#include "transport/lines/line_segments.h"

#include <cmath>

namespace multipath {

std::string colour_text(Rgb colour)
{
    const std::string r = format("%.4g", colour.r);
    const std::string g = format("%.4g", colour.g);
    const std::string b = format("%.4g", colour.b);
    return r == g && g == b ? r : "(" + r + ", " + g + ", " + b + ")";
}

std::string watts(Rgb power)
{
    return colour_text(power) + " W";
}

std::string point_text(Vec3 point)
{
    const auto tidy = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; }; // no "-0.000"
    return format("(%.3f, %.3f, %.3f)", tidy(point.x), tidy(point.y), tidy(point.z));
}

std::string counted(std::uint64_t count, const char* one, const char* many)
{
    return grouped(count) + " " + (count == 1 ? one : many);
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

std::string loss(std::uint32_t where)
{
    return where == Segment::behind ? "which is lost: it meets the back of a surface, where no patch is"
                                    : "which is lost: it leaves the scene";
}

std::string destination(const Scene& scene, std::uint32_t to)
{
    return Segment::is_patch(to) ? " to " + patch_name(scene, to) : ", " + loss(to);
}

} // namespace multipath

#include "explain/trace_lines.h"

#include "base/errors.h"
#include "explain/words.h"
#include "transport/lines/local_rays.h"

#include <optional>

namespace multipath {

void require_in_stage(const TracedRange& range, std::uint64_t lines, const char* what)
{
    if (range.first >= lines || range.count > lines - range.first)
        throw SettingsError("this stage has " + std::to_string(lines) + " " + what + ", but number " +
                            std::to_string(range.first + range.count) + " is asked for");
}

void append_ray(const Scene& scene, std::uint32_t from, const Line& ray, std::uint32_t to, TracedLine& line)
{
    constexpr double shown_outside = 0.2; // of the scene's diagonal
    const std::optional<Hit> hit = scene.intersector().closest_hit_from(scene.surface_of(from), ray);
    line.points.push_back(ray.origin);
    line.points.push_back(ray.at(hit ? hit->t : shown_outside * scene.bounds().diagonal()));
    line.joins.push_back(Segment::is_patch(to));
    if (hit)
        line.crossings.push_back({*hit, line.points.back(), passage_at(scene, *hit)});
}

TracedLine traced_ray(const Scene& scene, const LineOrigin& origin, std::uint32_t from, std::uint32_t to,
                      const std::string& more)
{
    TracedLine line;
    line.origin = origin;
    const Line ray = local_line(scene.patch(from), origin.numbers);
    append_ray(scene, from, ray, to, line);
    line.opening = "leaves " + patch_name(scene, from) + " at " + point_text(ray.origin) + " in direction " +
                   point_text(ray.direction) + more;
    return line;
}

Segment segment_after(const TracedLine& line, std::size_t after)
{
    return {after == 0 ? Segment::outside : line.crossings[after - 1].patches.leaves,
            after == line.crossings.size() ? Segment::outside : line.crossings[after].patches.arrives_at};
}

TracedLine through_scene(const Scene& scene, const LineOrigin& origin, const Line& line, Vec3 to,
                         const std::vector<Hit>& hits)
{
    TracedLine traced;
    traced.origin = origin;
    traced.opening = "from " + point_text(line.origin) + " to " + point_text(to);
    traced.points.push_back(line.origin);
    for (const Hit& hit : hits) {
        traced.points.push_back(line.at(hit.t));
        traced.crossings.push_back({hit, traced.points.back(), passage_at(scene, hit)});
    }
    traced.points.push_back(to);
    for (std::size_t after = 0; after <= hits.size(); ++after)
        traced.joins.push_back(segment_after(traced, after).joins_patches());
    return traced;
}

} // namespace multipath

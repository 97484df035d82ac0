#include "commands/explain/trace_drawing.h"

namespace multipath {

namespace {

std::string label(const char* kind, const LineOrigin& origin)
{
    return std::string(kind) + " " + std::to_string(origin.number + 1);
}

/// The hit of a ray, or a point a little farther along one that leaves the scene.
Vec3 end_of(const Scene& scene, const Line& ray, const std::optional<Crossing>& crossing)
{
    constexpr double shown_outside = 0.2; // of the scene's diagonal
    return crossing ? crossing->point : ray.at(shown_outside * scene.bounds().diagonal());
}

} // namespace

std::vector<DrawnLine> drawn_lines(const std::vector<GlobalLine>& lines)
{
    std::vector<DrawnLine> drawn;
    for (const GlobalLine& line : lines) {
        DrawnLine shape{label("line", line.origin), {}, {}};
        Vec3 from = line.from;
        for (const Crossing& crossing : line.crossings) {
            shape.segments.push_back({from, crossing.point, false});
            shape.crossings.push_back(crossing.point);
            from = crossing.point;
        }
        shape.segments.push_back({from, line.to, false});
        for (const TracedSegment& traced : line.segments)
            shape.segments[traced.after].bold = traced.segment.joins_patches();
        drawn.push_back(shape);
    }
    return drawn;
}

namespace {

DrawnLine drawn_ray(const Scene& scene, const LineOrigin& origin, const Line& ray,
                    const std::optional<Crossing>& crossing, std::uint32_t where)
{
    DrawnLine shape{label("ray", origin), {}, {}};
    shape.segments.push_back({ray.origin, end_of(scene, ray, crossing), Segment::is_patch(where)});
    if (crossing)
        shape.crossings.push_back(crossing->point);
    return shape;
}

DrawnLine drawn_path(const Scene& scene, const char* kind, const TracedParticle& path)
{
    DrawnLine shape{label(kind, path.origin), {}, {}};
    for (const TracedStep& traced : path.steps) {
        if (!shape.crossings.empty())
            shape.segments.push_back({shape.crossings.back(), traced.ray.origin, false}); // within a patch
        const Vec3 end = end_of(scene, traced.ray, traced.crossing);
        shape.segments.push_back({traced.ray.origin, end, Segment::is_patch(traced.step.where)});
        if (traced.crossing)
            shape.crossings.push_back(end);
    }
    return shape;
}

} // namespace

std::vector<DrawnLine> drawn_lines(const Scene& scene, const ShotTrace& trace)
{
    std::vector<DrawnLine> drawn;
    for (const ShotRay& ray : trace.rays)
        drawn.push_back(drawn_ray(scene, ray.origin, ray.ray, ray.crossing, ray.where));
    return drawn;
}

std::vector<DrawnLine> drawn_lines(const Scene& scene, const JacobiTrace& trace)
{
    std::vector<DrawnLine> drawn;
    for (const JacobiRay& ray : trace.rays)
        drawn.push_back(drawn_ray(scene, ray.origin, ray.ray, ray.crossing, ray.carried.to));
    return drawn;
}

std::vector<DrawnLine> drawn_lines(const Scene& scene, const ParticleTrace& trace)
{
    std::vector<DrawnLine> drawn;
    for (const TracedParticle& particle : trace.particles)
        drawn.push_back(drawn_path(scene, "particle", particle));
    return drawn;
}

std::vector<DrawnLine> drawn_lines(const Scene& scene, const WalkTrace& trace)
{
    std::vector<DrawnLine> drawn;
    for (const TracedParticle& walk : trace.walks)
        drawn.push_back(drawn_path(scene, "walk", walk));
    return drawn;
}

} // namespace multipath

#include "commands/explain/trace_drawing.h"

namespace multipath {

namespace {

std::string label(const char* kind, const LineOrigin& origin)
{
    return std::string(kind) + " " + std::to_string(origin.number + 1);
}

/// The hit of a ray, or a point a little farther along one that leaves the scene.
Vec3 end_of(const Scene& scene, const Line& ray, const std::optional<Meeting>& meeting)
{
    constexpr double shown_outside = 0.2; // of the scene's diagonal
    return meeting ? meeting->point : ray.at(shown_outside * scene.bounds().diagonal());
}

} // namespace

std::vector<DrawnLine> drawn_lines(const std::vector<GlobalLine>& lines)
{
    std::vector<DrawnLine> drawn;
    for (const GlobalLine& line : lines) {
        DrawnLine shape{label("line", line.origin), {}, {}};
        Vec3 from = line.from;
        for (const Meeting& meeting : line.meetings) {
            shape.stretches.push_back({from, meeting.point, false});
            shape.meetings.push_back(meeting.point);
            from = meeting.point;
        }
        shape.stretches.push_back({from, line.to, false});
        for (const Stretch& stretch : line.stretches)
            shape.stretches[stretch.after].bold = stretch.segment.joins_patches();
        drawn.push_back(shape);
    }
    return drawn;
}

std::vector<DrawnLine> drawn_lines(const Scene& scene, const ShotTrace& trace)
{
    std::vector<DrawnLine> drawn;
    for (const ShotRay& ray : trace.rays) {
        DrawnLine shape{label("ray", ray.origin), {}, {}};
        shape.stretches.push_back({ray.ray.origin, end_of(scene, ray.ray, ray.meeting), Segment::is_patch(ray.where)});
        if (ray.meeting)
            shape.meetings.push_back(ray.meeting->point);
        drawn.push_back(shape);
    }
    return drawn;
}

std::vector<DrawnLine> drawn_lines(const Scene& scene, const ParticleTrace& trace)
{
    std::vector<DrawnLine> drawn;
    for (const ToldParticle& particle : trace.particles) {
        DrawnLine shape{label("particle", particle.origin), {}, {}};
        for (const ToldStep& traced : particle.steps) {
            if (!shape.meetings.empty())
                shape.stretches.push_back({shape.meetings.back(), traced.ray.origin, false}); // within a patch
            const Vec3 end = end_of(scene, traced.ray, traced.meeting);
            shape.stretches.push_back({traced.ray.origin, end, Segment::is_patch(traced.step.where)});
            if (traced.meeting)
                shape.meetings.push_back(end);
        }
        drawn.push_back(shape);
    }
    return drawn;
}

} // namespace multipath
